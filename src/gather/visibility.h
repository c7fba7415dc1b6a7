// SPDX-License-Identifier: MIT
// V(x, w, d) of the paper: what is left of light that comes straight through hair, and nothing past a polygon.
#pragma once

#include <span>
#include <vector>

#include "gather/prepared_scene.h"
#include "gather/ray_buffer.h"

namespace tress {

/// Visibility of each ray over its whole length. Scratch arrays are kept between calls.
class VisibilityQuery {
public:
    void operator()(const PreparedScene& prepared, const RayBuffer& rays, const Options& options,
                    std::span<Rgb> visibility);

private:
    std::vector<uint8_t> occluded_;
    std::vector<uint32_t> open_;  // rays that no polygon stops
    RayBuffer open_rays_;
    std::vector<Rgb> transmittance_;
};

}  // namespace tress
