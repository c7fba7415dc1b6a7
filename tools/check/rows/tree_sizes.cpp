// SPDX-License-Identifier: MIT
#include "tools/check/rows/tree_sizes.h"

#include <chrono>

#include "accel/build.h"
#include "accel/statistics.h"
#include "tools/check/support/kd_sets.h"
#include "tools/check/support/oracle_verdict.h"

namespace tress {
namespace {

using namespace scenes;

constexpr double kDeepest = 60;  // levels, whatever the options say
constexpr SplitMethod kMethods[] = {SplitMethod::binned, SplitMethod::exact, SplitMethod::naive,
                                    SplitMethod::spatial_median, SplitMethod::object_median};

/// Levels that the options allow a tree of so many primitives.
double depth_cap(size_t primitives, const AccelOptions& o) {
    return std::min(kDeepest, std::floor(double(o.depth_base + o.depth_factor * std::log2(float(primitives)))));
}

/// At the segment of coincident_segments.
Rays rays_at_identical(size_t count) {
    Rays rays;
    Dice dice(61);
    for (size_t i = 0; i < count; ++i) {
        const Vec3 target = dice.unit() * Vec3(1, 2, 3) + 0.02f * dice.in_cube(), d = dice.direction();
        rays.add(target - 5.0f * d, d);
    }
    return rays;
}

}  // namespace

Outcome measure_identical_segments(const CheckSettings& settings) {
    constexpr size_t kSegments = 1000000, kRays = 50;
    const SegmentSet set = coincident_segments(kSegments), one = coincident_segments(1);
    const AccelOptions options;
    const auto start = std::chrono::steady_clock::now();
    const KdTree tree = build_segment_tree(set.view(), options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const TreeStatistics s = statistics(tree, kSegments, options);
    const Rays rays = rays_at_identical(kRays);
    const Nearest of_all = nearest(tree, rays.batch(), settings.isa);
    const Nearest of_one = nearest(build_segment_tree(one.view(), options), rays.batch(), settings.isa);
    size_t different = 0, hits = 0;
    for (size_t i = 0; i < kRays; ++i) {
        different += of_all.t[i] != of_one.t[i] || of_all.id[i] != of_one.id[i] || of_all.u[i] != of_one.u[i] ||
                     of_all.h[i] != of_one.h[i];
        hits += of_all.id[i] != kNone;
    }
    return {{exactly("leaves", double(s.leaves), 1), at_most("depth", s.depth, depth_cap(kSegments, options)),
             at_most("references", double(s.references), double(kSegments)), at_most("build", seconds, 2, "s"),
             exactly("hits that are not those of a single segment, of " + std::to_string(kRays) + " rays",
                     double(different), 0),
             told("of these rays, hits", double(hits))},
            {}};
}

namespace {

/// Leaves that hold a segment.
size_t leaves_with(const KdTree& tree, uint32_t id) {
    size_t found = 0;
    for (const KdNode& node : tree.nodes) {
        if (!node.is_leaf()) continue;
        const std::vector<uint32_t> ids = leaf_ids(tree, node, segment_row::id);
        found += std::binary_search(ids.begin(), ids.end(), id);
    }
    return found;
}

/// Where splits are free, and every leaf is to hold one segment.
Figure references_at_the_cap() {
    const SegmentSet set = random_segments(2000, 2, 0.05f);
    AccelOptions options;
    options.traversal_cost = 0;
    options.automatic = false;
    options.leaf_size = 1;
    options.depth_base = float(kDeepest);
    double most = 0;
    for (const SplitMethod method : kMethods) {
        options.split = method;
        const TreeStatistics s = statistics(build_segment_tree(set.view(), options), set.point.size(), options);
        most = std::max(most, s.references_per_primitive);
    }
    constexpr double kMiscounted = 1.01;  // bins may count a reference on one side that ends up on both
    return at_most("references a segment where splits cost nothing and leaves hold one: accel.references, and 1 %",
                   most, kMiscounted * double(options.references));
}

}  // namespace

Outcome measure_one_long_segment(const CheckSettings&) {
    constexpr size_t kTiny = 1000000;
    SegmentSet set = random_segments(kTiny, 0.002f, 0.0005f);
    set.add({-1, -1, -1}, {1, 1, 1}, 0.01f);
    const AccelOptions options;
    const KdTree tree = build_segment_tree(set.view(), options);
    const TreeStatistics s = statistics(tree, set.point.size(), options);
    return {{at_most("references a segment at the defaults, one segment across 1e6 tiny ones",
                     s.references_per_primitive, 4),
             told("leaves that hold the long one, of " + std::to_string(s.leaves), double(leaves_with(tree, kTiny))),
             at_most("depth", s.depth, depth_cap(set.point.size(), options)), references_at_the_cap()},
            {}};
}

namespace {

/// Leaves as small as can be, at any depth.
AccelOptions deepest(SplitMethod method) {
    AccelOptions options = deep_options(method);
    options.automatic = false;
    options.leaf_size = 1;
    options.depth_base = 1000;
    return options;
}

/// Segments about a point, each 0.9 times as long as the one before and as much nearer; the smallest is still many
/// roundings thick.
SegmentSet shrinking_segments(int n) {
    SegmentSet set;
    Stream stream{62};
    for (int i = 0; i < n; ++i) {
        const float size = std::pow(0.9f, float(i % 50));
        const Vec3 start = size * stream.vector(-1, 1);
        set.add(start, start + size * stream.vector(-0.5f, 0.5f), 0.05f * size);
    }
    return set;
}

}  // namespace

Outcome measure_series_of_sizes(const CheckSettings& settings) {
    constexpr size_t kRays = 100000;
    const SegmentSet series = geometric_segments(100), shrinking = shrinking_segments(200);
    const AccelOptions defaults;
    double most = 0;
    for (const SplitMethod method : kMethods) {
        const AccelOptions options = deepest(method);
        const KdTree tree = build_segment_tree(series.view(), options);
        most = std::max(most, double(statistics(tree, series.point.size(), options).depth));
    }
    const size_t n = series.point.size();
    const double usual = statistics(build_segment_tree(series.view(), defaults), n, defaults).depth;

    const AccelOptions options = deepest(SplitMethod::binned);
    const KdTree deep = build_segment_tree(shrinking.view(), options);
    const oracle::Scene scene(shrinking.view());
    const Rays rays = mixed_rays(kRays, Vec3(0), 63);
    const oracle::Answers answers(deep, rays.batch(), settings.isa);
    size_t wrong = 0, hits = 0;
    for (size_t i = 0; i < kRays; ++i) {
        wrong += oracle::judge(scene, rays.batch(), i, answers, false).fault != nullptr;
        hits += answers.nearest.id[i] != kNone;
    }
    return {{at_most("levels at the defaults of " + std::to_string(n) + " segments of sizes 1 to 2^-99", usual,
                     depth_cap(n, defaults)),
             at_most("levels where the options set no limit, by all five ways to split", most, kDeepest),
             told("levels of a tree of sizes 1 to 0.006 so built",
                  double(statistics(deep, shrinking.point.size(), options).depth)),
             exactly("wrong answers of that tree, of 100,000 rays", double(wrong), 0),
             told("of these rays, hits", double(hits))},
            {}};
}

namespace {

constexpr float kWide = 0.01f;  // radius

KdTree straight_strand(int segments) {
    Hair hair;
    std::vector<Vec3> corners;
    for (int i = 0; i <= segments; ++i) corners.push_back(Vec3(2 * float(i) / float(segments) - 1, 0, 0));
    hair.add_strand(corners, kWide);
    return build_segment_tree(hair.view(), AccelOptions{});
}

/// How wide the shadow of a hair along x is on the plane z = -`below`, by parallel light or from z = `light`.
double shadow_width(const KdTree& tree, double below, double light, Isa isa) {
    constexpr size_t kPlaces = 200001;
    const double across = 4 * double(kWide) * (light > 0 ? (light + below) / light : 1);  // that is looked at
    Rays rays;
    for (size_t i = 0; i < kPlaces; ++i) {
        const Vec3 place(0.013f, float(across * (double(i) / (kPlaces - 1) - 0.5)), float(-below));
        rays.add(place, light > 0 ? Vec3(place.x, 0, float(light)) - place : Vec3(0, 0, 1), 0,
                 light > 0 ? 1 : kInfinity);
    }
    size_t dark = 0;
    for (const uint32_t n : constant(tree, rays.batch(), 0.5f, 0, isa).crossings) dark += n == 1;
    return across * double(dark) / kPlaces;
}

}  // namespace

Outcome measure_single_hair(const CheckSettings& settings) {
    constexpr double kBelow = 0.5, kLight = 0.1;
    constexpr double kTolerance = 1e-4;  // relative: places are 2e-5 of a width apart
    const double radius = double(kWide);
    const double parallel = 2 * radius, near = 2 * (kLight + kBelow) * std::tan(std::asin(radius / kLight));
    Outcome outcome;
    for (const int segments : {1, 8}) {
        const KdTree tree = straight_strand(segments);
        const std::string of = segments == 1 ? " of one segment" : " of a strand of 8 segments";
        const auto add = [&](const char* what, double light, double width) {
            outcome.figures.push_back(within("width of the shadow" + of + what,
                                             shadow_width(tree, kBelow, light, settings.isa), width,
                                             kTolerance * width));
        };
        outcome.figures.push_back(exactly("nodes" + of, double(tree.nodes.size()), 1));
        add(" by parallel light, expected 2 r", 0, parallel);
        add(" by a lamp 10 radii away, expected 2 (l + d) tan(asin(r / l))", kLight, near);
    }
    return outcome;
}

}  // namespace tress
