// SPDX-License-Identifier: MIT
// The hair tree against brute force in double precision, on ordinary and hostile sets.
#include <doctest/doctest.h>

#include "accel/build.h"
#include "tools/check/support/oracle_verdict.h"

using namespace tress;
using namespace tress::scenes;

namespace {

constexpr double kMostAmbiguous = 0.01;  // of the rays: two edges of a thousandth of a radius, some ten crossings

struct Case {
    std::string name;
    Hair (*make)(size_t, uint64_t);
    Vec3 middle;
};
Hair plain(size_t n, uint64_t seed) { return random_hair(n, seed); }
Hair tapered(size_t n, uint64_t seed) { return random_hair(n, seed, true); }
Hair linked(size_t n, uint64_t seed) { return strands(n / 10, 10, seed); }
const Case kCases[] = {
    {"random", plain, Vec3(0)},
    {"tapered", tapered, Vec3(0)},
    {"clumped", clumped_hair, Vec3(0)},
    {"lattice", lattice_hair, Vec3(0)},
    {"coincident", coincident_hair, Vec3(0)},
    {"far from the origin", far_hair, Vec3(1e4f, -1e4f, 0)},
    {"linked strands", linked, Vec3(0)},
};

/// Checks every answer on ray i, and returns whether it was too close to call.
bool check_ray(const oracle::Scene& scene, const Rays& rays, size_t i, const oracle::Answers& answers, bool open_ends) {
    CAPTURE(i);
    const oracle::Verdict verdict = oracle::judge(scene, rays.batch(), i, answers, open_ends);
    CHECK(std::string(verdict.fault ? verdict.fault : "") == "");
    return verdict.too_close;
}

void check_case(const Case& c, size_t segments, size_t count) {
    CAPTURE(c.name);
    const Hair hair = c.make(segments, 1);
    const SegmentView view = hair.view();
    const KdTree tree = build_segment_tree(view, AccelOptions{});
    const oracle::Scene scene(view);
    const Rays rays = mixed_rays(count, c.middle, 2);
    const oracle::Answers answers(tree, rays.batch());
    size_t ambiguous = 0, hits = 0;
    for (size_t i = 0; i < count; ++i) {
        ambiguous += check_ray(scene, rays, i, answers, hair.linked);
        hits += answers.nearest.id[i] != kNone;
    }
    MESSAGE(c.name << ": " << hits << " hits, " << answers.crossings.t.size() << " crossings, "
                   << 100.0 * double(ambiguous) / double(count) << " % of rays too close to call");
    CHECK(hits > count / 20);
    CHECK(double(ambiguous) <= kMostAmbiguous * double(count));
}

}  // namespace

TEST_CASE("what a ray meets is what brute force in double precision finds") {
    for (const Case& c : kCases) check_case(c, 10000, 2500);
}

TEST_SUITE("slow") {
    TEST_CASE("what 1e5 rays meet is what brute force in double precision finds") {
        for (const Case& c : kCases) check_case(c, 10000, 100000);
    }
}

TEST_CASE("every way to split gives the same answers") {
    const Hair hair = random_hair(2000, 3);
    const Rays rays = mixed_rays(2000, Vec3(0), 4);
    const oracle::Scene scene(hair.view());
    for (const SplitMethod split : {SplitMethod::binned, SplitMethod::exact, SplitMethod::naive,
                                    SplitMethod::spatial_median, SplitMethod::object_median}) {
        for (const bool clip : {true, false}) {
            for (const float cost : {1.0f, 20.0f}) {
                CAPTURE(int(split));
                CAPTURE(clip);
                CAPTURE(cost);
                AccelOptions options;
                options.split = split;
                options.clip = clip;
                options.traversal_cost = cost;
                const KdTree tree = build_segment_tree(hair.view(), options);
                const oracle::Answers answers(tree, rays.batch());
                for (size_t i = 0; i < rays.size(); i += 4) check_ray(scene, rays, i, answers, false);
            }
        }
    }
}
