// SPDX-License-Identifier: MIT
// The shadow maps of one kind of all lamps. A quad lamp has a grid of points with maps of their own; a lamp among the
// hair has several maps a point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene.h"
#include "gather/shadow_maps/fit_views.h"
#include "gather/shadow_maps/shadow_map.h"

namespace tress {

/// Light l (index of scene.lights) owns points first_point[l] .. first_point[l + 1] - 1, none where it is no lamp;
/// point p owns maps first_map[p] .. first_map[p + 1] - 1.
struct LampMaps {
    std::vector<uint32_t> first_point, first_map;
    std::vector<uint8_t> complete;  // one a point: no hair lies outside its maps
    std::vector<ShadowMap> maps;
    int grid = 1;
};

/// `lamps`: indices of lights. In parallel; the same for any number of threads.
LampMaps make_lamp_maps(std::span<const Light> lights, std::span<const uint32_t> lamps, MapKind kind,
                        const SegmentView& segments, const SeenHair& seen, const Attenuation& attenuation,
                        const Options& options);

/// Where a straight way to a lamp falls on its maps.
struct MapPlace {
    const ShadowMap* map = nullptr;  // none: no map holds it
    bool clear = false;              // no map holds it because no hair is there
    ViewPoint at;
};

/// The way from `point` to the place `on_lamp` (LightSample::place) of lamp `light`, on the maps of the nearest point
/// of the lamp.
MapPlace place_on(const LampMaps& maps, const Light& lamp, uint32_t light, const Vec2& on_lamp, const Vec3& point);

size_t bytes(const LampMaps& maps);

}  // namespace tress
