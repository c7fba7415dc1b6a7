// SPDX-License-Identifier: MIT
// Colour spaces: linear RGB (Rec. 709 primaries, white D65), CIE XYZ, CIELAB, YCxCz and the sRGB encoding. XYZ has
// Y = 1 at the white of RGB (1, 1, 1), which is also the reference white of CIELAB and YCxCz.
#pragma once

#include <algorithm>

#include "core/math.h"

namespace tress {
namespace color {

using DMat3 = glm::dmat3;

/// Column of XYZ of a chromaticity (x, y), scaled to Y = 1.
inline DVec3 from_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

/// RGB -> XYZ from the chromaticities of ITU-R BT.709-6, item 1.3 and 1.4 (those of sRGB, IEC 61966-2-1).
inline DMat3 make_rgb_to_xyz() {
    const DMat3 primaries{from_chromaticity(0.64, 0.33), from_chromaticity(0.30, 0.60), from_chromaticity(0.15, 0.06)};
    const DVec3 scale = glm::inverse(primaries) * from_chromaticity(0.3127, 0.3290);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

inline const DMat3 kRgbToXyz64 = make_rgb_to_xyz();
inline const glm::mat3 kRgbToXyz{kRgbToXyz64};
inline const glm::mat3 kXyzToRgb{glm::inverse(kRgbToXyz64)};
inline const Vec3 kWhite{kRgbToXyz64 * DVec3(1)};
inline const Vec3 kInverseWhite{DVec3(1) / (kRgbToXyz64 * DVec3(1))};

/// The cube root of CIELAB, with its straight line near black (CIE 15:2018, eq. 8.6 ff.).
inline float lab_root(float t) {
    constexpr float kDelta = 6.0f / 29.0f;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0f / 29.0f;
}

}  // namespace color

inline Vec3 rgb_to_xyz(const Rgb& rgb) { return color::kRgbToXyz * rgb; }
inline Rgb xyz_to_rgb(const Vec3& xyz) { return color::kXyzToRgb * xyz; }

/// CIELAB: L in [0, 100], a, b.
inline Vec3 xyz_to_lab(const Vec3& xyz) {
    const Vec3 relative = xyz * color::kInverseWhite;
    const Vec3 root(color::lab_root(relative.x), color::lab_root(relative.y), color::lab_root(relative.z));
    return {116 * root.y - 16, 500 * (root.x - root.y), 200 * (root.y - root.z)};
}

/// YCxCz, the linearised CIELAB: Y in [-16, 100], Cx red to green, Cz yellow to blue.
inline Vec3 xyz_to_ycxcz(const Vec3& xyz) {
    const Vec3 relative = xyz * color::kInverseWhite;
    return {116 * relative.y - 16, 500 * (relative.x - relative.y), 200 * (relative.y - relative.z)};
}

inline Vec3 ycxcz_to_xyz(const Vec3& c) {
    const float y = (c.x + 16) / 116;
    return color::kWhite * Vec3(y + c.y / 500, y, y - c.z / 200);
}

/// Display light in [0, 1] of a value in sRGB encoding (IEC 61966-2-1).
inline float srgb_to_linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
inline float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

}  // namespace tress
