// SPDX-License-Identifier: MIT
#include "gather/projection/light_probe.h"

namespace tress {

uint32_t cell_towards(const LightProbe& probe, const Igloo& igloo, const Vec3& place, const Vec3& direction) {
    const uint32_t first = cell_of(igloo, probe.frame.to_local(direction));
    if (probe.cells[first].is_sky()) return first;
    const Vec3 seen = place + probe.cells[first].distance() * direction - probe.position;
    const float far = length(seen);
    return far > 0 ? cell_of(igloo, probe.frame.to_local(seen / far)) : first;
}

}  // namespace tress
