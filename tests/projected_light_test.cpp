// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "accel/isa_targets.h"
#include "core/rng.h"
#include "core/type_shares.h"
#include "tools/check/support/small_scenes.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

Options type2_by(GatherMethod method, ProjectionDetail detail = ProjectionDetail::tree) {
    Options options = small_options();
    options.type1 = LampMethod::off;
    options.type3 = CrossingMethod::off;
    options.type2 = method;
    options.projection.detail = detail;
    options.projection.cells = 256;
    options.projection.directions = 16;
    options.spp = 16;
    return options;
}

/// Upright fibers, through the given x, z, and a square at z = 0, under a sky.
Scene fibers_and_wall(const std::vector<Vec2>& xz, float radius, bool wall, const Rgb& sky) {
    const PlacedHair hair = upright_fibers(xz, 0.5f, radius, make_fiber({.sigma_a = Rgb(0.2f, 0.4f, 0.8f)}));
    std::vector<PlacedMesh> meshes;
    if (wall) meshes.push_back(square(0.8f, Rgb(0.6f, 0.5f, 0.4f)));
    return assemble({hair}, meshes, {EnvironmentLight{"", {}, sky, 0}}, camera_on_z(4, 25, 24));
}

/// Some hundred fibers before the square.
Scene hair_before_wall(bool wall, const Rgb& sky) {
    std::vector<Vec2> xz;
    for (int i = 0; i < 300; ++i) xz.push_back({float(i % 30) * 0.03f - 0.45f, 0.3f + float(i / 30) * 0.05f});
    return fibers_and_wall(xz, 0.006f, wall, sky);
}

/// Some thousand thin fibers anywhere on both sides of the square.
Scene hair_around_wall() {
    std::vector<Vec2> xz;
    for (uint64_t i = 0; i < 2000; ++i)
        xz.push_back({random(hash(7, i), 0) * 0.9f - 0.45f, random(hash(7, i), 1) * 0.5f - 0.125f});
    return fibers_and_wall(xz, 0.0015f, true, Rgb(1));
}

TypeShare type2_of(const Rendered& r) {
    for (const TypeShare& share : type_shares(r.state.film, ShareOf::picture))
        if (share.type == PathType::type2) return share;
    return {};
}

HairProjection projection_of(const Scene& scene, const Options& options) {
    return prepare(scene, make_plan(scene, options), options).projection;
}

bool same_pixels(const Rendered& a, const Rendered& b) { return a.layer("type2")->data == b.layer("type2")->data; }

}  // namespace

TEST_CASE("light by projection is light by rays, with polygons and without") {
    for (const bool wall : {false, true})
        for (const ProjectionDetail detail : {ProjectionDetail::all, ProjectionDetail::tree}) {
            CAPTURE(wall);
            CAPTURE(int(detail));
            const Scene scene = hair_before_wall(wall, Rgb(1, 0.9f, 0.8f));
            const TypeShare rays = type2_of(render(scene, type2_by(GatherMethod::ray)));
            const TypeShare cells = type2_of(render(scene, type2_by(GatherMethod::projection, detail)));
            const double sigma = std::hypot(rays.mean_error, cells.mean_error);
            // Three standard errors, and the error of the cells, of which calibration leaves below 1 %.
            CHECK(std::abs(cells.mean - rays.mean) < 3 * sigma + 0.01 * rays.mean);
        }
}

TEST_CASE("what gaps between cells are worth is found apart at hair and at polygons among it, and leaves no bias") {
    const Scene scene = hair_around_wall();
    for (const ProjectionDetail detail : {ProjectionDetail::all, ProjectionDetail::tree}) {
        CAPTURE(int(detail));
        const auto projected = [&](float gap, float scatter = 0) {
            Options options = type2_by(GatherMethod::projection, detail);
            options.projection.cells = 64;
            options.projection.gap = gap;
            options.projection.scatter = scatter;
            return projection_of(scene, options);
        };
        const HairProjection without = projected(0), found = projected(-1);
        for (const Dome dome : {Dome::sphere, Dome::hemisphere}) {
            CAPTURE(int(dome));
            REQUIRE(found.gap(dome).error.points > 0);
            CHECK(without.gap(dome).shares.gap == 0);
            // By one step of the secant: what is not linear in the gap is left.
            CHECK(std::abs(found.gap(dome).error.bias) < 0.02 * std::abs(without.gap(dome).error.bias));
            CHECK(found.gap(dome).error.rms < without.gap(dome).error.rms);
            const GapShares& shares = found.gap(dome).shares;
            REQUIRE(shares.gap >= 0);
            CHECK(shares.scatter > 0);
            const HairProjection given = projected(shares.gap, shares.scatter);
            CHECK(given.gap(dome).error.rms == found.gap(dome).error.rms);
            CHECK(given.gap(dome).error.bias == found.gap(dome).error.bias);
            CHECK(projected(shares.gap).gap(dome).error.bias > found.gap(dome).error.bias);
        }
        CHECK(found.at_hair.shares.gap != found.at_polygons.shares.gap);
    }
    const HairProjection alone = projection_of(hair_before_wall(true, Rgb(1)), type2_by(GatherMethod::projection));
    CHECK(alone.at_hair.error.points > 0);
    CHECK(alone.at_polygons.error.points == 0);  // none among the hair
    CHECK(alone.at_polygons.shares.gap == alone.at_hair.shares.gap);
}

TEST_CASE("pictures by projection do not depend on threads or instruction sets") {
    const Scene scene = hair_before_wall(true, Rgb(1));
    Options options = type2_by(GatherMethod::projection);
    options.spp = 2;
    const Rendered first = render(scene, options);
    for (const Isa isa : supported_isas()) {
        CAPTURE(isa_name(isa));
        options.isa = isa;
        CHECK(same_pixels(render(scene, options), first));
    }
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(same_pixels(render(scene, options), first));
}

TEST_CASE("light through far hair that points share is light by rays, on every instruction set and thread alike") {
    for (const bool wall : {false, true}) {
        CAPTURE(wall);
        const Scene scene = hair_before_wall(wall, Rgb(1, 0.9f, 0.8f));
        Options options = type2_by(GatherMethod::projection);
        options.projection.far_field = FarField::on;
        options.projection.probes = 32;
        const Rendered first = render(scene, options);
        REQUIRE(first.prepared.probes);
        CHECK(first.prepared.probes->bytes() > 0);
        const TypeShare rays = type2_of(render(scene, type2_by(GatherMethod::ray))), cells = type2_of(first);
        CHECK(std::abs(cells.mean - rays.mean) < 3 * std::hypot(rays.mean_error, cells.mean_error) + 0.01 * rays.mean);
        options.isa = Isa::scalar;
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        CHECK(same_pixels(render(scene, options), first));
    }
}

TEST_CASE("far hair is shared where asked for, or where enough points are expected between its corners") {
    const Scene scene = hair_before_wall(false, Rgb(1));
    Options options = type2_by(GatherMethod::projection);
    const auto shared = [&] { return make_plan(scene, options).far_field; };
    options.projection.cells = 1024;
    options.projection.opening = 1;
    options.spp = 1;
    CHECK_FALSE(shared());
    options.spp = 4096;
    CHECK_FALSE(shared());  // cubes are smaller than the reach of a point's own fiber
    options.projection.probes = 8;
    CHECK(shared());
    options.projection.far_field = FarField::off;
    CHECK_FALSE(shared());
    CHECK_FALSE(prepare(scene, make_plan(scene, options), options).probes);
    options.spp = 1;
    options.projection.far_field = FarField::on;
    CHECK(shared());
    options.projection.detail = ProjectionDetail::all;
    CHECK_FALSE(shared());
    options.projection.detail = ProjectionDetail::tree;
    options.type2 = GatherMethod::ray;
    CHECK_FALSE(shared());
}

TEST_CASE("hair is made ready for projection only where type 2 asks for it") {
    const Scene scene = hair_before_wall(true, Rgb(1));
    const auto planned = [&](const Options& options) { return make_plan(scene, options).projection; };
    CHECK(planned(type2_by(GatherMethod::projection)) == ProjectionDetail::tree);
    CHECK(planned(type2_by(GatherMethod::projection, ProjectionDetail::automatic)) == ProjectionDetail::all);
    CHECK_FALSE(planned(type2_by(GatherMethod::ray)));
    CHECK_FALSE(planned(type2_by(GatherMethod::path)));
    CHECK_FALSE(planned(type2_by(GatherMethod::off)));
    Options rays = type2_by(GatherMethod::ray);
    rays.spp = 1;
    const Rendered r = render(scene, rays);
    CHECK(r.prepared.projection.segments.rows() == 0);
    CHECK(r.prepared.projection.tree.blocks.empty());
}

TEST_CASE("layers and simplified hair keep the light where they are weighted, and lose shadow where not") {
    const Scene scene = hair_before_wall(false, Rgb(1));
    const auto light = [&](ProjectionDetail detail, bool weighted) {
        Options options = type2_by(GatherMethod::projection, detail);
        options.projection.gap = 0;
        options.projection.share = 0.5f;
        options.projection.layer = 0.3f;
        options.projection.weighted = weighted;
        return type2_of(render(scene, options)).mean;
    };
    const double all = light(ProjectionDetail::all, true);
    for (const ProjectionDetail detail : {ProjectionDetail::simplified, ProjectionDetail::layers}) {
        CAPTURE(int(detail));
        // Half the fibers twice as wide: noise of a few per cent in 300 fibers. Half the shadow is far more.
        CHECK(light(detail, true) == doctest::Approx(all).epsilon(0.08));
        CHECK(light(detail, false) > 1.1 * all);
    }
}

TEST_CASE("auto projects where that is estimated to take less time than the rays asked for") {
    const Scene scene = hair_before_wall(true, Rgb(1));
    Options options = type2_by(GatherMethod::automatic, ProjectionDetail::automatic);
    options.gather.rays = 1;
    options.spp = 1;
    const Plan few = make_plan(scene, options);
    REQUIRE(few.gather_cost);
    CHECK_FALSE(few.gather_cost->projection_pays());
    CHECK_FALSE(few.projection);
    options.gather.rays = 4096;
    options.spp = 1 << 20;
    const Plan many = make_plan(scene, options);
    REQUIRE(many.gather_cost);
    CHECK(many.gather_cost->projection_pays());
    CHECK(many.projection == ProjectionDetail::all);
    CHECK(many.gather_cost->rays == doctest::Approx(few.gather_cost->rays * 4096.0 * (1 << 20)));
    CHECK(many.gather_cost->projection == doctest::Approx(few.gather_cost->projection * (1 << 20)));
    for (const GatherMethod method : {GatherMethod::ray, GatherMethod::projection, GatherMethod::off})
        CHECK_FALSE(make_plan(scene, type2_by(method)).gather_cost);
}

TEST_CASE("more samples find the gap at more points, within bounds; renders by rays at none") {
    const Scene scene = hair_before_wall(true, Rgb(1));
    Options options = type2_by(GatherMethod::projection);
    const auto at_spp = [&](int spp) {
        options.spp = spp;
        return make_plan(scene, options).gap_points;
    };
    CHECK(at_spp(1) == gap_points(0));
    CHECK(at_spp(1 << 20) == gap_points(1e18));
    CHECK(gap_points(0) < gap_points(1e18));
    CHECK(gap_points(2 * 256.0 * gap_points(0)) == 2 * gap_points(0));
    CHECK(make_plan(scene, type2_by(GatherMethod::ray)).gap_points == 0);
}
