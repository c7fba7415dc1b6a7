// SPDX-License-Identifier: MIT
// The hair tree against brute force in double precision, on ordinary and hostile sets.
#include <doctest/doctest.h>

#include <map>

#include "accel/build.h"
#include "tests/oracle.h"
#include "tests/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

constexpr float kTransmission = 0.7f;
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
bool check_ray(const oracle::Scene& scene, const Rays& rays, size_t i, const Nearest& nearest, const Constant& constant,
               const Crossings& crossings, bool open_ends) {
    CAPTURE(i);
    const oracle::Ray ray = oracle::ray_of(rays.batch(), i);
    const std::vector<oracle::Approach> near = oracle::approaches(scene, ray);

    double surely_before = kInfinity, tolerance = 0;
    const oracle::Approach* hit = nullptr;
    uint32_t fewest = 0, most = 0;
    for (const oracle::Approach& a : near) {
        if (oracle::surely(a, ray, false) && a.t + a.tolerance < surely_before) {
            surely_before = a.t + a.tolerance;
            tolerance = a.tolerance;
        }
        if (a.id == nearest.id[i] && oracle::possibly(a, ray, false)) hit = &a;
        fewest += oracle::surely(a, ray, open_ends);
        most += oracle::possibly(a, ray, open_ends);
    }
    if (nearest.id[i] == kNone) {
        CHECK(surely_before == kInfinity);
        CHECK(nearest.t[i] == kInfinity);
    } else {
        REQUIRE(hit);
        CHECK(nearest.t[i] <= surely_before + tolerance);
        CHECK(std::abs(nearest.t[i] - hit->t) <= hit->tolerance);
        // Along the axis, h is the whole offset; at a round end, a part of it; and of a parallel ray it says nothing.
        if (hit->u == hit->u_line && hit->sine > 1e-3)
            CHECK(std::abs(std::abs(nearest.h[i]) - std::min(hit->offset, 1.0)) <= 2 * oracle::kEdge);
    }

    const uint64_t first = crossings.first[i], last = crossings.first[i + 1];
    CHECK(constant.crossings[i] >= fewest);
    CHECK(constant.crossings[i] <= most);
    CHECK(last - first == constant.crossings[i]);
    CHECK(constant.transmittance[i] ==
          doctest::Approx(std::pow(double(kTransmission), constant.crossings[i])).epsilon(1e-6));
    for (uint64_t k = first; k + 1 < last; ++k)
        CHECK((crossings.t[k] < crossings.t[k + 1] ||
               (crossings.t[k] == crossings.t[k + 1] && crossings.id[k] < crossings.id[k + 1])));
    return fewest != most;
}

void check_case(const Case& c, size_t segments, size_t count) {
    CAPTURE(c.name);
    const Hair hair = c.make(segments, 1);
    const SegmentView view = hair.view();
    const KdTree tree = build_segment_tree(view, AccelOptions{});
    const oracle::Scene scene(view);
    const Rays rays = mixed_rays(count, c.middle, 2);
    const Nearest found = nearest(tree, rays.batch());
    const Constant through = constant(tree, rays.batch(), kTransmission, 0);
    const Crossings listed = crossings(tree, rays.batch(), Isa::automatic);
    size_t ambiguous = 0, hits = 0;
    for (size_t i = 0; i < count; ++i) {
        ambiguous += check_ray(scene, rays, i, found, through, listed, hair.linked);
        hits += found.id[i] != kNone;
    }
    MESSAGE(c.name << ": " << hits << " hits, " << listed.t.size() << " crossings, "
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
                const Nearest found = nearest(tree, rays.batch());
                const Constant through = constant(tree, rays.batch(), kTransmission, 0);
                const Crossings listed = crossings(tree, rays.batch(), Isa::automatic);
                for (size_t i = 0; i < rays.size(); i += 4) check_ray(scene, rays, i, found, through, listed, false);
            }
        }
    }
}
