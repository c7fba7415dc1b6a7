// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/seen_hair.h"

#include "gather/seen_points.h"

namespace tress {

SeenHair find_seen_hair(const Scene& scene, const PreparedScene& prepared, const Options& options) {
    SeenHair seen;
    seen.bounds = bounds(prepared.segments);
    const SeenPoints points = find_seen_points(scene, prepared, options);
    for (const ShadingPoint& point : points.hair) seen.points.push_back(point.position);
    return seen;
}

}  // namespace tress
