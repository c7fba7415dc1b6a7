// SPDX-License-Identifier: MIT
// How much of the cells segments cover: over a horizon, and along great circles.
#include <algorithm>

#include "tools/check/rows/projection_rows.h"
#include "tools/check/support/cone_coverage.h"

namespace tress {
namespace {

using namespace test;

constexpr ProjectionDetail kDetails[] = {ProjectionDetail::all, ProjectionDetail::tree};

/// A tree of which every cube is opened, down to the pieces of hair themselves.
Options with_every_piece() {
    Options options = without_gap();
    options.projection.opening = 0.1f;
    return options;
}

/// The same sight, turned so that the segment crosses its horizon.
Viewpoint across_horizon(const Cone& cone, const Viewpoint& from, uint64_t key) {
    const Vec3 towards = normalize(glm::mix(cone.a, cone.b, 0.1f + 0.8f * random(key, 0)) - from.position);
    const Frame about = frame_about(towards);
    const float turn = 2 * kPi * random(key, 1);
    const Vec3 up = std::cos(turn) * about.x + std::sin(turn) * about.y;
    return {from.position, frame_about(up), Dome::sphere, {}};
}

Viewpoint upper_of(Viewpoint from) {
    from.dome = Dome::hemisphere;
    return from;
}
Viewpoint lower_of(Viewpoint from) {
    from.frame.y = -from.frame.y, from.frame.z = -from.frame.z;
    return upper_of(from);
}

/// Greatest errors of solid angles, steradian.
struct HorizonErrors {
    double sphere = 0, relative = 0, back_to_back = 0, largest = 0;

    void see(uint64_t key, ProjectionDetail detail, const Options& options, Isa isa) {
        const auto [cone, anywhere] = random_sight(key);
        const Viewpoint from = across_horizon(cone, anywhere, key);
        const ProjectedHair hair = faint(cone, detail, options);
        const auto found = [&](const Viewpoint& v) { return projected_solid_angle(hair, v, double(kFaint), isa); };
        const double exact = solid_angle(cone, from.position), whole = found(from);
        sphere = std::max(sphere, std::abs(whole - exact));
        relative = std::max(relative, std::abs(whole / exact - 1));
        back_to_back = std::max(back_to_back, std::abs(found(upper_of(from)) + found(lower_of(from)) - whole));
        largest = std::max(largest, exact);
    }
};

Outcome horizon(const CheckSettings& settings) {
    constexpr int kSights = 4000;
    HorizonErrors all, opened, tree;
    for (uint64_t i = 0; i < kSights; ++i) {
        all.see(hash(31, i), ProjectionDetail::all, without_gap(), settings.isa);
        if (i % 8 == 0) opened.see(hash(31, i), ProjectionDetail::tree, with_every_piece(), settings.isa);
        if (i % 8 == 0) tree.see(hash(31, i), ProjectionDetail::tree, without_gap(), settings.isa);
    }
    const std::string tried = ", " + std::to_string(kSights) + " sights";
    return {{at_most("solid angle over the sphere less that in closed form, every segment" + tried, all.sphere, 1e-5,
                     " sr"),
             at_most("hemispheres back to back less the sphere" + tried, all.back_to_back, 1e-5, " sr"),
             told("largest solid angle", all.largest, " sr"), told("error of itself", 100 * all.relative, "%"),
             told("error of a tree opened down to its pieces", opened.sphere, " sr"),
             told("error of a tree at its defaults", tree.sphere, " sr")},
            {}};
}

/// A segment at distance 1 that is seen as an arc of more than 90 degrees, somewhere about the point.
Cone long_arc(uint64_t key) {
    const auto inclination = [&](uint64_t i) { return glm::radians(46 + 42 * random(key, i)); };
    const float radius = 0.3f * std::pow(10.0f, -3 * random(key, 2));
    const Frame f = random_frame(hash(key, 3));
    return {f.z - std::tan(inclination(0)) * f.x, f.z + std::tan(inclination(1)) * f.x, radius, radius};
}

struct ArcErrors {
    double of_sphere = 0, of_touched = 0, worst_of_touched = 0;
    int arcs = 0;

    void see(uint64_t key, ProjectionDetail detail, int cells, Isa isa) {
        Options options = without_gap();
        options.projection.cells = cells;
        const Cone cone = long_arc(key);
        const ProjectedHair hair = faint(cone, detail, options);
        const Viewpoint from{Vec3(0), random_frame(key), Dome::sphere, {}};
        const std::vector<double> covered = coverage(hair, from, double(kFaint), isa);
        const std::vector<double> truth = sampled_coverage(hair.projection.igloo, cone, from, 100, 1000, key);
        double sum = 0;
        int touched = 0;
        for (size_t cell = 0; cell < covered.size(); ++cell) {
            sum += std::abs(covered[cell] - truth[cell]);
            touched += covered[cell] > 0 || truth[cell] > 0;
        }
        of_sphere = std::max(of_sphere, sum / double(covered.size()));
        of_touched += sum / touched;
        worst_of_touched = std::max(worst_of_touched, sum / touched);
        ++arcs;
    }
};

Outcome long_arcs(const CheckSettings& settings) {
    ArcErrors found;
    for (uint64_t i = 0; i < 20; ++i)
        for (const ProjectionDetail detail : kDetails)
            for (const int cells : {64, 256}) found.see(hash(12, i), detail, cells, settings.isa);
    return {{at_most("mean error of a cell's coverage against 1e5 samples, over the sphere, worst of " +
                         std::to_string(found.arcs) + " arcs",
                     100 * found.of_sphere, 1, "% of a cell"),
             at_most("likewise over the cells that an arc touches, mean of arcs", 100 * found.of_touched / found.arcs,
                     1, "% of a cell"),
             told("worst of arcs", 100 * found.worst_of_touched, "% of a cell")},
            {}};
}

}  // namespace

std::vector<CheckRow> coverage_rows() {
    return {{"D15", "segments across the horizon", "both hemispheres together see them once", horizon},
            {"D16", "segments seen as arcs of 92 to 176 degrees", "cells along the great circle, each by its share",
             long_arcs}};
}

}  // namespace tress
