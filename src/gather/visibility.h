// SPDX-License-Identifier: MIT
// V(x, w, d) of the paper: what is left of light that comes straight through hair, and nothing past a polygon.
#pragma once

#include <span>
#include <vector>

#include "gather/prepared_scene.h"
#include "gather/ray_buffer.h"

namespace tress {

/// What hair lets through of each ray over its whole length: for rays that end where a polygon is, or none is met.
void through_hair(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                  std::span<Rgb> visibility);

/// Rays that no polygon stops: which of those asked for, and a copy of them.
struct OpenRays {
    std::vector<uint32_t> index;
    RayBuffer rays;
    std::vector<uint8_t> occluded;  // one a ray asked for
};
void find_open_rays(const PreparedScene& prepared, const RayBuffer& rays, Isa isa, OpenRays& open);

/// Visibility of each ray over its whole length; under full scattering hair stops a ray. Scratch arrays are kept
/// between calls.
class VisibilityQuery {
public:
    void operator()(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                    std::span<Rgb> visibility);

private:
    /// By nearest hits, whose segments have round ends: what a path's ray would meet must stop its shadow rays too.
    void past_hair(const PreparedScene& prepared, const Options& options);

    OpenRays open_;
    std::vector<Rgb> through_;  // one an open ray
    std::vector<float> t_, u_, h_;
    std::vector<uint32_t> id_;
};

}  // namespace tress
