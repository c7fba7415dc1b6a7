// SPDX-License-Identifier: MIT
#include "tools/study/methods/reference.h"

#include <filesystem>

#include "io/exr_file.h"
#include "io/whole_file.h"
#include "tools/signature.h"
#include "tools/study/methods/picture_error.h"
#include "tools/study/methods/rendering.h"

namespace tress {
namespace {

constexpr uint64_t kSeedsApart = 0x5eed0000;  // of the halves, from those of rows

Options reference_options(Options options, const TypeSet& types) {
    use_paths(options);
    for (int type = 0; type < kPathTypes; ++type)
        if (!types[size_t(type)]) switch_off(options, PathType(type));
    return options;
}

/// Both halves have as many samples: as many as the first has after half the time.
Json make_halves(const StudyScene& scene, const Options& options, double seconds, const std::string& a,
                 const std::string& b) {
    const uint64_t seed = scene.options.seed + kSeedsApart;
    const Json first = render(scene, options, {.seed = seed, .seconds = seconds / 2}, a);
    const int spp = first["spp"];
    const Json second = render(scene, options, {.seed = seed + 1, .samples = spp}, b);
    const auto total = [](const Json& stats) { return stats["seconds"]["total"].get<double>(); };
    return {{"spp", 2 * spp}, {"seconds", total(first) + total(second)}};
}

}  // namespace

TypeSet types_on(const Options& o) {
    return {o.type1 != LampMethod::off, o.type2 != GatherMethod::off, o.type3 != CrossingMethod::off,
            o.type4 != ScatteredMethod::off, o.type5 != ScatteredMethod::off};
}

Reference make_reference(const StudyScene& scene, const TypeSet& types, double seconds, const std::string& folder,
                         const std::string& work) {
    const Options options = reference_options(scene.options, types);
    const std::string key = key_of({"reference", TRESS_VERSION, scene.signature, std::to_string(seconds),
                                    options_text(options, {"time", "spp", "threads", "isa"})});
    const std::string stem = (std::filesystem::path(folder) / key).string();
    const std::string picture = stem + ".exr", figures = stem + ".json";
    const std::string a = work + "/half-a.exr", b = work + "/half-b.exr";
    if (std::filesystem::exists(picture) && std::filesystem::exists(figures))
        return {read_exr(picture), picture, read_json(figures)};
    std::filesystem::create_directories(folder);
    Json line{{"line", "reference"}, {"key", key}};
    line.update(make_halves(scene, options, seconds, a, b));
    const LayeredImage first = read_exr(a), second = read_exr(b);
    line["errors"] = error_of_mean(first, second);
    const LayeredImage mean = mean_of(first, second);
    write_exr(picture, mean);
    write_text_file(figures, line.dump(2) + "\n");  // last: it says that the picture is whole
    return {mean, picture, line};
}

}  // namespace tress
