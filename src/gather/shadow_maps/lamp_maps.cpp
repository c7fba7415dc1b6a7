// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/lamp_maps.h"

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

}  // namespace

LampMaps make_lamp_maps(std::span<const Light> lights, std::span<const uint32_t> lamps, MapKind kind,
                        const SegmentView& segments, const SeenHair& seen, const Attenuation& attenuation,
                        const Options& options) {
    LampMaps to;
    to.grid = options.maps.grid;
    to.first_point.assign(lights.size() + 1, 0);
    to.first_map = {0};
    std::vector<uint8_t> is_lamp(lights.size(), 0);
    for (const uint32_t lamp : lamps) is_lamp[lamp] = 1;
    for (size_t light = 0; light < lights.size(); ++light) {
        to.first_point[light] = uint32_t(to.complete.size());
        if (!is_lamp[light]) continue;
        for (const DVec3& point : view_points(lights[light], to.grid)) {
            const LampViews fitted = fit(lights[light], point, segments, seen, options.maps.resolution);
            for (const LightView& view : fitted.views)
                to.maps.push_back(make_shadow_map(view, kind, segments, attenuation, options));
            to.first_map.push_back(uint32_t(to.maps.size()));
            to.complete.push_back(fitted.complete);
        }
    }
    to.first_point.back() = uint32_t(to.complete.size());
    return to;
}

MapPlace place_on(const LampMaps& maps, const Light& lamp, uint32_t light, const Vec2& u, const Vec3& point) {
    const size_t p = maps.first_point[light] + view_point_of(lamp, maps.grid, u);
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
