// SPDX-License-Identifier: MIT
#include "gather/paths/path_rays.h"

#include <algorithm>

namespace tress {

void PathRays::trace(const PreparedScene& prepared, const Options& options, std::span<const float> chance) {
    const size_t n = rays.size();
    end_.assign(n, PathEnd::nothing);
    weight_.assign(n, Rgb(1));
    for (auto* floats : {&t_, &u_, &h_}) floats->assign(n, kInfinity);
    id_.assign(n, kNone);
    flown_ = false;
    if (!prepared.mesh.empty()) find_polygons(prepared, options);
    if (prepared.hair.empty()) return;
    if (options.scattering == ScatteringModel::straight)
        fly_through_hair(prepared, options, chance);
    else
        find_hair(prepared, options);
}

void PathRays::find_polygons(const PreparedScene& prepared, const Options& options) {
    nearest_triangle(prepared.mesh, rays.for_mesh(), {t_, id_, u_, h_}, options.isa);
    for (size_t ray = 0; ray < rays.size(); ++ray) {
        rays.set_far(ray, t_[ray]);
        if (id_[ray] != kNone) end_[ray] = PathEnd::polygon;
    }
}

void PathRays::fly_through_hair(const PreparedScene& prepared, const Options& options, std::span<const float> chance) {
    flights(prepared.hair, rays.for_hair(), prepared.attenuation, chance, flights_, options.isa);
    flown_ = true;
    const Crossings& c = flights_.crossings;
    for (size_t ray = 0; ray < rays.size(); ++ray) {
        if (c.first[ray] == c.first[ray + 1]) continue;
        const size_t last = c.first[ray + 1] - 1;
        const Rgb before = flights_.before[last], after = flights_.after[last];
        const float passes = max_component(after);
        if (passes > chance[ray]) {
            weight_[ray] = after / passes;
            continue;
        }
        const float stops = max_component(before) - passes;
        end_[ray] = PathEnd::fiber;
        weight_[ray] = stops > 0 ? before / stops : Rgb(0);
        t_[ray] = c.t[last], u_[ray] = c.u[last], h_[ray] = c.h[last], id_[ray] = c.id[last];
    }
}

void PathRays::find_hair(const PreparedScene& prepared, const Options& options) {
    const size_t n = rays.size();
    for (auto* floats : {&hair_t_, &hair_u_, &hair_h_}) floats->assign(n, kInfinity);
    hair_id_.assign(n, kNone);
    nearest_segment(prepared.hair, rays.for_hair(), {hair_t_, hair_id_, hair_u_, hair_h_}, options.isa);
    for (size_t ray = 0; ray < n; ++ray) {
        if (hair_id_[ray] == kNone) continue;
        end_[ray] = PathEnd::fiber;
        t_[ray] = hair_t_[ray], u_[ray] = hair_u_[ray], h_[ray] = hair_h_[ray], id_[ray] = hair_id_[ray];
    }
}

Rgb PathRays::weight_at(size_t ray, float distance) const {
    if (!(distance < t_[ray])) return Rgb(0);
    if (!flown_) return Rgb(1);
    const Crossings& c = flights_.crossings;
    const auto begin = c.t.begin() + std::ptrdiff_t(c.first[ray]), end = c.t.begin() + std::ptrdiff_t(c.first[ray + 1]);
    const auto beyond = std::lower_bound(begin, end, distance);
    if (beyond == begin) return Rgb(1);
    const Rgb after = flights_.after[size_t(beyond - c.t.begin()) - 1];
    return after / max_component(after);
}

}  // namespace tress
