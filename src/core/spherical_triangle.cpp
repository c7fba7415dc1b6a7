// SPDX-License-Identifier: MIT
#include "core/spherical_triangle.h"

namespace tress {
namespace {

DVec3 safe_unit(const DVec3& v, const DVec3& otherwise) {
    const double squared = dot(v, v);
    return squared > 0 ? v / std::sqrt(squared) : otherwise;
}

/// Where the arc about the pivot that has passed over `part` meets the side opposite. With P, F, T the corners and X
/// that place, Van Oosterom & Strackee give tan(part / 2) = det(P, F, F + X) / ((P + F).(F + X)); F + X is x F + y T,
/// so that x and y follow from a linear equation, and X is F mirrored in F + X. (The same formula, unlike Arvo's, needs
/// no angles of the triangle, of which small ones have no digits left: Peters 2021, "BRDF Importance Sampling for
/// Polygonal Lights".)
DVec3 end_of_sweep(const SphericalTriangle& t, double part) {
    const DVec3 chord = t.pivot + t.from;  // 1 + P.F is half its square, exact where the two are nearly opposite
    const double s = std::sin(0.5 * part), c = std::cos(0.5 * part);
    const double x = t.volume * c - s * dot(chord, t.to), y = s * 0.5 * dot(chord, chord);
    const DVec3 middle = safe_unit(x * t.from + y * t.to, t.from);
    return safe_unit(2 * dot(t.from, middle) * middle - t.from, t.from);
}

}  // namespace

double solid_angle(const SphericalTriangle& t) {
    return 2 * std::atan2(t.volume, dot(t.pivot + t.from, t.pivot + t.to));  // the product is the sum above
}

DVec3 direction_in(const SphericalTriangle& t, double part, double along) {
    const DVec3 end = end_of_sweep(t, part);
    // 1 - cos of the angle from the pivot is uniform: sines of half angles keep it exact for short arcs.
    const double half_sine = glm::min(0.5 * length(end - t.pivot) * std::sqrt(along), 1.0);
    const double sine = 2 * half_sine * safe_sqrt(1 - square(half_sine)), cosine = 1 - 2 * square(half_sine);
    const DVec3 across = safe_unit(end - dot(end, t.pivot) * t.pivot, DVec3(0));
    return safe_unit(cosine * t.pivot + sine * across, t.pivot);
}

}  // namespace tress
