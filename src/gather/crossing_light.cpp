// SPDX-License-Identifier: MIT
#include "gather/crossing_light.h"

namespace tress {

void CrossingLight::operator()(const Scene&, const PreparedScene&, const Options&, std::span<const uint32_t>,
                               const GatherRays&, std::span<Rgb>) {}

}  // namespace tress
