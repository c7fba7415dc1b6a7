// SPDX-License-Identifier: MIT
#include "tools/render_report.h"

#include <cstdio>

#include "tools/photon_report.h"

namespace tress {
namespace {

/// "light: type1 61.2 ± 0.1 %, type2 …"
void print(const char* what, const std::vector<TypeShare>& types) {
    std::string line;
    for (const TypeShare& share : types) {
        char text[64];
        std::snprintf(text, sizeof text, "%s%s %.2f ± %.2f %%", line.empty() ? "" : ", ", type_name(share.type),
                      share.percent, share.percent_error);
        line += text;
    }
    if (!line.empty()) std::fprintf(stderr, "%s: %s\n", what, line.c_str());
}

/// Of the stages that bear this name, times the threads.
double core_seconds(const RenderStats& stats, const char* name) {
    double sum = 0;
    for (const StageCost& cost : stats.stages)
        if (cost.name == name) sum += cost.seconds * stats.threads;
    return sum;
}

/// What `type1: auto` expected, beside what it took.
void print_lamp_estimate(const RenderStats& stats, const Plan& plan) {
    const LampCost& cost = *plan.lamp_cost;
    const char* maps = stage::kShadowMaps[int(MapKind::deep)];
    if (plan.lamp_maps && cost.build == 0)
        std::fprintf(stderr, "type 1: by %s that type 3 asks too, estimated %.1f core seconds, took %.1f\n", maps,
                     cost.maps, core_seconds(stats, stage::kType1));
    else if (plan.lamp_maps)
        std::fprintf(stderr, "type 1: by %s, estimated %.1f core seconds and %.1f to make them, took %.1f and %.1f\n",
                     maps, cost.maps, cost.build, core_seconds(stats, stage::kType1), core_seconds(stats, maps));
    else
        std::fprintf(stderr, "type 1: by shadow rays, estimated %.1f core seconds, took %.1f\n", cost.rays,
                     core_seconds(stats, stage::kType1));
}

/// What `type2: auto` expected, beside what it took. Gather rays are type 3's too, and in neither figure.
void print_gather_estimate(const RenderStats& stats, const Plan& plan) {
    const GatherCost& cost = *plan.gather_cost;
    if (plan.projection)
        std::fprintf(stderr,
                     "type 2: by projection, estimated %.1f core seconds and %.1f to prepare it, took %.1f and %.1f\n",
                     cost.projection, cost.build, core_seconds(stats, stage::kProjection),
                     core_seconds(stats, stage::kProjectedHair));
    else
        std::fprintf(stderr, "type 2: by rays, estimated %.1f core seconds, took %.1f\n", cost.rays,
                     core_seconds(stats, stage::kSky) + core_seconds(stats, stage::kPolygonGather));
}

void print(const CellGap& gap, const char* of) {
    if (gap.error.points == 0) return;
    std::fprintf(
        stderr,
        "projection: light of type 2 at %d points of %s is off by %.2f %% (rms; mean %+.2f %%); gap %.2f, scatter "
        "%.2f\n",
        gap.error.points, of, 100 * gap.error.rms, 100 * gap.error.bias, double(gap.shares.gap),
        double(gap.shares.scatter));
}

}  // namespace

void print_report(const RenderStats& stats, const Plan& plan, const Scene& scene) {
    for (const std::string& line : photon_lines(stats.photons, scene)) std::fprintf(stderr, "%s\n", line.c_str());
    print("light", stats.types);
    print("light on hair", stats.types_on_hair);
    if (plan.lamp_cost) print_lamp_estimate(stats, plan);
    if (plan.gather_cost) print_gather_estimate(stats, plan);
    if (stats.projection) {
        print(stats.projection->at_hair, "hair");
        print(stats.projection->at_polygons, "polygons among it");
    }
    if (stats.dropped_segments)
        std::fprintf(stderr, "dropped %llu bad segments\n", static_cast<unsigned long long>(stats.dropped_segments));
}

}  // namespace tress
