// SPDX-License-Identifier: MIT
#include "tools/study/study_run.h"

#include <filesystem>

#include "io/exr_file.h"
#include "tools/study/picture_error.h"
#include "tools/study/rendering.h"

namespace tress {

std::string run_key(const StudyScene& scene, const StudyRow& row, const RunJob& job, const Reference& reference) {
    const Options options = options_of(row, scene.options);
    return key_of({"run", TRESS_VERSION, scene.signature, scene.processor, scene.isa, std::to_string(scene.threads),
                   scene.program, reference.line["key"], options_text(options, {"time", "spp", "seed", "threads"}),
                   std::to_string(job.seed), std::to_string(job.seconds), std::to_string(job.samples)});
}

Json run_row(const StudyScene& scene, const StudyRow& row, const RunJob& job, const Reference& reference,
             const std::string& folder) {
    const std::string key = run_key(scene, row, job, reference);
    const std::filesystem::path pictures = std::filesystem::path(folder) / "pictures";
    std::filesystem::create_directories(pictures);
    const std::string picture = (pictures / (key + ".exr")).string();
    const Json stats = render(
        scene, options_of(row, scene.options),
        {.seed = job.seed, .seconds = job.seconds, .samples = job.samples, .snapshots = true, .picture = picture});
    Json points = Json::array();
    for (const Json& snapshot : stats["snapshots"]) {
        const std::string file = snapshot["file"];
        points.push_back({{"spp", snapshot["spp"]},
                          {"seconds", snapshot["seconds"]},
                          {"errors", picture_errors(reference.picture, read_exr(file), file)}});
        std::filesystem::remove(file);
    }
    return {{"line", "run"},
            {"key", key},
            {"row", row.name},
            {"settings", row.settings},
            {"seed", job.seed},
            {"picture", "pictures/" + key + ".exr"},
            {"spp", stats["spp"]},
            {"seconds", stats["seconds"]},
            {"peak_rss_bytes", stats["peak_rss_bytes"]},
            {"stages", stats["stages"]},
            {"points", points}};
}

}  // namespace tress
