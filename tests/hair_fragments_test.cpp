// SPDX-License-Identifier: MIT
// One segment at a time, held against brute force in double.
#include "gather/shadow_maps/hair_fragments.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tools/check/support/hair_views.h"

using namespace tress;
using namespace tress::fragments;

namespace {

/// How wide the segments of a trial are, in texels from the axis.
struct Widths {
    double from, to;
};

/// A view of 48 texels a side and one segment of a few texels near its middle.
struct Trial {
    Hair hair;
    LightView view;
    double half_width;  // the greater, across the axis, texels
    double angle;       // its radius over its distance; parallel: 0
};
constexpr int kSize = 48;

Trial random_trial(Dice& dice, bool parallel, const Widths& widths) {
    Trial t;
    t.hair.linked = true;
    const double distance = 2 + 3 * double(dice.unit()), texel = 0.01 * distance;
    const Vec3 middle = dice.in_cube();
    t.view = random_view(dice, parallel, middle, distance, texel, kSize);
    const double width = widths.from * std::pow(widths.to / widths.from, double(dice.unit()));
    const float radius = float(width * texel), taper = 0.3f + 0.7f * dice.unit();
    const Vec3 start = middle + float(8 * texel) * dice.in_cube();
    Vec3 axis(0);
    do axis = dice.direction();
    while (std::abs(dot(axis, t.view.frame.z)) > 0.95f);
    t.hair.add(start, start + axis * float(texel) * (1 + 9 * dice.unit()), radius, radius * taper);
    t.half_width = width / 0.7;  // a texel may be that much lower than wide
    t.angle = parallel ? 0 : double(radius) / (0.9 * distance);
    return t;
}

/// Whether light through a place of the view meets the ribbon, as the hair tree has it: its closest approach to the
/// axis lies between the ends and within the radius there.
bool meets(const Trial& t, const glm::dvec2& place) {
    const SegmentView hair = t.hair.view();
    const DVec3 o = light_origin(t.view, place), d = light_through(t.view, place);
    const DVec3 start = DVec3(hair.start(0)) - o, axis = DVec3(hair.end(0)) - DVec3(hair.start(0));
    const DVec3 n = cross(d, axis);
    const double u = -dot(cross(d, start), n) / dot(n, n);
    if (u < 0 || u >= 1) return false;
    const double radius = double(hair.start_radius(0)) * (1 - u) + double(hair.end_radius(0)) * u;
    return std::abs(dot(start, n)) <= radius * length(n);
}

constexpr int kStrata = 64;  // a side of a texel

double covered(const Trial& t, int x, int y, uint64_t key) {
    int met = 0;
    for (int j = 0; j < kStrata; ++j)
        for (int i = 0; i < kStrata; ++i) {
            const uint64_t sample = uint64_t(j * kStrata + i);
            const double u = double(random(key, 2 * sample)), v = double(random(key, 2 * sample + 1));
            met += meets(t, {x + (i + u) / kStrata, y + (j + v) / kStrata});
        }
    return double(met) / (kStrata * kStrata);
}

/// The axis of a trial's segment in small steps: texels and depth.
struct AxisPoint {
    glm::dvec2 at;
    double depth;
};
std::vector<AxisPoint> axis_points(const Trial& t) {
    constexpr int kSteps = 2000;
    std::vector<AxisPoint> points;
    const SegmentView hair = t.hair.view();
    for (int k = 0; k <= kSteps; ++k) {
        const DVec3 p = mix(DVec3(hair.start(0)), DVec3(hair.end(0)), double(k) / kSteps) - t.view.origin;
        const DVec3 z(t.view.frame.z);
        const glm::dvec2 across(dot(p, DVec3(t.view.frame.x)), dot(p, DVec3(t.view.frame.y)));
        points.push_back(
            {(across / (t.view.parallel ? 1.0 : dot(p, z)) - t.view.low) / t.view.texel, dot(p, z) - t.view.start});
    }
    return points;
}

/// Range of the depth of the axis where the ribbon can be in a texel: no further from it than it is wide.
struct Range {
    double low = 1e300, high = -1e300;
};
Range depth_range(const std::vector<AxisPoint>& axis, double half_width, int x, int y) {
    Range range;
    const double reach = std::sqrt(2.0) * half_width + 0.02;  // steps are below 0.01 texels
    for (const AxisPoint& p : axis) {
        const glm::dvec2 out = abs(p.at - glm::dvec2(x + 0.5, y + 0.5)) - 0.5;
        if (std::max(out.x, out.y) > reach) continue;
        range.low = std::min(range.low, p.depth), range.high = std::max(range.high, p.depth);
    }
    return range;
}

/// Area of the ribbon in texels: of its corners, which stand out from the axis across it and across the light.
double projected_area(const Trial& t) {
    const SegmentView hair = t.hair.view();
    const DVec3 p[2] = {DVec3(hair.start(0)), DVec3(hair.end(0))};
    const DVec3 light = t.view.parallel ? DVec3(t.view.frame.z) : 0.5 * (p[0] + p[1]) - t.view.origin;
    const DVec3 across = normalize(cross(p[1] - p[0], light));
    const double r[2] = {double(hair.start_radius(0)), double(hair.end_radius(0))};
    glm::dvec2 corner[4];
    const DVec3 points[4] = {p[0] - r[0] * across, p[1] - r[1] * across, p[1] + r[1] * across, p[0] + r[0] * across};
    for (int k = 0; k < 4; ++k) {
        const DVec3 q = points[k] - t.view.origin;
        const double z = t.view.parallel ? 1 : dot(q, DVec3(t.view.frame.z));
        corner[k] = glm::dvec2(dot(q, DVec3(t.view.frame.x)), dot(q, DVec3(t.view.frame.y))) / z / t.view.texel;
    }
    double twice = 0;
    for (int k = 0; k < 4; ++k) {
        const glm::dvec2 a = corner[k], b = corner[(k + 1) % 4];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

/// Fragments of a texel: at most one, with one segment.
struct Found {
    double coverage = 0, depth = 0;
};
Found found_in(const ViewFragments& all, const LightView& view, int x, int y) {
    const ViewFragments::Range range = all.of(view, x, y);
    REQUIRE(range.last - range.first <= 1);
    if (range.first == range.last) return {};
    return {double(range.tile.opacity[0][range.first]), double(range.tile.depth[range.first])};
}

void check_trial(const Trial& t, uint64_t key, bool thin) {
    const ViewFragments all = project_all(t.view, t.hair.view(), opaque());
    const std::vector<AxisPoint> axis = axis_points(t);
    // An outline passes through at most some 3 strata for each of those along a side of the texel, twice; each of them
    // has a variance of at most 1/4. Five standard deviations.
    const double sampled = 5 * std::sqrt(6.0 * kStrata * 0.25) / (kStrata * kStrata);
    // Thin: an end along a column in place of one across the axis moves a triangle of w^2 / 4. Wide: in a pinhole's
    // view a ribbon whose width is seen under an angle a is off by a w at its ends, times the slant (sine <= 0.95).
    const double w = t.half_width;
    const double tolerance = sampled + (thin ? 0.5 * w * w : 0) + (t.view.parallel ? 0 : 1.5 * w * t.angle * 11);
    double sum = 0, depth_sum = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Found found = found_in(all, t.view, x, y);
            const Range range = depth_range(axis, w, x, y);
            CAPTURE(x);
            CAPTURE(y);
            sum += found.coverage;
            depth_sum += found.coverage * found.depth;
            if (range.low > range.high) {
                CHECK(found.coverage <= (thin ? 0.0 : tolerance));
                continue;
            }
            CHECK(std::abs(found.coverage - covered(t, x, y, hash(key, uint64_t(y * kSize + x)))) <= tolerance);
            if (found.coverage == 0) continue;
            const double rounding = 4 * 0x1p-24 * (std::abs(range.high) + t.view.start + 1);
            CHECK(found.depth >= range.low - rounding);
            CHECK(found.depth <= range.high + rounding);
        }
    const double area = projected_area(t);
    // Inside the view all of it; a pinhole's corners are those seen from the middle.
    CHECK(sum == doctest::Approx(area).epsilon(0.01));
    // Between the depths of the ends, nearer to that of the wider one.
    CHECK(depth_sum / sum >= std::min(axis.front().depth, axis.back().depth) - 1e-5);
    CHECK(depth_sum / sum <= std::max(axis.front().depth, axis.back().depth) + 1e-5);
}

}  // namespace

TEST_CASE("coverage, depth and area of a segment are those of its ribbon, by brute force") {
    for (const bool parallel : {true, false})
        for (const Widths& widths : {Widths{0.005, 0.17}, Widths{0.4, 4}}) {
            const bool thin = widths.to < 0.25;
            Dice dice(hash(31, uint64_t(parallel) + 2 * uint64_t(thin)));
            for (int trial = 0; trial < (thin ? 60 : 12); ++trial) {
                CAPTURE(parallel);
                CAPTURE(thin);
                CAPTURE(trial);
                check_trial(random_trial(dice, parallel, widths), hash(32, uint64_t(trial)), thin);
            }
        }
}

TEST_CASE("the area of thin hair in texels is that of its ribbon, whatever its way and the shape of texels") {
    for (const bool parallel : {true, false}) {
        Dice dice(33);
        for (int trial = 0; trial < 2000; ++trial) {
            const Trial t = random_trial(dice, parallel, {1e-4, 0.17});
            const ViewFragments all = project_all(t.view, t.hair.view(), opaque());
            double sum = 0;
            for (const FragmentTile& tile : all.tiles)
                for (const float c : tile.opacity[0]) sum += double(c);
            CAPTURE(parallel);
            CAPTURE(trial);
            CHECK(sum == doctest::Approx(projected_area(t)).epsilon(0.01));
        }
    }
}
