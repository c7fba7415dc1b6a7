// SPDX-License-Identifier: MIT
#include "gather/lamp_visibility.h"

namespace tress {
namespace {

/// What a fiber across a map's middle of its own look-up covers of it: texels are boxes, look-ups are bilinear, so the
/// weights across the fiber are a quadratic B-spline, 3/4 high at its middle (0.78 for a fiber along a diagonal).
constexpr float kOwnWeight = 0.76f;

/// A fiber shadows itself on its map: its fragments lie before and behind a point of its axis alike, so half of what it
/// stops is taken out of the map's answer.
Rgb without_own_fiber(const PreparedScene& prepared, const ShadowMap& map, const MapPlace& place, uint32_t segment,
                      const Rgb& transmittance) {
    const SegmentView& hair = prepared.segments;
    const Vec3 axis = hair.end(segment) - hair.start(segment);
    const Vec3 light = light_direction(map.view, place.at.x, place.at.y);
    const float length = glm::length(axis), sine = length > 0 ? std::abs(dot(axis, light)) / length : 0;
    const float width = 2 * hair.start_radius(segment), texel = texel_width(map.view, place.at.depth);
    const float covered = texel > 0 ? std::min(1.0f, kOwnWeight * width / texel) : 1;
    const Rgb stopped = 1.0f - exp(-prepared.attenuation.depth(segment, std::min(sine, 1.0f)));
    return min(transmittance / (1.0f - 0.5f * covered * stopped), Rgb(1));
}

}  // namespace

void LampRays::clear() {
    rays.clear();
    light.clear();
    u.clear();
    segment.clear();
}

void LampRays::add(const Vec3& origin, const Vec3& direction, float distance, const Excluded& excluded,
                   uint32_t of_light, const Vec2& sample, uint32_t of_segment) {
    rays.add(origin, direction, distance, excluded);
    light.push_back(of_light);
    u.push_back(sample);
    segment.push_back(of_segment);
}

/// Sets what a map says of the open ray `row`, and how far that ray is traced.
void LampVisibility::ask_map(const Scene& scene, const PreparedScene& prepared, const LampMaps& maps, float near,
                             const LampRays& to, size_t row) {
    const uint32_t ray = open_.index[row], light = to.light[ray];
    const Light& lamp = scene.lights[light];
    const Vec3 origin = to.rays.origin(ray);
    const float distance = to.rays.far(ray);
    const auto place = [&](const Vec3& point) { return place_on(maps, lamp, light, to.u[ray], point); };
    MapPlace at = place(origin);
    float traced = 0;
    if (at.map && near > 0) {
        traced = std::min(near * texel_width(at.map->view, at.at.depth), distance);
        at = place(origin + traced * to.rays.direction(ray));
    }
    beyond_[row] = Rgb(1);
    if (!at.map && !at.clear) traced = distance;
    open_.rays.set_far(row, traced);
    if (!at.map || traced >= distance) return;
    beyond_[row] = transmittance(*at.map, at.at);
    if (near == 0 && to.segment[ray] != kNone)
        beyond_[row] = without_own_fiber(prepared, *at.map, at, to.segment[ray], beyond_[row]);
}

void LampVisibility::operator()(const Scene& scene, const PreparedScene& prepared, const LampMaps* maps, float near,
                                const Options& options, const LampRays& to, std::span<Rgb> visibility) {
    if (!maps) {
        query_(prepared, to.rays, options, visibility);
        return;
    }
    find_open_rays(prepared, to.rays, options.isa, open_);
    beyond_.resize(open_.index.size());
    for (size_t row = 0; row < open_.index.size(); ++row) ask_map(scene, prepared, *maps, near, to, row);
    through_.resize(open_.index.size());
    through_hair(prepared, open_.rays, options, through_);
    std::fill(visibility.begin(), visibility.end(), Rgb(0));
    for (size_t row = 0; row < open_.index.size(); ++row) visibility[open_.index[row]] = through_[row] * beyond_[row];
}

}  // namespace tress
