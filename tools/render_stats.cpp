// SPDX-License-Identifier: MIT
#include "tools/render_stats.h"

#include <sys/resource.h>

#include "tools/photon_report.h"

namespace tress {
namespace {

nlohmann::ordered_json to_json(const std::vector<TypeShare>& shares) {
    nlohmann::ordered_json types = nlohmann::ordered_json::array();
    for (const TypeShare& share : shares)
        types.push_back({{"name", type_name(share.type)},
                         {"mean", share.mean},
                         {"mean_error", share.mean_error},
                         {"percent", share.percent},
                         {"percent_error", share.percent_error}});
    return types;
}

nlohmann::ordered_json to_json(const LampCost& cost) {
    return {{"core_seconds_rays", cost.rays}, {"core_seconds_maps", cost.maps}, {"core_seconds_build", cost.build}};
}

nlohmann::ordered_json to_json(const GatherCost& cost) {
    return {{"core_seconds_rays", cost.rays},
            {"core_seconds_projection", cost.projection},
            {"core_seconds_build", cost.build}};
}

nlohmann::ordered_json to_json(const CellGap& gap) {
    return {{"gap", gap.shares.gap},
            {"scatter", gap.shares.scatter},
            {"points", gap.error.points},
            {"rms_error", gap.error.rms},
            {"bias", gap.error.bias}};
}

nlohmann::ordered_json to_json(const ProjectionReport& report) {
    return {{"at_hair", to_json(report.at_hair)}, {"at_polygons", to_json(report.at_polygons)}};
}

nlohmann::ordered_json to_json(const std::vector<Snapshot>& snapshots) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Snapshot& s : snapshots) list.push_back({{"spp", s.spp}, {"seconds", s.seconds}, {"file", s.file}});
    return list;
}

}  // namespace

uint64_t peak_rss_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return uint64_t(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

nlohmann::ordered_json option_texts(Options options) {
    nlohmann::ordered_json texts = nlohmann::ordered_json::object();
    for (const OptionField& field : option_fields(options)) texts[field.key] = option_text(field);
    return texts;
}

nlohmann::ordered_json to_json(const RenderStats& stats, const Options& options) {
    using Json = nlohmann::ordered_json;
    Json stages = Json::array(), left_out = Json::array();
    for (const StageCost& stage : stats.stages)
        stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"bytes", stage.bytes}});
    for (const PlanItem& item : stats.left_out) left_out.push_back({{"name", item.name}, {"why", item.why}});
    return {{"seconds",
             {{"load", stats.load_seconds},
              {"build", stats.build_seconds},
              {"render", stats.render_seconds},
              {"total", stats.total_seconds}}},
            {"stages", stages},
            {"left_out", left_out},
            {"type1_estimate", stats.lamp_cost ? to_json(*stats.lamp_cost) : nlohmann::ordered_json()},
            {"type2_estimate", stats.gather_cost ? to_json(*stats.gather_cost) : nlohmann::ordered_json()},
            {"types", to_json(stats.types)},
            {"types_on_hair", to_json(stats.types_on_hair)},
            {"photons", stats.photons.lights.empty() ? Json() : to_json(stats.photons)},
            {"projection", stats.projection ? to_json(*stats.projection) : Json()},
            {"snapshots", to_json(stats.snapshots)},
            {"spp", stats.spp},
            {"threads", stats.threads},
            {"isa", stats.isa},
            {"peak_rss_bytes", peak_rss_bytes()},
            {"segments", stats.segments},
            {"dropped_segments", stats.dropped_segments},
            {"options", option_texts(options)}};
}

}  // namespace tress
