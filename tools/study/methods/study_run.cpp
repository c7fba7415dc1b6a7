// SPDX-License-Identifier: MIT
#include "tools/study/methods/study_run.h"

#include <filesystem>

#include "io/exr_file.h"
#include "tools/signature.h"
#include "tools/study/methods/picture_error.h"

namespace tress {

std::string run_key(const StudyScene& scene, const StudyRow& row, const Budget& budget, const Reference& reference) {
    const Options options = options_of(row, scene.options);
    return key_of({"run", TRESS_VERSION, scene.signature, scene.processor, scene.isa, std::to_string(scene.threads),
                   scene.program, reference.line["key"], options_text(options, {"time", "spp", "seed", "threads"}),
                   std::to_string(budget.seed), std::to_string(budget.seconds), std::to_string(budget.samples)});
}

Json run_row(const StudyScene& scene, const StudyRow& row, const Budget& budget, const Reference& reference,
             const std::string& folder, const std::string& work) {
    const std::string key = run_key(scene, row, budget, reference);
    const std::string picture = "pictures/" + key + ".exr", made = work + "/run.exr";
    const Json stats = render(scene, options_of(row, scene.options), budget, made, true);
    Json points = Json::array();
    for (const Json& snapshot : stats["snapshots"]) {
        const std::string file = snapshot["file"];
        points.push_back({{"spp", snapshot["spp"]},
                          {"seconds", snapshot["seconds"]},
                          {"errors", picture_errors(reference.picture, read_exr(file), file)}});
        std::filesystem::remove(file);
    }
    const std::filesystem::path place = std::filesystem::path(folder) / picture;
    std::filesystem::create_directories(place.parent_path());
    std::filesystem::rename(made, place);
    return {{"line", "run"},
            {"key", key},
            {"row", row.name},
            {"settings", row.settings},
            {"seed", budget.seed},
            {"picture", picture},
            {"spp", stats["spp"]},
            {"seconds", stats["seconds"]},
            {"peak_rss_bytes", stats["peak_rss_bytes"]},
            {"stages", stats["stages"]},
            {"points", points}};
}

}  // namespace tress
