// SPDX-License-Identifier: MIT
#include "gather/lamp_visibility.h"

#include "gather/shadow_maps/own_fiber.h"

namespace tress {
namespace {

/// Without rays next to points a fiber's own image is taken out of the answer on average, while it is thinner than this
/// many texels. Next to wider ones rays are traced for kClear widths: texels are short there.
constexpr float kThin = 0.25f, kClear = 8;

}  // namespace

void LampRays::clear() {
    rays.clear();
    light.clear();
    place.clear();
    segment.clear();
}

void LampRays::add(const Vec3& origin, const Vec3& direction, float distance, const Excluded& excluded,
                   uint32_t of_light, const Vec2& on_lamp, uint32_t of_segment) {
    rays.add(origin, direction, distance, excluded);
    light.push_back(of_light);
    place.push_back(on_lamp);
    segment.push_back(of_segment);
}

/// Sets what a map says of the open ray `row`, and how far that ray is traced.
void LampVisibility::ask_map(const Scene& scene, const PreparedScene& prepared, const LampMaps& maps, float near,
                             const LampRays& to, size_t row) {
    const uint32_t ray = open_.index[row], light = to.light[ray];
    const Light& lamp = scene.lights[light];
    const Vec3 origin = to.rays.origin(ray);
    const float distance = to.rays.far(ray);
    beyond_[row] = Rgb(1);
    const bool on_polygon = to.segment[ray] == kNone;
    if (on_polygon && std::holds_alternative<QuadLight>(lamp)) return;
    const auto place = [&](const Vec3& point) { return place_on(maps, lamp, light, to.place[ray], point); };
    const Vec3 direction = to.rays.direction(ray);
    MapPlace at = place(origin);
    float traced = 0;
    Rgb own(1);
    if (at.map) {
        const float texel = texel_width(at.map->view, at.at.depth);
        const float width = on_polygon ? 0 : fiber_width(prepared.segments, to.segment[ray]);
        if (near == 0 && width <= kThin * texel) {
            if (!on_polygon)
                own = own_fiber_passed(prepared.segments, prepared.attenuation, at.map->view, at.at, to.segment[ray],
                                       direction, depth_blur(*at.map));
            at = place(origin + std::min(0.5f * width, distance) * direction);
        } else {
            traced = std::min(std::max(near * texel, near == 0 ? kClear * width : 0), distance);
            at = place(origin + traced * direction);
        }
    }
    if (!at.map && !at.clear) traced = distance;
    open_.rays.set_far(row, traced);
    if (at.map && traced < distance) beyond_[row] = transmittance(*at.map, at.at) / own;
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
