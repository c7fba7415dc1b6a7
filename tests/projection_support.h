// SPDX-License-Identifier: MIT
// What the tests of projection share: hair made ready to be projected, what is seen of it, and what should be.
#pragma once

#include <doctest/doctest.h>

#include "accel/isa_targets.h"
#include "core/rng.h"
#include "core/sampling.h"
#include "gather/projection/hair_projection.h"
#include "tests/tufts.h"

namespace tress::test {

struct ProjectedHair {
    StrandSet strands;
    SegmentList list;
    Attenuation attenuation;
    HairProjection projection;

    SegmentView segments() const { return view(strands, list); }
};

/// Defaults, but for what is added of the gap between cells: nothing.
inline Options without_gap() {
    Options options;
    options.projection.gap = 0;
    return options;
}

inline ProjectedHair projected(StrandSet strands, Attenuation attenuation, ProjectionDetail detail,
                               const Options& options) {
    ProjectedHair hair;
    hair.list = list_segments(strands);
    hair.strands = std::move(strands);
    hair.attenuation = std::move(attenuation);
    hair.projection = make_hair_projection(hair.segments(), hair.attenuation, detail, options);
    return hair;
}

/// Lets through a fifth or so, and less at grazing inclinations.
inline Attenuation gray_fiber() { return {{make_attenuation_table(fiber_with(Rgb(0.8f)))}, {}, {}, {}}; }

/// Lets through exp(-depth) at every inclination.
inline Attenuation even_fiber(const Rgb& depth) {
    return {{AttenuationTable{std::vector<Rgb>(AttenuationTable::kRows, depth)}}, {}, {}, {}};
}

struct Cone {
    Vec3 a, b;
    float radius_a, radius_b;
};

/// Strands of one segment each.
inline StrandSet strands_of(const std::vector<Cone>& cones) {
    StrandSet strands;
    strands.first = {0};
    for (const Cone& cone : cones) {
        strands.add_point(cone.a), strands.add_point(cone.b);
        strands.radius.push_back(cone.radius_a), strands.radius.push_back(cone.radius_b);
        strands.first.push_back(uint32_t(strands.points()));
    }
    return strands;
}

inline constexpr Frame kUpright = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

inline Frame random_frame(uint64_t key) {
    const Frame f = frame_about(sample_uniform_sphere({random(key, 0), random(key, 1)}));
    const float angle = 2 * kPi * random(key, 2), c = std::cos(angle), s = std::sin(angle);
    return {c * f.x + s * f.y, c * f.y - s * f.x, f.z};
}

inline std::vector<Rgb> cells_of(const CellLight& light) {
    std::vector<Rgb> cells;
    for (uint32_t cell = 0; cell < light.cells; ++cell) cells.push_back(light.transmittance(cell));
    return cells;
}

/// Transmittance of every cell, which must be the same to the bit on all instruction sets.
inline std::vector<Rgb> seen(const ProjectedHair& hair, const Viewpoint& from, const Unseen& unseen = {}) {
    std::vector<Rgb> first;
    ProjectionScratch scratch;
    CellLight light;
    for (const Isa isa : supported_isas()) {
        CAPTURE(isa_name(isa));
        project(hair.projection, hair.segments(), from, unseen, isa, scratch, light);
        if (first.empty()) first = cells_of(light);
        REQUIRE(cells_of(light) == first);
    }
    REQUIRE(first.size() == hair.projection.igloo.cells_of(from.dome));
    return first;
}

inline double mean_of(const std::vector<Rgb>& cells) {
    double sum = 0;
    for (const Rgb& cell : cells) sum += double(mean(cell));
    return sum / double(cells.size());
}

inline double mean_difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(mean(a[i])) - double(mean(b[i])));
    return sum / double(a.size());
}

inline bool all_one(const std::vector<Rgb>& cells) {
    for (const Rgb& cell : cells)
        if (cell != Rgb(1)) return false;
    return true;
}

inline bool all_within_unit(const std::vector<Rgb>& cells) {
    for (const Rgb& cell : cells)
        if (!is_finite(cell) || min_component(cell) < 0 || max_component(cell) > 1) return false;
    return true;
}

/// What a segment lets through along a unit direction from a point, by the formula alone: all, unless the direction's
/// closest approach to the axis lies ahead, beside the axis, and within the radius that the fiber has there.
inline DVec3 through_segment(const SegmentView& hair, uint32_t segment, const Attenuation& attenuation,
                             const DVec3& from, const DVec3& w) {
    const DVec3 a = DVec3(hair.start(segment)) - from, axis = DVec3(hair.end(segment)) - DVec3(hair.start(segment));
    const double whole = length(axis), cosine = dot(w, axis) / whole, sine2 = 1 - cosine * cosine;
    if (!(sine2 > 1e-14)) return DVec3(1);
    const DVec3 u = axis / whole;
    const double aw = dot(a, w), au = dot(a, u);
    const double t = (aw - au * cosine) / sine2, s = (aw * cosine - au) / sine2;
    if (!(t > 0) || s < 0 || s > whole) return DVec3(1);
    const double radius = glm::mix(double(hair.start_radius(segment)), double(hair.end_radius(segment)), s / whole);
    const DVec3 off = a + s * u - t * w;
    if (dot(off, off) > radius * radius) return DVec3(1);
    return exp(-DVec3(attenuation.depth(segment, float(std::abs(cosine)))));
}

/// Mean over n x n jittered directions in each cell of what all segments let through.
inline std::vector<Rgb> expected(const ProjectedHair& hair, const Viewpoint& from, int n) {
    const Igloo& igloo = hair.projection.igloo;
    const SegmentView segments = hair.segments();
    std::vector<Rgb> cells;
    for (uint32_t cell = 0; cell < igloo.cells_of(from.dome); ++cell) {
        DVec3 sum(0);
        for (int i = 0; i < n * n; ++i) {
            const uint64_t key = hash(hash(21, cell), uint64_t(i));
            const Vec2 u((float(i / n) + random(key, 0)) / float(n), (float(i % n) + random(key, 1)) / float(n));
            const DVec3 w = normalize(DVec3(from.frame.to_world(direction_in(igloo, cell, u))));
            DVec3 through(1);
            for (uint32_t s = 0; s < segments.size(); ++s)
                through *= through_segment(segments, s, hair.attenuation, DVec3(from.position), w);
            sum += through;
        }
        cells.push_back(Rgb(sum / double(n * n)));
    }
    return cells;
}

/// Straight hair of one segment each, at random in the cube [-1, 1]^3.
inline StrandSet random_hair(int count, float length, float radius, uint64_t seed) {
    std::vector<Cone> cones;
    for (int i = 0; i < count; ++i) {
        const uint64_t key = hash(seed, uint64_t(i));
        const Vec3 middle = 2.0f * Vec3(random(key, 0), random(key, 1), random(key, 2)) - 1.0f;
        const Vec3 half = 0.5f * length * sample_uniform_sphere({random(key, 3), random(key, 4)});
        cones.push_back({middle - half, middle + half, radius, radius});
    }
    return strands_of(cones);
}

}  // namespace tress::test
