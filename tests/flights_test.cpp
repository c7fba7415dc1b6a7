// SPDX-License-Identifier: MIT
// Flights through hair: what a ray crosses, in order, with what is left of its light, up to a cutoff.
#include <doctest/doctest.h>

#include "accel/build.h"
#include "tools/check/support/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

Attenuation grey_and_coloured() {
    Attenuation a;
    a.table.resize(1);
    for (int row = 0; row < AttenuationTable::kRows; ++row)
        a.table[0].depth.push_back(Rgb(0.2f, 0.4f, 0.9f) * (2 - float(row) / AttenuationTable::kRows));
    return a;
}

/// Thick enough that a ray crosses a dozen.
Hair thick(Hair hair) {
    for (float& radius : hair.points.radius) radius *= 16;
    return hair;
}

/// Cutoffs of rays in turn: all crossings, few, none, one of a kind each.
std::vector<float> mixed_cutoffs(size_t rays) {
    constexpr float kCutoffs[] = {0, 1e-6f, 1e-3f, 0.3f, 1};
    std::vector<float> cutoff(rays);
    for (size_t i = 0; i < rays; ++i) cutoff[i] = kCutoffs[i % std::size(kCutoffs)];
    return cutoff;
}

Flights fly(const KdTree& tree, const RayBatch& rays, std::span<const float> cutoff, Isa isa = Isa::automatic) {
    Flights found;
    flights(tree, rays, grey_and_coloured(), cutoff, found, isa);
    return found;
}

bool same(const Flights& a, const Flights& b) {
    const Crossings &p = a.crossings, &q = b.crossings;
    return p.first == q.first && p.t == q.t && p.u == q.u && p.h == q.h && p.id == q.id && a.before == b.before &&
           a.after == b.after;
}

/// |sin theta| of a ray to a segment, in double.
double abs_sine(const SegmentView& view, uint32_t segment, const Vec3& direction) {
    const DVec3 axis = DVec3(view.end(segment)) - DVec3(view.start(segment)), d(direction);
    return std::abs(dot(axis, d)) / (length(axis) * length(d));
}

/// Of t, by where in space the test of a segment is set up: a few roundings of a scene 20 across, over the sine between
/// ray and axis.
double rounding_of_t(const SegmentView& view, uint32_t segment, const Rays& rays, size_t i) {
    const Vec3 direction(rays.dx[i], rays.dy[i], rays.dz[i]);
    const double sine = std::sqrt(std::max(1 - square(abs_sine(view, segment, direction)), 1e-6));
    return 16 * 0x1p-24 * 20 / (sine * double(length(direction)));
}

/// Holds the flight of ray i against the list of all its crossings; returns how many it has.
size_t check_flight(const Flights& flight, const Crossings& all, const SegmentView& view, const Rays& rays, size_t i,
                    double cutoff) {
    CAPTURE(i);
    CAPTURE(cutoff);
    const Crossings& own = flight.crossings;
    const uint64_t first = own.first[i], count = own.first[i + 1] - first;
    const uint64_t listed = all.first[i + 1] - all.first[i];
    REQUIRE(count <= listed);
    const Attenuation attenuation = grey_and_coloured();
    const Vec3 direction(rays.dx[i], rays.dy[i], rays.dz[i]);
    glm::dvec3 depth(0);
    for (uint64_t k = 0; k < count; ++k) {
        const uint64_t mine = first + k, other = all.first[i] + k;
        CHECK(own.t[mine] == all.t[other]);
        CHECK(own.id[mine] == all.id[other]);
        CHECK(own.u[mine] == all.u[other]);
        CHECK(own.h[mine] == all.h[other]);
        const float left = max_component(flight.before[mine]);
        CHECK(double(left) >= cutoff);  // none after the ray is dark; rounded as the cutoff is
        // The table is steepest near grazing, where the cosine takes up to 3e-4 (half the bits) of rounding of the
        // sine: 5e-4 relative a crossing.
        const auto close = [&](const Rgb& value) {
            for (int c = 0; c < 3; ++c) CHECK(double(value[c]) == doctest::Approx(std::exp(-depth[c])).epsilon(5e-4));
        };
        close(flight.before[mine]);
        depth += glm::dvec3(attenuation.depth(own.id[mine], float(abs_sine(view, own.id[mine], direction))));
        close(flight.after[mine]);
        if (k > 0) CHECK(flight.before[mine] == flight.after[mine - 1]);
    }
    if (count > 0) CHECK(flight.before[first] == Rgb(1));
    if (count < listed) {  // then the last one took it below, or it started there
        const Rgb left = count > 0 ? flight.after[first + count - 1] : Rgb(1);
        CHECK(double(max_component(left)) <= cutoff * (1 + 1e-6));
    }
    return count;
}

}  // namespace

TEST_CASE("a flight is the start of the list of crossings, up to its cutoff, with the transmittance before and after") {
    for (const bool linked : {false, true}) {
        CAPTURE(linked);
        const Hair hair = thick(linked ? strands(400, 10, 11) : random_hair(4000, 11, true));
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Rays rays = mixed_rays(3000, Vec3(0), 12);
        const std::vector<float> cutoff = mixed_cutoffs(rays.size());
        const Flights flight = fly(tree, rays.batch(), cutoff);
        const Crossings all = crossings(tree, rays.batch(), Isa::automatic);
        size_t found = 0, cut = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const size_t count = check_flight(flight, all, hair.view(), rays, i, double(cutoff[i]));
            found += count;
            cut += count < all.first[i + 1] - all.first[i];
            if (cutoff[i] == 0) CHECK(count == all.first[i + 1] - all.first[i]);
        }
        CHECK(found > rays.size());
        CHECK(cut > rays.size() / 20);
    }
}

TEST_CASE("what is left after a whole flight is the transmittance of the ray") {
    const Hair hair = thick(random_hair(3000, 13));
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const Rays rays = mixed_rays(2000, Vec3(0), 14);
    const Flights flight = fly(tree, rays.batch(), std::vector<float>(rays.size(), 0.0f));
    std::vector<Rgb> whole(rays.size());
    transmittance(tree, rays.batch(), grey_and_coloured(), 0, whole, Isa::automatic);
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(i);
        const auto& first = flight.crossings.first;
        const Rgb left = first[i] < first[i + 1] ? flight.after[first[i + 1] - 1] : Rgb(1);
        // Sums in double of the same depths in another order: they round to neighbouring floats at most.
        for (int c = 0; c < 3; ++c) CHECK(double(left[c]) == doctest::Approx(double(whole[i][c])).epsilon(2.4e-7));
    }
}

TEST_CASE("parameters of the tree do not change a flight") {
    const Hair hair = thick(random_hair(2000, 15));
    const Rays rays = mixed_rays(1500, Vec3(0), 16);
    const std::vector<float> cutoff = mixed_cutoffs(rays.size());
    const Flights usual = fly(build_segment_tree(hair.view(), AccelOptions{}), rays.batch(), cutoff);
    for (const float cost : {1.0f, 200.0f})
        for (const SplitMethod split : {SplitMethod::binned, SplitMethod::spatial_median}) {
            CAPTURE(cost);
            CAPTURE(int(split));
            AccelOptions options;
            options.traversal_cost = cost;
            options.split = split;
            const Flights other = fly(build_segment_tree(hair.view(), options), rays.batch(), cutoff);
            REQUIRE(other.crossings.first == usual.crossings.first);
            CHECK(other.crossings.id == usual.crossings.id);
            CHECK(other.before == usual.before);
            CHECK(other.after == usual.after);
            for (size_t i = 0; i < rays.size(); ++i)
                for (uint64_t k = usual.crossings.first[i]; k < usual.crossings.first[i + 1]; ++k)
                    CHECK(std::abs(other.crossings.t[k] - usual.crossings.t[k]) <=
                          rounding_of_t(hair.view(), usual.crossings.id[k], rays, i));
        }
}

TEST_CASE("every instruction set flies the same way, bit for bit") {
    for (const bool linked : {false, true}) {
        const Hair hair = thick(linked ? strands(300, 10, 17) : random_hair(3000, 17, true));
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Rays rays = mixed_rays(3000, Vec3(0), 18);
        const std::vector<float> cutoff = mixed_cutoffs(rays.size());
        const Flights scalar = fly(tree, rays.batch(), cutoff, Isa::scalar);
        for (const Isa isa : supported_isas()) {
            CAPTURE(int(isa));
            CHECK(same(fly(tree, rays.batch(), cutoff, isa), scalar));
        }
    }
}

TEST_CASE("flights found before are forgotten, and rays without a tree cross nothing") {
    const Hair hair = random_hair(500, 19);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const Rays rays = mixed_rays(200, Vec3(0), 20);
    const std::vector<float> cutoff(rays.size(), 1e-3f);
    const Flights fresh = fly(tree, rays.batch(), cutoff);
    Flights used = fresh;
    flights(tree, rays.batch(), grey_and_coloured(), cutoff, used, Isa::automatic);
    CHECK(same(used, fresh));
    flights(KdTree{}, rays.batch(), grey_and_coloured(), cutoff, used, Isa::automatic);
    CHECK(used.crossings.first == std::vector<uint64_t>(rays.size() + 1, 0));
    CHECK(used.crossings.t.empty());
    CHECK(used.before.empty());
    CHECK(used.after.empty());
}
