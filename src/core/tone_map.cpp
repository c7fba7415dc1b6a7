// SPDX-License-Identifier: MIT
#include "core/tone_map.h"

#include <tbb/parallel_for.h>

namespace tress {
namespace {

constexpr float kMidGrey = 0.18f;
constexpr float kShoulderPower = 1.5f;  // 1 is soft and grey, 2 nearly clips
constexpr float kHueKept = 0.5f;        // share of the hue-preserving form
constexpr float kBrightest = 1e12f;     // shown as 1; keeps powers of it finite

float bend(float x) {
    if (x <= kMidGrey) return x;
    const float t = (x - kMidGrey) / (1 - kMidGrey);
    const float shoulder = t / std::pow(1 + std::pow(t, kShoulderPower), 1 / kShoulderPower);
    return glm::min(kMidGrey + (1 - kMidGrey) * shoulder, 1.0f);
}

float clean(float x) { return x > 0 ? glm::min(x, kBrightest) : 0.0f; }  // false for NaN

Rgb expose(const Rgb& linear, float gain) {
    const Rgb x(clean(clean(linear.x) * gain), clean(clean(linear.y) * gain), clean(clean(linear.z) * gain));
    const float peak = max_component(x);
    if (peak <= kMidGrey) return x;
    const Rgb each(bend(x.x), bend(x.y), bend(x.z));
    const Rgb scaled = x / peak * bend(peak);
    return glm::mix(each, scaled, kHueKept);
}

}  // namespace

Rgb tone_map(const Rgb& linear, float exposure_stops) { return expose(linear, std::exp2(exposure_stops)); }

Image tone_map(const Image& linear, float exposure_stops) {
    Image out = make_image(linear.width, linear.height);
    const float gain = std::exp2(exposure_stops);
    tbb::parallel_for(0, linear.height, [&](int y) {
        for (int x = 0; x < linear.width; ++x) out.at(x, y) = expose(linear.at(x, y), gain);
    });
    return out;
}

}  // namespace tress
