// SPDX-License-Identifier: MIT
#include "gather/gather_rays.h"

namespace tress {

void make_gather_rays(const Scene&, const PreparedScene&, const Options&, std::span<const ShadingPoint>,
                      std::span<const Sampler>, GatherRays&) {}

}  // namespace tress
