// SPDX-License-Identifier: MIT
#include "gather/visibility.h"

#include <algorithm>

namespace tress {

void through_hair(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                  std::span<Rgb> visibility) {
    if (prepared.hair.empty())
        std::fill(visibility.begin(), visibility.end(), Rgb(1));
    else
        transmittance(prepared.hair, rays.for_hair(), prepared.attenuation, options.cutoff, visibility, options.isa);
}

void find_open_rays(const PreparedScene& prepared, const RayBuffer& rays, Isa isa, OpenRays& open) {
    open.occluded.assign(rays.size(), 0);
    if (!prepared.mesh.empty()) occluded_triangle(prepared.mesh, rays.for_mesh(), open.occluded, isa);
    open.index.clear();
    open.rays.clear();
    for (uint32_t ray = 0; ray < rays.size(); ++ray) {
        if (open.occluded[ray]) continue;
        open.index.push_back(ray);
        open.rays.add_from(rays, ray);
    }
}

void VisibilityQuery::operator()(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                                 std::span<Rgb> visibility) {
    find_open_rays(prepared, rays, options.isa, open_);
    through_.resize(open_.index.size());
    if (options.scattering == ScatteringModel::full)
        past_hair(prepared, options);
    else
        through_hair(prepared, open_.rays, options, through_);
    std::fill(visibility.begin(), visibility.end(), Rgb(0));
    for (size_t i = 0; i < open_.index.size(); ++i) visibility[open_.index[i]] = through_[i];
}

void VisibilityQuery::past_hair(const PreparedScene& prepared, const Options& options) {
    const size_t n = open_.index.size();
    for (auto* floats : {&t_, &u_, &h_}) floats->resize(n);
    id_.assign(n, kNone);
    if (!prepared.hair.empty()) nearest_segment(prepared.hair, open_.rays.for_hair(), {t_, id_, u_, h_}, options.isa);
    for (size_t i = 0; i < n; ++i) through_[i] = Rgb(id_[i] == kNone ? 1.0f : 0.0f);
}

}  // namespace tress
