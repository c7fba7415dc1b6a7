// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_run.h"

#include "core/error.h"
#include "tools/signature.h"
#include "tools/study/sweep.h"

namespace tress {
namespace {

Json to_json(const TreeStatistics& s) {
    return {{"nodes", s.nodes},
            {"leaves", s.leaves},
            {"empty_leaves", s.empty_leaves},
            {"references", s.references},
            {"bytes", s.bytes},
            {"depth", s.depth},
            {"references_per_segment", s.references_per_primitive},
            {"references_per_leaf", s.references_per_leaf},
            {"sah_steps", s.sah_steps},
            {"sah_tests", s.sah_tests}};
}

Json to_json(const RayRate& r) {
    return {{"mrays_per_second", r.mrays_per_second},
            {"steps", r.steps},
            {"leaves", r.leaves},
            {"tests", r.tests},
            {"traced", r.traced},
            {"counted", r.counted},
            {"seconds", r.seconds},
            {"query", r.query}};
}

}  // namespace

std::string tree_key(const StudyScene& scene, const TreeRow& row, int round, double seconds) {
    const Options options = with_settings(scene.options, row.settings);
    return key_of({"tree", TRESS_VERSION, scene.signature, scene.processor, scene.isa, std::to_string(scene.threads),
                   scene.program, options_text(scene.options, {"time", "spp", "threads"}),
                   options_text(options, {"time", "spp", "threads"}), std::to_string(round), std::to_string(seconds)});
}

Json run_tree(const StudyScene& scene, const SegmentView& segments, std::span<const TreeRays> rays, const TreeRow& row,
              int round, double seconds) {
    Json line{{"line", "tree"},
              {"key", tree_key(scene, row, round, seconds)},
              {"row", row.name},
              {"settings", row.settings},
              {"round", round}};
    try {
        const AccelOptions accel = with_settings(scene.options, row.settings).accel;
        const TreeMeasure measure = measure_tree(segments, accel, rays, scene.options, seconds);
        line["build_seconds"] = measure.build_seconds;
        line["statistics"] = to_json(measure.statistics);
        line["rates"] = Json::object();
        for (const RayRate& rate : measure.rates) line["rates"][rate.rays] = to_json(rate);
    } catch (const InputError& error) {
        line["refused"] = error.what();
    }
    return line;
}

}  // namespace tress
