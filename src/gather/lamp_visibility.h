// SPDX-License-Identifier: MIT
// What hair and polygons leave of the light of lamps: by rays, or by rays next to the point and shadow maps beyond.
//
// A map's texel is wider than many hairs: it cannot tell which of those next to a point shadow it, its own fiber least
// of all. So the first texel widths are traced exactly (options.maps.near), which needs no depth bias, and the map is
// asked from there on. Polygons always stop rays exactly. Points of polygons far behind the hair would see it from the
// few points of a quad lamp that have maps, as steps in its shadow: from polygons, rays to quads are traced all the
// way.
#pragma once

#include <span>
#include <vector>

#include "gather/shadow_maps/lamp_maps.h"
#include "gather/visibility.h"

namespace tress {

/// Rays from points to lamps; rows belong together by index.
struct LampRays {
    RayBuffer rays;
    std::vector<uint32_t> light;    // index of scene.lights
    std::vector<Vec2> place;        // of a quad: where on it the ray goes to, in shares of its edges
    std::vector<uint32_t> segment;  // of the fiber that the ray starts on; kNone: a polygon

    size_t size() const { return light.size(); }
    void clear();
    void add(const Vec3& origin, const Vec3& direction, float distance, const Excluded& excluded, uint32_t of_light,
             const Vec2& on_lamp, uint32_t of_segment);
};

class LampVisibility {
public:
    /// `maps`: none: rays all the way. `near`: texel widths that are traced before a map is asked;
    /// 0: only next to fibers that are wide on the map.
    void operator()(const Scene& scene, const PreparedScene& prepared, const LampMaps* maps, float near,
                    const Options& options, const LampRays& to, std::span<Rgb> visibility);

private:
    void ask_map(const Scene& scene, const PreparedScene& prepared, const LampMaps& maps, float near,
                 const LampRays& to, size_t row);

    VisibilityQuery query_;
    OpenRays open_;                      // cut to what is traced
    std::vector<Rgb> through_, beyond_;  // what hair leaves of each along it, and past its end
};

}  // namespace tress
