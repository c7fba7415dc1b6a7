// SPDX-License-Identifier: MIT
#include "gather/path_tracer.h"

namespace tress {

void PathTracer::operator()(const Scene&, const PreparedScene&, const Plan&, const Options&,
                            std::span<const ShadingPoint>, std::span<const Sampler>, std::span<LightByType>) {}

}  // namespace tress
