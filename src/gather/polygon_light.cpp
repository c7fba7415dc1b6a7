// SPDX-License-Identifier: MIT
#include "gather/polygon_light.h"

namespace tress {

void PolygonLight::operator()(const Scene&, const PreparedScene&, const Options&, const GatherRays&, std::span<Rgb>) {}

}  // namespace tress
