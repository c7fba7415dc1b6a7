// SPDX-License-Identifier: MIT
// Which share of each cell about a point a segment covers: as projected, and in double without any of it.
#pragma once

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "tools/check/support/projected_hair.h"

namespace tress::test {

/// A segment as it is seen from a point. It covers the lune between half planes through its axis, of half angle
/// asin(radius / perpendicular), cut where its ends are seen (gather/projection/arcs.h).
struct ConeSight {
    DVec3 u, n;         // along the axis; to the foot of the perpendicular
    double s1, s2;      // places of the ends along the axis, from the foot
    double foot, half;  // length of the perpendicular; half angle

    ConeSight(const Cone& cone, const Vec3& from) {
        const DVec3 a = DVec3(cone.a) - DVec3(from), axis = DVec3(cone.b) - DVec3(cone.a);
        u = normalize(axis);
        s1 = dot(a, u), s2 = s1 + length(axis);
        foot = length(a - s1 * u);
        n = (a - s1 * u) / foot;
        half = std::asin(std::min(double(cone.radius_a) / foot, 1.0));
    }
    /// Sines of the inclinations of the ends, at an angle about the axis.
    std::pair<double, double> sines(double angle) const {
        const double here = foot * std::cos(angle);
        return {s1 / std::hypot(s1, here), s2 / std::hypot(s2, here)};
    }
};

/// Solid angle of the lune: the integral of the difference of the sines over angles.
inline double solid_angle(const Cone& cone, const Vec3& from) {
    const ConeSight sight(cone, from);
    constexpr int kSteps = 64;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const auto [low, high] = sight.sines(sight.half * ((2 * i + 1.0) / kSteps - 1));
        sum += high - low;
    }
    return sum * 2 * sight.half / kSteps;
}

/// The cell of a unit direction in the frame of the igloo, by its height and azimuth in double.
inline uint32_t cell_by_angles(const Igloo& igloo, const DVec3& direction) {
    const double below = igloo.cells * (1 - std::abs(direction.z));
    const auto next = std::upper_bound(igloo.row_first.begin() + 1, igloo.row_first.end() - 1, below);
    const uint32_t first = *(next - 1), count = *next - first;
    const double turn = std::atan2(direction.y, direction.x) / (2 * std::numbers::pi);
    const uint32_t column = std::min(uint32_t((turn < 0 ? turn + 1 : turn) * count), count - 1);
    return first + column + (direction.z < 0 ? igloo.cells : 0);
}

/// Share of each cell of the sphere that a segment covers, by around x along jittered directions of its lune.
inline std::vector<double> sampled_coverage(const Igloo& igloo, const Cone& cone, const Viewpoint& from, int around,
                                            int along, uint64_t seed) {
    const ConeSight sight(cone, from.position);
    const auto turned = [&](const DVec3& v) {
        return DVec3(dot(v, DVec3(from.frame.x)), dot(v, DVec3(from.frame.y)), dot(v, DVec3(from.frame.z)));
    };
    const DVec3 u = turned(sight.u), n = turned(sight.n), b = cross(u, n);
    const double per_sample = 2 * sight.half / around / along * igloo.cells / (2 * std::numbers::pi);
    std::vector<double> covered(igloo.cells_of(Dome::sphere));
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < along; ++j) {
            const uint64_t key = hash(seed, uint64_t(i) << 32 | uint64_t(j));
            const double angle = sight.half * (2 * (i + double(random(key, 0))) / around - 1);
            const auto [low, high] = sight.sines(angle);
            const double sine = glm::mix(low, high, (j + double(random(key, 1))) / along);
            const DVec3 across = std::cos(angle) * n + std::sin(angle) * b;
            const DVec3 direction = sine * u + std::sqrt(std::max(1 - sine * sine, 0.0)) * across;
            covered[cell_by_angles(igloo, direction)] += per_sample * (high - low);
        }
    }
    return covered;
}

/// A depth so small that what is stopped of a cell's light is its share covered, to a millionth of itself.
inline constexpr float kFaint = 1e-6f;

inline ProjectedHair faint(const Cone& cone, ProjectionDetail detail, const Options& options) {
    return projected(strands_of({cone}), even_fiber(Rgb(kFaint)), detail, options);
}

/// Share of each cell that hair of the same small depth everywhere covers, as projected.
inline std::vector<double> coverage(const ProjectedHair& hair, const Viewpoint& from, double depth,
                                    Isa isa = Isa::automatic) {
    ProjectionScratch scratch;
    CellLight light;
    project(hair.projection, hair.segments(), from, {}, isa, scratch);
    find_light(hair.projection, from, isa, scratch, light);
    std::vector<double> covered(light.cells);
    for (size_t cell = 0; cell < light.cells; ++cell) covered[cell] = summed(scratch, cell) / -std::expm1(-depth);
    return covered;
}

inline double projected_solid_angle(const ProjectedHair& hair, const Viewpoint& from, double depth,
                                    Isa isa = Isa::automatic) {
    double sum = 0;
    for (const double share : coverage(hair, from, depth, isa)) sum += share;
    return sum * double(hair.projection.igloo.solid_angle());
}

/// A segment of length 1 about the origin, and a point 3 radii to 1000 lengths from it, not along its axis.
inline std::pair<Cone, Viewpoint> random_sight(uint64_t key) {
    const float radius = 0.05f * std::exp2(-6 * random(key, 0));
    const Vec3 half = 0.5f * sample_uniform_sphere({random(key, 1), random(key, 2)});
    const float distance = 3 * radius * std::pow(1000 / (3 * radius), random(key, 3));
    const float along = (2 * random(key, 4) - 1) * (0.5f + distance), turn = 2 * kPi * random(key, 5);
    const Frame about = frame_about(2.0f * half);
    const Vec3 from = along * about.z + distance * (std::cos(turn) * about.x + std::sin(turn) * about.y);
    return {{-half, half, radius, radius}, {from, random_frame(hash(key, 6)), Dome::sphere}};
}

}  // namespace tress::test
