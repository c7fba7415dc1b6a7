// SPDX-License-Identifier: MIT
// Types 1 and 3 by shadow maps in whole pictures, and what the plan says of them.
#include <doctest/doctest.h>

#include "core/error.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr LampMethod kLampMethods[] = {LampMethod::deep, LampMethod::opacity, LampMethod::clusters};
constexpr CrossingMethod kCrossingMethods[] = {CrossingMethod::ray_deep, CrossingMethod::ray_opacity,
                                               CrossingMethod::ray_clusters};

Options types_1_and_3() {
    Options options = small_options();
    options.type2 = GatherMethod::off;
    options.spp = 48;
    return options;
}

double mean_of(const Rendered& r, PathType type) {
    double sum = 0;
    for (const glm::dvec3& light : r.state.film.types[size_t(index_of(type))].light) sum += light.x + light.y + light.z;
    return sum;
}

bool lists(const std::vector<PlanItem>& items, const std::string& name) {
    return std::any_of(items.begin(), items.end(), [&](const PlanItem& item) { return item.name == name; });
}

}  // namespace

// The same samples of points and lamps: what differs is what maps err, below 1 % of the mean in lamp_visibility_test,
// and for Type 3 also which crossings count, 4 % of one standard error here (by 20 renders with other seeds).
TEST_CASE("lamps of every kind bring as much light by maps as by rays") {
    const Scene scene = two_tufts(24);
    const Rendered by_ray = render(scene, types_1_and_3());
    for (int kind = 0; kind < kMapKinds; ++kind) {
        CAPTURE(kind);
        Options options = types_1_and_3();
        options.type1 = kLampMethods[kind];
        options.type3 = kCrossingMethods[kind];
        const Rendered by_map = render(scene, options);
        CHECK(mean_of(by_map, PathType::type1) / mean_of(by_ray, PathType::type1) == doctest::Approx(1).epsilon(0.01));
        CHECK(mean_of(by_map, PathType::type3) / mean_of(by_ray, PathType::type3) == doctest::Approx(1).epsilon(0.04));
    }
}

TEST_CASE("maps are made of the kinds that are asked, once for both types, and left out where no hair is") {
    Options options = types_1_and_3();
    options.type1 = LampMethod::deep;
    options.type3 = CrossingMethod::ray_deep;
    const Scene scene = two_tufts(8);
    const Rendered one = render(scene, options);
    size_t stages = 0;
    for (const StageCost& cost : one.prepared.costs) stages += cost.name == stage::kShadowMaps[0];
    CHECK(stages == 1);
    CHECK_FALSE(one.prepared.shadow_maps[0].maps.empty());
    CHECK(one.prepared.shadow_maps[1].maps.empty());
    CHECK(lists(one.plan.left_out, stage::kShadowMaps[1]));

    options.type3 = CrossingMethod::ray_opacity;
    const Plan both = make_plan(scene, options);
    CHECK(both.shadow_maps(MapKind::deep));
    CHECK(both.shadow_maps(MapKind::opacity));

    const Scene bald = assemble({}, {square(1, Rgb(1))}, {PointLight{{0, 0, 3}, Rgb(1)}}, camera_on_z(8, 32, 8));
    const Plan none = make_plan(bald, options);
    CHECK(none.direct);
    CHECK_FALSE(none.shadow_maps(MapKind::deep));
}

TEST_CASE("maps finer than memory holds are refused by name") {
    Options options = types_1_and_3();
    options.type1 = LampMethod::deep;
    options.maps.resolution = 8192;
    CHECK_THROWS_WITH_AS(make_plan(two_tufts(8), options),
                         "maps.resolution: 8192 for 7 views of lamps, expected at most 3096", InputError);
    options.maps.resolution = 3000;
    CHECK(make_plan(two_tufts(8), options).lamp_maps == MapKind::deep);
}

TEST_CASE("auto takes rays for few samples and maps for many, and says what it expects") {
    const Scene scene = two_tufts(64);
    Options options = types_1_and_3();
    options.type1 = LampMethod::automatic;
    options.spp = 1;
    const Plan few = make_plan(scene, options);
    REQUIRE(few.lamp_cost);
    CHECK_FALSE(few.lamp_maps);
    CHECK_FALSE(few.lamp_cost->maps_pay());
    options.type3 = CrossingMethod::ray_deep;
    const Plan shared = make_plan(scene, options);
    CHECK(shared.lamp_cost->build == 0);  // type 3 has them made
    CHECK(shared.lamp_maps == MapKind::deep);
    options.type3 = CrossingMethod::ray;
    options.spp = 1 << 20;
    const Plan many = make_plan(scene, options);
    REQUIRE(many.lamp_cost);
    CHECK(many.lamp_maps == MapKind::deep);
    CHECK(many.lamp_cost->rays == doctest::Approx(few.lamp_cost->rays * (1 << 20)));
    CHECK(many.lamp_cost->build == doctest::Approx(few.lamp_cost->build));
    options.time = 1e-6;  // no time for many
    CHECK_FALSE(make_plan(scene, options).lamp_maps);
}
