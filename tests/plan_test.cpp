// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "core/error.h"
#include "core/light_reach.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

const PlanItem* find(const std::vector<PlanItem>& items, const std::string& name) {
    for (const PlanItem& item : items)
        if (item.name == name) return &item;
    return nullptr;
}

Plan plan_with(const Light& light) { return make_plan(assemble({}, {square(1, Rgb(1))}, {light}, {}), {}); }

}  // namespace

TEST_CASE("lights that nobody sees are left out, with the reason") {
    const std::pair<Light, const char*> unseen[] = {
        {PointLight{{0, 0, 3}, Rgb(0)}, "black"},
        {SpotLight{{0, 0, 30}, {0, 0, 60}, 20, Rgb(1)}, "cone"},
        {QuadLight{{0, 0, 5}, {{1, 0, 0}, {0, 1, 0}}, Rgb(1)}, "behind"},  // shines along +z, away from the square
        {QuadLight{{0, 0, 5}, {{1, 0, 0}, {2, 0, 0}}, Rgb(1)}, "area"},
        {EnvironmentLight{"", {}, Rgb(0), 0}, "black"},
    };
    for (const auto& [light, why] : unseen) {
        const Plan plan = plan_with(light);
        CAPTURE(why);
        CHECK(plan.lamps.empty());
        CHECK(plan.environments.empty());
        const PlanItem* item = find(plan.left_out, std::string("light 0 (") + light_name(light) + ")");
        REQUIRE(item);
        CHECK(item->why.find(why) != std::string::npos);
    }
}

TEST_CASE("lights that may be seen are kept, also at the edge of their cone or plane") {
    for (const Light& light :
         {Light(SpotLight{{0, 0, 30}, {0, 0, 0}, 1, Rgb(1)}), Light(SpotLight{{0, 0, 0.5}, {0, 0, 60}, 1, Rgb(1)}),
          Light(QuadLight{{0, 0, 5}, {{0, 1, 0}, {1, 0, 0}}, Rgb(1)}),
          Light(QuadLight{{-3, 0, 0}, {{0, 1, 0}, {0, 0, 1}}, Rgb(1)})})
        CHECK(plan_with(light).lamps.size() == 1);
}

TEST_CASE("every stage is either built or left out, once") {
    Options off;
    off.type1 = LampMethod::off;
    off.type2 = GatherMethod::off;
    Options maps;
    maps.type1 = LampMethod::clusters;
    maps.type3 = CrossingMethod::ray_deep;
    const std::vector<Light> lights = {PointLight{}, EnvironmentLight{}};
    const PlacedHair hair = upright_fibers({{0, 0}}, 1, 0.1f, white_fiber());
    for (const Options& options : {Options{}, off, maps})
        for (const Scene& scene : {assemble({}, {}, {}, {}), assemble({hair}, {}, lights, {}),
                                   assemble({hair}, {square(1, Rgb(1))}, lights, {})}) {
            const Plan plan = make_plan(scene, options);
            for (const char* name :
                 {stage::kHairTree, stage::kMeshTree, stage::kAttenuation, stage::kHairColors, stage::kEnvironment,
                  stage::kPhotons, stage::kPhotonMap, stage::kShownPhotons, stage::kCameraRays, stage::kShadowMaps[0],
                  stage::kShadowMaps[1], stage::kShadowMaps[2]}) {
                CAPTURE(name);
                CHECK(bool(find(plan.stages, name)) != bool(find(plan.left_out, name)));
            }
            for (const auto* items : {&plan.stages, &plan.left_out})
                for (const PlanItem& item : *items) CHECK_FALSE(item.why.empty());
        }
}

TEST_CASE("without hair, lights of the scattered types alone are left out") {
    Options scattered;
    scattered.type1 = LampMethod::off;
    scattered.type2 = GatherMethod::off;
    scattered.type4 = scattered.type5 = ScatteredMethod::path;
    const Scene scene = assemble({}, {square(1, Rgb(1))}, {PointLight{{0, 0, 3}, Rgb(1)}, EnvironmentLight{}}, {});
    const Plan plan = make_plan(scene, scattered);
    CHECK(plan.lamps.empty());
    CHECK(plan.environments.empty());
    CHECK_FALSE(any(plan.types));
    CHECK(find(plan.left_out, stage::kEnvironment));
    CHECK(find(plan.left_out, "light 1 (environment)")->why.find("no hair for type 5") != std::string::npos);
}

TEST_CASE("the sky is kept where nothing is left to hit: the camera sees it") {
    PlacedHair thin = upright_fibers({{0, 0}}, 1, 0, white_fiber());
    const Scene scene = assemble({thin}, {}, {EnvironmentLight{}, PointLight{}}, {});
    CHECK(scene.segments.point.empty());
    const Plan plan = make_plan(scene, {});
    CHECK(plan.environments.size() == 1);
    CHECK(plan.lamps.empty());
}

namespace {

/// Hair, and a square where asked, under these lights.
Plan hair_plan(const std::vector<Light>& lights, bool polygons, const Options& options = {}) {
    const PlacedHair hair = upright_fibers({{0, 0}}, 1, 0.1f, white_fiber());
    return make_plan(assemble({hair}, std::vector<PlacedMesh>(polygons ? 1 : 0, square(1, Rgb(1))), lights, {}),
                     options);
}

std::string why_left_out(const Plan& plan, const std::string& name) {
    const PlanItem* item = find(plan.left_out, name);
    return item ? item->why : "built";
}

}  // namespace

TEST_CASE("no polygons and no environment: no photon map and no type 2") {
    const Plan plan = hair_plan({PointLight{}}, false);
    CHECK(why_left_out(plan, stage::kPhotonMap) == "no polygons");
    CHECK(why_left_out(plan, "type 2") == "no polygons and no environment");
    CHECK_FALSE(plan.photons());
    CHECK_FALSE(plan.types[1]);
}

TEST_CASE("an environment alone: type 2 without photons") {
    const Plan plan = hair_plan({EnvironmentLight{}}, false);
    CHECK(plan.sky);
    CHECK_FALSE(plan.gather_rays());
    CHECK_FALSE(plan.photons());
    CHECK(why_left_out(plan, "type 1") == "no lamp shines into the picture");
}

TEST_CASE("photons are traced for polygons, and for those that are shown, or not at all") {
    Options options;
    CHECK(hair_plan({PointLight{}}, true).polygon_gather);
    options.type2 = GatherMethod::off;
    CHECK_FALSE(hair_plan({PointLight{}}, true, options).photons());
    options.type4 = ScatteredMethod::photons;
    const Plan shown = hair_plan({PointLight{}}, true, options);
    CHECK(shown.photons());
    CHECK_FALSE(shown.polygon_gather);
    options.photons.count = 0;
    const Plan none = hair_plan({PointLight{}}, true, options);
    CHECK_FALSE(none.photons());
    CHECK(why_left_out(none, "type 4") == "photons.count is 0");
    options.type2 = GatherMethod::ray;
    CHECK(why_left_out(hair_plan({PointLight{}}, true, options), "type 2") == "photons.count is 0");
}

TEST_CASE("full scattering sees through no fiber, and is for paths alone") {
    Options options;
    options.scattering = ScatteringModel::full;
    CHECK_THROWS_AS(hair_plan({PointLight{}}, true, options), InputError);
    use_paths(options);
    const Plan plan = hair_plan({PointLight{}}, true, options);
    CHECK(any(plan.paths));
    CHECK_FALSE(plan.attenuation);
}
