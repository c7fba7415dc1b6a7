// SPDX-License-Identifier: MIT
#include "gather/projection/probe_grid.h"

#include <bit>

namespace tress {
ProbeGrid make_probe_grid(const HairCube& hair, int across) {
    const float size = 2 * hair.half / float(std::bit_ceil(unsigned(across)));
    return {hair.center - hair.half, size > 0 ? size : 1};
}

uint64_t ProbeCube::key(int i) const {
    const auto part = [](int32_t at) { return uint64_t(at) & 0x1fffff; };
    return part(x + (i & 1)) | part(y + (i >> 1 & 1)) << 21 | part(z + (i >> 2)) << 42;
}

float ProbeCube::weight(int i) const {
    return (i & 1 ? place.x : 1 - place.x) * (i >> 1 & 1 ? place.y : 1 - place.y) * (i >> 2 ? place.z : 1 - place.z);
}

ProbeCube cube_at(const ProbeGrid& grid, const Vec3& place) {
    const Vec3 cubes = (place - grid.origin) / grid.size, whole = floor(cubes);
    return {grid, int32_t(whole.x), int32_t(whole.y), int32_t(whole.z), clamp(cubes - whole, Vec3(0), Vec3(1))};
}

}  // namespace tress
