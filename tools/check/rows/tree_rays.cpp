// SPDX-License-Identifier: MIT
#include "tools/check/rows/tree_rays.h"

#include "accel/build.h"
#include "accel/statistics.h"
#include "tools/check/support/kd_sets.h"
#include "tools/check/support/one_hair.h"
#include "tools/check/support/oracle_verdict.h"

namespace tress {
namespace {

using namespace scenes;

constexpr size_t kBatch = 16384;  // rays

/// Rays whose answers were held against brute force.
struct Tally {
    size_t rays = 0, hits = 0, wrong = 0, too_close = 0;

    void add(const KdTree& tree, const oracle::Scene& scene, const Rays& rays_of_batch, bool open_ends, Isa isa) {
        const RayBatch batch = rays_of_batch.batch();
        const oracle::Answers answers(tree, batch, isa);
        for (size_t i = 0; i < batch.size(); ++i) {
            const oracle::Verdict verdict = oracle::judge(scene, batch, i, answers, open_ends);
            wrong += verdict.fault != nullptr;
            too_close += verdict.too_close;
            hits += answers.nearest.id[i] != kNone;
        }
        rays += batch.size();
    }
    void add_figures(const std::string& what, std::vector<Figure>& to) const {
        const double percent = 100 / double(rays);
        to.push_back(exactly("wrong answers, of " + std::to_string(rays) + " rays" + what, double(wrong), 0));
        to.push_back(told("of these rays, hits", percent * double(hits), "%"));
        to.push_back(told("of these rays, with an edge within a thousandth of a radius, so that either answer is right",
                          percent * double(too_close), "%"));
    }
};

/// Mixed rays about the middle, batch after batch.
Tally tally_mixed(const SegmentView& view, const KdTree& tree, size_t rays, uint64_t seed, Isa isa) {
    Tally tally;
    const oracle::Scene scene(view);
    for (; tally.rays < rays; ++seed)
        tally.add(tree, scene, mixed_rays(std::min(kBatch, rays - tally.rays), Vec3(0), seed), view.linked, isa);
    return tally;
}

}  // namespace

Outcome measure_thin_hair_from_far(const CheckSettings& settings) {
    constexpr size_t kRays = 1000000;
    const FarErrors near = far_errors(3e4, kRays, settings.isa), far = far_errors(3e5, kRays, settings.isa);
    return {{at_most("wrong hits and misses at 3e4 radii, of 1e6 rays", 100 * near.wrong, 0.02, "%"),
             at_most("99th percentile of the error of t there", near.t_error, 0.01, "radii"),
             at_most("wrong hits and misses at 3e5 radii, of 1e6 rays", 100 * far.wrong, 0.5, "%"),
             told("99th percentile of the error of t there", far.t_error, "radii")},
            {}};
}

namespace {

/// Of which one end is a ball that holds the other.
Hair steep_cones(size_t n) {
    Hair hair;
    Dice dice(51);
    for (size_t i = 0; i < n; ++i) {
        const float thick = 0.05f + 0.15f * dice.unit(), thin = i % 4 ? 0.1f * thick * dice.unit() : 0;
        const float length = (0.02f + 0.95f * dice.unit()) * (thick - thin);
        const Vec3 start = dice.in_cube(), end = start + length * dice.direction();
        hair.add(start, end, i % 2 ? thick : thin, i % 2 ? thin : thick);
    }
    return hair;
}

}  // namespace

Outcome measure_steep_cones(const CheckSettings& settings) {
    const Hair hair = steep_cones(100);
    const KdTree tree = build_segment_tree(hair.view(), deep_options());
    Outcome outcome;
    tally_mixed(hair.view(), tree, 1000000, 52, settings.isa)
        .add_figures(" at 100 segments whose radii differ by more than their length", outcome.figures);
    return outcome;
}

namespace {

/// Rays whose own segment is skipped; how many of them meet it.
size_t met_when_skipped(const KdTree& tree, Rays rays, Isa isa) {
    rays.skip_first.assign(rays.size(), 0);
    rays.skip_last.assign(rays.size(), 0);
    size_t met = 0;
    for (const uint32_t id : nearest(tree, rays.batch(), isa).id) met += id != kNone;
    return met;
}

}  // namespace

Outcome measure_rays_along_the_axis(const CheckSettings& settings) {
    constexpr size_t kHairs = 100, kRaysEach = 3334;  // of each kind
    Dice dice(22);
    Losses along, through_tip, from_within;
    size_t met = 0;
    for (size_t k = 0; k < kHairs; ++k) {
        const Hair hair = one_hair(dice);
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Rays inner = rays_from_within(hair, kRaysEach, dice);
        add_losses(hair, tree, rays_along(hair, kRaysEach, dice), settings.isa, along);
        add_losses(hair, tree, rays_through_tip(hair, kRaysEach, dice), settings.isa, through_tip);
        add_losses(hair, tree, inner, settings.isa, from_within);
        met += met_when_skipped(tree, inner, settings.isa);
    }
    Outcome outcome;
    size_t too_close = 0, rays = 0;
    const auto add = [&](const char* kind, const Losses& l) {
        const std::string of = " of " + std::to_string(l.rays) + " rays " + kind;
        outcome.figures.push_back(exactly("lost hits" + of, double(l.lost), 0));
        outcome.figures.push_back(exactly("false hits" + of, double(l.false_hits), 0));
        too_close += l.too_close, rays += l.rays;
    };
    add("along the axis, both ways", along);
    add("through the tip", through_tip);
    add("from within: met where the axis is passed ahead", from_within);
    outcome.figures.push_back(exactly("rays from within that meet the segment they skip", double(met), 0));
    outcome.figures.push_back(told("rays too close to call", 100 * double(too_close) / double(rays), "%"));
    return outcome;
}

namespace {

/// A lattice of hair along all axes, a quarter apart.
SegmentSet lattice() {
    constexpr int kSide = 6;
    SegmentSet set = lattice_segments(kSide);
    for (std::vector<float>* axis : {&set.x, &set.y, &set.z})
        for (float& v : *axis) v = (v - kSide / 2) / 4;
    set.radius.assign(set.radius.size(), 0.01f);
    return set;
}

/// Splits at planes in which axes of the lattice lie.
size_t splits_on_lattice(const KdTree& tree) {
    size_t found = 0;
    for (const KdNode& node : tree.nodes)
        if (!node.is_leaf()) {
            const double plane = 4 * (double(node.split()) + tree.origin[int(node.axis())]);
            found += plane == std::round(plane);
        }
    return found;
}

}  // namespace

Outcome measure_hair_on_split_planes(const CheckSettings& settings) {
    constexpr size_t kRays = 333334;
    const SegmentSet set = lattice();
    const std::pair<SplitMethod, const char*> methods[] = {{SplitMethod::binned, "by bins"},
                                                           {SplitMethod::object_median, "at the object median"},
                                                           {SplitMethod::spatial_median, "at the spatial median"}};
    Outcome outcome;
    uint64_t seed = 53;
    for (const auto& [method, name] : methods) {
        const KdTree tree = build_segment_tree(set.view(), deep_options(method));
        const Tally tally = tally_mixed(set.view(), tree, kRays, seed, settings.isa);
        const std::string split = std::string(", split ") + name;
        outcome.figures.push_back(told("planes that axes lie in, of " + std::to_string(tree.nodes.size() / 2) + split,
                                       double(splits_on_lattice(tree))));
        outcome.figures.push_back(exactly("wrong answers, of " + std::to_string(kRays) + " rays at " +
                                              std::to_string(set.point.size()) + " segments" + split,
                                          double(tally.wrong), 0));
        outcome.figures.push_back(told("hits of these rays", 100 * double(tally.hits) / double(tally.rays), "%"));
        seed += 100;
    }
    return outcome;
}

namespace {

/// In the plane z = 1/4, or in a line of it.
Hair flat_hair(size_t n, bool in_line, float radius) {
    Hair hair;
    Dice dice(54);
    for (size_t i = 0; i < n; ++i) {
        const float x = 2 * float(i) / float(n) - 1;
        if (in_line) {
            hair.add(Vec3(x, 0.5f, 0.25f), Vec3(x + 2 / float(n), 0.5f, 0.25f), radius);
            continue;
        }
        Vec3 start = dice.in_cube(), way = dice.direction();
        start.z = 0.25f, way.z = 0;
        hair.add(start, start + 0.3f * way, radius);
    }
    return hair;
}

/// Rays at points near segments: from all sides, in the plane of the hair or near it, and along the line.
Rays rays_at_flat_hair(const Hair& hair, float radius, size_t count, uint64_t seed) {
    Rays rays;
    Dice dice(seed);
    const SegmentView view = hair.view();
    for (size_t i = 0; i < count; ++i) {
        const size_t s = size_t(dice.below(int(view.size())));
        const Vec3 target = glm::mix(view.start(s), view.end(s), dice.unit()) + 2 * radius * dice.in_cube();
        Vec3 d = dice.direction();
        if (i % 3 == 1) d = normalize(Vec3(d.x, d.y, 0));
        if (i % 3 == 2) d = Vec3(d.x < 0 ? -1 : 1, 0, 0);
        rays.add(target - (1 + 3 * dice.unit()) * d, d);
    }
    return rays;
}

}  // namespace

Outcome measure_flat_hair(const CheckSettings& settings) {
    constexpr size_t kSegments = 128, kRays = 400000;
    Outcome outcome;
    bool finite = true;
    double most = 0;
    for (const bool in_line : {false, true}) {
        for (const float radius : {kRadius, 1e-7f, 1e-30f, 0.0f}) {
            const Hair hair = flat_hair(kSegments, in_line, radius);
            for (const SplitMethod method : {SplitMethod::binned, SplitMethod::exact, SplitMethod::naive,
                                             SplitMethod::spatial_median, SplitMethod::object_median}) {
                const AccelOptions options = deep_options(method);
                const double cost = statistics(build_segment_tree(hair.view(), options), kSegments, options).sah_cost;
                finite &= std::isfinite(cost) && cost > 0;
                most = std::max(most, cost / double(kSegments));
            }
        }
    }
    outcome.figures.push_back(
        holds("the expected cost is finite and above 0 at radii of 0 to 0.004, by all five ways to split", finite));
    outcome.figures.push_back(told("largest expected cost, in those of a single leaf", most));
    for (const bool in_line : {false, true}) {
        const Hair hair = flat_hair(kSegments, in_line, kRadius);
        const KdTree tree = build_segment_tree(hair.view(), deep_options());
        const oracle::Scene scene(hair.view());
        Tally tally;
        for (uint64_t seed = 55; tally.rays < kRays; ++seed)
            tally.add(tree, scene, rays_at_flat_hair(hair, kRadius, std::min(kBatch, kRays - tally.rays), seed), false,
                      settings.isa);
        tally.add_figures(in_line ? " at hair in one line" : " at hair in one plane", outcome.figures);
    }
    return outcome;
}

}  // namespace tress
