// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/lamp_maps.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <iterator>

namespace tress {
namespace {

/// Views of all hair unless fitting them to what is seen saves some or makes them much sharper: with all hair inside,
/// no look-up fails.
LampViews fit(const Light& light, const DVec3& point, const SegmentView& segments, const SeenHair& seen,
              int resolution) {
    constexpr double kSharper = 1.25;
    LampViews of_all = fit_views(light, point, segments, {seen.bounds, {}}, resolution);
    if (seen.points.empty() || of_all.views.empty()) return of_all;
    LampViews of_seen = fit_views(light, point, segments, seen, resolution);
    if (of_seen.views.empty()) return of_all;
    const bool fewer = of_seen.views.size() < of_all.views.size();
    const bool sharper = of_all.views[0].texel.x > kSharper * of_seen.views[0].texel.x;
    return fewer || sharper ? of_seen : of_all;
}

/// A point of a lamp, with its maps once they are made.
struct LampPoint {
    const Light* lamp;
    DVec3 at;
    bool complete;
    std::vector<ShadowMap> maps;
};

void make_maps(LampPoint& point, MapKind kind, const SegmentView& segments, const SeenHair& seen,
               const Attenuation& attenuation, const Options& options) {
    const LampViews fitted = fit(*point.lamp, point.at, segments, seen, options.maps.resolution);
    point.complete = fitted.complete;
    for (const LightView& view : fitted.views)
        point.maps.push_back(make_shadow_map(view, kind, segments, attenuation, options));
}

}  // namespace

LampMaps make_lamp_maps(std::span<const Light> lights, std::span<const uint32_t> lamps, MapKind kind,
                        const SegmentView& segments, const SeenHair& seen, const Attenuation& attenuation,
                        const Options& options) {
    LampMaps to;
    to.grid = options.maps.grid;
    to.first_point.assign(lights.size() + 1, 0);
    std::vector<uint8_t> is_lamp(lights.size(), 0);
    for (const uint32_t lamp : lamps) is_lamp[lamp] = 1;
    std::vector<LampPoint> points;
    for (size_t light = 0; light < lights.size(); ++light) {
        to.first_point[light] = uint32_t(points.size());
        if (!is_lamp[light]) continue;
        for (const DVec3& at : view_points(lights[light], to.grid)) points.push_back({&lights[light], at, false, {}});
    }
    to.first_point.back() = uint32_t(points.size());

    // A thread that waits for others at one point takes no other point up: as many are under way as there are threads.
    tbb::parallel_for(size_t(0), points.size(), [&](size_t p) {
        tbb::this_task_arena::isolate([&] { make_maps(points[p], kind, segments, seen, attenuation, options); });
    });
    to.first_map = {0};
    for (LampPoint& point : points) {
        std::move(point.maps.begin(), point.maps.end(), std::back_inserter(to.maps));
        to.first_map.push_back(uint32_t(to.maps.size()));
        to.complete.push_back(point.complete);
    }
    return to;
}

MapPlace place_on(const LampMaps& maps, const Light& lamp, uint32_t light, const Vec2& on_lamp, const Vec3& point) {
    const size_t p = maps.first_point[light] + view_point_of(lamp, maps.grid, on_lamp);
    for (uint32_t m = maps.first_map[p]; m < maps.first_map[p + 1]; ++m) {
        const ViewPoint at = project(maps.maps[m].view, point);
        if (contains(maps.maps[m].view, at)) return {&maps.maps[m], false, at};
    }
    return {nullptr, maps.complete[p] != 0, {}};
}

size_t bytes(const LampMaps& maps) {
    size_t sum =
        (maps.first_point.capacity() + maps.first_map.capacity()) * sizeof(uint32_t) + maps.complete.capacity();
    for (const ShadowMap& map : maps.maps) sum += bytes(map);
    return sum;
}

}  // namespace tress
