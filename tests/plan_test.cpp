// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "tests/small_scenes.h"

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
    off.type1 = GatherMethod::off;
    off.type2 = GatherMethod::off;
    const std::vector<Light> lights = {PointLight{}, EnvironmentLight{}};
    const PlacedHair hair = upright_fibers({{0, 0}}, 1, 0.1f, white_fiber());
    for (const Options& options : {Options{}, off})
        for (const Scene& scene : {assemble({}, {}, {}, {}), assemble({hair}, {}, lights, {}),
                                   assemble({hair}, {square(1, Rgb(1))}, lights, {})}) {
            const Plan plan = make_plan(scene, options);
            for (const char* name :
                 {stage::kHairTree, stage::kMeshTree, stage::kAttenuation, stage::kHairColors, stage::kEnvironment,
                  stage::kPhotons, stage::kPhotonMap, stage::kShownPhotons, stage::kCameraRays}) {
                CAPTURE(name);
                CHECK(bool(find(plan.stages, name)) != bool(find(plan.left_out, name)));
            }
            for (const auto* items : {&plan.stages, &plan.left_out})
                for (const PlanItem& item : *items) CHECK_FALSE(item.why.empty());
        }
}

TEST_CASE("the sky is kept where nothing is left to hit: the camera sees it") {
    PlacedHair thin = upright_fibers({{0, 0}}, 1, 0, white_fiber());
    const Scene scene = assemble({thin}, {}, {EnvironmentLight{}, PointLight{}}, {});
    CHECK(scene.segments.point.empty());
    const Plan plan = make_plan(scene, {});
    CHECK(plan.environments.size() == 1);
    CHECK(plan.lamps.empty());
}
