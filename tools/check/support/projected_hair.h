// SPDX-License-Identifier: MIT
// Hair made ready to be projected, what is seen of it from a point, and what should be.
#pragma once

#include "core/rng.h"
#include "core/sampling.h"
#include "gather/projection/hair_projection.h"
#include "tools/check/support/tufts.h"

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

/// A straight fiber along x from 0 on, cut into segments.
inline StrandSet straight_fiber(int segments, float segment, float radius) {
    StrandSet strands;
    strands.constant_radius = radius;
    for (int i = 0; i <= segments; ++i) strands.add_point({segment * float(i), 0, 0});
    strands.first = {0, uint32_t(strands.points())};
    return strands;
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

inline constexpr Frame kUpright = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// By an angle about its z: a hemisphere stays the same one.
inline Frame turned_about_z(const Frame& f, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * f.x + s * f.y, c * f.y - s * f.x, f.z};
}

inline Frame random_frame(uint64_t key) {
    return turned_about_z(frame_about(sample_uniform_sphere({random(key, 0), random(key, 1)})),
                          2 * kPi * random(key, 2));
}

/// What a point on a segment does not see: its own fiber.
inline Unseen unseen_on(const SegmentView& hair, uint32_t segment) {
    const SegmentRange range = own_strand(hair, segment);
    return {range.first, range.last, bounds(hair, range)};
}

inline std::vector<Rgb> cells_of(const CellLight& light) {
    std::vector<Rgb> cells;
    for (uint32_t cell = 0; cell < light.cells; ++cell) cells.push_back(light.transmittance(cell));
    return cells;
}

/// Transmittance of every cell.
inline std::vector<Rgb> seen_with(Isa isa, const ProjectedHair& hair, const Viewpoint& from,
                                  const Unseen& unseen = {}) {
    ProjectionScratch scratch;
    CellLight light;
    project(hair.projection, hair.segments(), from, unseen, isa, scratch);
    find_light(hair.projection, from, isa, scratch, light);
    return cells_of(light);
}

/// What gray hair sums to in a cell where no two fibers hide each other: depths, and the shares that near hair stops.
inline double summed(const ProjectionScratch& scratch, size_t cell) {
    return double(scratch.gray.sum(cell)) + double(scratch.near.cells[cell].stopped[0]);
}

inline double mean_of(const std::vector<Rgb>& cells) {
    double sum = 0;
    for (const Rgb& cell : cells) sum += double(mean(cell));
    return sum / double(cells.size());
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

}  // namespace tress::test
