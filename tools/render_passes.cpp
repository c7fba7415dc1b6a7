// SPDX-License-Identifier: MIT
#include "tools/render_passes.h"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "tools/interrupt.h"
#include "tools/progress.h"

namespace tress {
namespace {

constexpr int kPasses = 50, kLongestPass = 8;  // progress shows at least this often; more samples a pass help caches

/// Samples of the next pass: no more than there were before, so that powers of two are met, and a short time is kept.
int next_pass(const RenderState& state, const Options& options, double seconds_a_pass) {
    const int longest = int(std::bit_floor(unsigned(std::clamp(options.spp / kPasses, 1, kLongestPass))));
    int samples = std::min({longest, std::max(state.samples, 1), options.spp - state.samples});
    if (seconds_a_pass > 0 && state.samples > 0) {
        const double in_time = seconds_a_pass * state.samples / std::max(state.seconds, 1e-9);
        samples = int(std::clamp(in_time, 1.0, double(samples)));
    }
    return samples;
}

}  // namespace

int render_passes(RenderState& state, const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                  const Options& options, const PassLimits& limits, const std::function<void()>& after_pass) {
    Progress progress("render", limits.quiet);
    const Interrupt interrupt;
    const auto in_time = [&] { return options.time == 0 || state.seconds < options.time || state.samples == 0; };
    while (state.samples < options.spp && in_time() && !interrupt.signal()) {
        advance(state, scene, prepared, plan, options, next_pass(state, options, limits.seconds_a_pass));
        after_pass();
        const double by_samples = double(state.samples) / options.spp;
        const double by_time = options.time > 0 ? state.seconds / options.time : 0;
        progress.update(std::max(by_samples, by_time), std::to_string(state.samples) + " spp");
    }
    char note[80];
    std::snprintf(note, sizeof note, "%d spp in %.2f s", state.samples, state.seconds);
    progress.finish(note);
    return interrupt.signal();
}

}  // namespace tress
