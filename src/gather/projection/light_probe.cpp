// SPDX-License-Identifier: MIT
#include "gather/projection/light_probe.h"

namespace tress {
namespace {

constexpr int kSteps = 4;         // of the search: more change nothing that matters
constexpr float kCloseBy = 0.1f;  // of the distance: about a cell's width

}  // namespace

uint32_t cell_towards(const LightProbe& probe, const Igloo& igloo, const Vec3& place, const Vec3& direction) {
    uint32_t cell = cell_of(igloo, probe.frame.to_local(direction));
    const Vec3 from = place - probe.position;
    const float along = dot(from, direction), offset = dot(from, from);
    float t = probe.cells[cell].distance();
    for (int step = 0; step < kSteps && !probe.cells[cell].is_sky(); ++step) {
        const Vec3 seen = from + t * direction;
        const float far = length(seen);
        if (!(far > 0)) break;
        cell = cell_of(igloo, probe.frame.to_local(seen / far));
        const float distance = probe.cells[cell].distance();
        if (std::abs(distance - far) < kCloseBy * distance) break;
        // From where the way leaves the ball about the probe as far as what is seen.
        const float inside = square(along) + square(distance) - offset;
        if (!(inside > 0)) break;
        t = std::max(std::sqrt(inside) - along, 0.0f);
    }
    return cell;
}

}  // namespace tress
