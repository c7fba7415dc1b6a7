// SPDX-License-Identifier: MIT
#include "tools/checkpoints.h"

#include <cstdio>
#include <filesystem>

#include "core/error.h"
#include "core/scene_hash.h"
#include "io/checkpoint_file.h"
#include "io/whole_file.h"
#include "tools/signature.h"

namespace tress {
namespace {

std::string made_by(const Scene& scene, const Options& options) {
    return "version=" TRESS_VERSION "\nscene=" + hexadecimal(scene_hash(scene)) + "\n" +
           options_text(options, {"time", "threads", "isa", "film.exposure"});
}

}  // namespace

Checkpoints::Checkpoints(const std::string& picture, double seconds, const Scene& scene, const Options& options)
    : path_(std::filesystem::path(picture).replace_extension(".checkpoint").string()),
      made_by_(made_by(scene, options)),
      seconds_(seconds),
      last_(std::chrono::steady_clock::now()),
      used_(seconds > 0) {
    if (seconds > 0) check_writable(path_);
}

bool Checkpoints::resume(RenderState& state) {
    if (!std::filesystem::exists(path_)) return false;
    used_ = true;
    const Checkpoint checkpoint = read_checkpoint(path_, made_by_, state.film);
    state.samples = int(checkpoint.samples);
    state.seconds = checkpoint.seconds;
    auto& clocks = state.clocks->nanoseconds;
    for (size_t i = 0; i < std::min(clocks.size(), checkpoint.stage_nanoseconds.size()); ++i)
        clocks[i] = checkpoint.stage_nanoseconds[i];
    return true;
}

void Checkpoints::after_pass(const RenderState& state) {
    const auto now = std::chrono::steady_clock::now();
    if (seconds_ == 0 || std::chrono::duration<double>(now - last_).count() < seconds_) return;
    write(state);
    last_ = std::chrono::steady_clock::now();
}

void Checkpoints::write(const RenderState& state) {
    if (seconds_ == 0) return;
    const auto& clocks = state.clocks->nanoseconds;
    try {
        write_checkpoint(
            path_,
            {made_by_, uint32_t(state.samples), state.seconds, std::vector<uint64_t>(clocks.begin(), clocks.end())},
            state.film);
        failed_ = false;
    } catch (const InputError& error) {
        if (!failed_) std::fprintf(stderr, "tress: %s; rendering goes on, an older checkpoint is kept\n", error.what());
        failed_ = true;
    }
}

void Checkpoints::remove() const {
    std::error_code ignored;  // one that stays does no harm
    if (used_) std::filesystem::remove(path_, ignored);
}

}  // namespace tress
