// SPDX-License-Identifier: MIT
#include "gather/visibility.h"

#include <algorithm>

namespace tress {

void VisibilityQuery::operator()(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                                 std::span<Rgb> visibility) {
    std::fill(visibility.begin(), visibility.end(), Rgb(1));
    occluded_.assign(rays.size(), 0);
    if (!prepared.mesh.empty()) occluded_triangle(prepared.mesh, rays.for_mesh(), occluded_, options.isa);

    open_.clear();
    open_rays_.clear();
    for (uint32_t ray = 0; ray < rays.size(); ++ray) {
        if (occluded_[ray]) {
            visibility[ray] = Rgb(0);
        } else if (!prepared.hair.empty()) {
            open_.push_back(ray);
            open_rays_.add_from(rays, ray);
        }
    }
    if (open_.empty()) return;
    if (options.scattering == ScatteringModel::full)
        stop_at_hair(prepared, options, visibility);
    else
        pass_hair(prepared, options, visibility);
}

void VisibilityQuery::pass_hair(const PreparedScene& prepared, const Options& options, std::span<Rgb> visibility) {
    transmittance_.resize(open_.size());
    transmittance(prepared.hair, open_rays_.for_hair(), prepared.attenuation, options.cutoff, transmittance_,
                  options.isa);
    for (size_t i = 0; i < open_.size(); ++i) visibility[open_[i]] = transmittance_[i];
}

void VisibilityQuery::stop_at_hair(const PreparedScene& prepared, const Options& options, std::span<Rgb> visibility) {
    const size_t n = open_.size();
    for (auto* floats : {&t_, &u_, &h_}) floats->resize(n);
    id_.resize(n);
    nearest_segment(prepared.hair, open_rays_.for_hair(), {t_, id_, u_, h_}, options.isa);
    for (size_t i = 0; i < n; ++i) visibility[open_[i]] = Rgb(id_[i] == kNone ? 1.0f : 0.0f);
}

}  // namespace tress
