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

void VisibilityQuery::operator()(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                                 std::span<Rgb> visibility) {
    occluded_.assign(rays.size(), 0);
    if (!prepared.mesh.empty()) occluded_triangle(prepared.mesh, rays.for_mesh(), occluded_, options.isa);
    open_.clear();
    open_rays_.clear();
    for (uint32_t ray = 0; ray < rays.size(); ++ray) {
        visibility[ray] = Rgb(0);
        if (occluded_[ray]) continue;
        open_.push_back(ray);
        open_rays_.add_from(rays, ray);
    }
    through_.resize(open_.size());
    if (options.scattering == ScatteringModel::full)
        past_hair(prepared, options);
    else
        through_hair(prepared, open_rays_, options, through_);
    for (size_t i = 0; i < open_.size(); ++i) visibility[open_[i]] = through_[i];
}

void VisibilityQuery::past_hair(const PreparedScene& prepared, const Options& options) {
    const size_t n = open_.size();
    for (auto* floats : {&t_, &u_, &h_}) floats->resize(n);
    id_.assign(n, kNone);
    if (!prepared.hair.empty()) nearest_segment(prepared.hair, open_rays_.for_hair(), {t_, id_, u_, h_}, options.isa);
    for (size_t i = 0; i < n; ++i) through_[i] = Rgb(id_[i] == kNone ? 1.0f : 0.0f);
}

}  // namespace tress
