// SPDX-License-Identifier: MIT
#include "tools/check/rows/bare_scenes.h"

#include <algorithm>

#include "core/error.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/small_scenes.h"

namespace tress {
namespace {

using namespace test;
using Names = std::vector<std::string>;

constexpr int kSize = 16;  // pixels a side

struct BareScene {
    std::string lacks;
    Scene scene;
    Names useless;  // stages that it has no use for
    bool black;
};

Names all_but_camera_rays() {
    return {stage::kHairTree,      stage::kMeshTree,      stage::kAttenuation,
            stage::kHairColors,    stage::kEnvironment,   stage::kShadowMaps[0],
            stage::kShadowMaps[1], stage::kShadowMaps[2], stage::kProjectedHair,
            stage::kPhotons,       stage::kPhotonMap,     stage::kShownPhotons,
            stage::kType1,         stage::kSky,           stage::kProjection,
            stage::kGatherRays,    stage::kPolygonGather, stage::kCrossingGather,
            stage::kPhotonDisplay, stage::kPaths};
}

Names without(Names names, const Names& taken) {
    std::erase_if(names, [&](const std::string& n) { return std::find(taken.begin(), taken.end(), n) != taken.end(); });
    return names;
}

std::vector<BareScene> bare_scenes() {
    const std::vector<PlacedHair> hair{upright_fibers({{0, 1}, {0.2f, 1}, {-0.1f, 1.2f}}, 1, 0.05f, white_fiber())};
    const std::vector<PlacedMesh> wall{square(2, Rgb(0.5f))};
    const Light lamp = PointLight{{1, 1, 5}, Rgb(20)};
    const std::vector<Light> lights{lamp, EnvironmentLight{}};
    const std::vector<Light> dark{PointLight{{1, 1, 5}, Rgb(0)}, DistantLight{{0, 0, 0}, Rgb(1)}};
    const Camera camera = camera_on_z(10, 20, kSize), pixel = camera_on_z(10, 20, 1);
    Camera away = camera;
    away.to = {0, 0, 20};

    const Names all = all_but_camera_rays(), unlit = without(all, {stage::kHairTree, stage::kMeshTree});
    const Names without_polygons{stage::kMeshTree, stage::kPhotonMap, stage::kPolygonGather};
    const Names without_hair = without(all, {stage::kMeshTree, stage::kEnvironment, stage::kPhotons, stage::kPhotonMap,
                                             stage::kType1, stage::kSky, stage::kGatherRays, stage::kPolygonGather});
    return {{"lights", assemble(hair, wall, {}, camera), unlit, true},
            {"lights that shine", assemble(hair, wall, dark, camera), unlit, true},
            {"polygons", assemble(hair, {}, lights, camera), without_polygons, false},
            {"hair", assemble({}, wall, lights, camera), without_hair, false},
            {"everything", assemble({}, {}, {}, pixel), all, true},
            {"everything but lamps", assemble({}, {}, {lamp}, camera), all, true},
            {"anything in the camera's view", assemble(hair, wall, {lamp}, away), {}, true},
            {"pixels but one", assemble(hair, wall, lights, pixel), {}, false}};
}

/// Everything that stages serve, so that what is left out is left out for the scene's sake.
Options all_methods(const CheckSettings& settings) {
    Options options = small_effort(settings.isa);
    options.type1 = LampMethod::deep;
    options.type2 = GatherMethod::projection;
    options.type3 = CrossingMethod::ray_deep;
    options.type4 = options.type5 = ScatteredMethod::photons;
    return options;
}

Names built(const Rendered& r) {
    Names names;
    for (const StageCost& cost : r.prepared.costs) names.push_back(cost.name);
    for (const StageCost& cost : loop_costs(r.state, r.prepared, r.plan)) names.push_back(cost.name);
    return names;
}

/// Stages built though the plan does not list them, and stages left out without a reason.
size_t contradictions(const Rendered& r) {
    size_t found = 0;
    for (const std::string& name : built(r))
        found += std::none_of(r.plan.stages.begin(), r.plan.stages.end(),
                              [&](const PlanItem& item) { return item.name == name; });
    for (const PlanItem& item : r.plan.left_out) found += item.why.empty();
    return found;
}

bool is_black(const Film& film) {
    return std::all_of(film.beauty.begin(), film.beauty.end(), [](const glm::dvec3& sum) { return sum == DVec3(0); });
}

template <class Use>
bool is_refused(const Use& use) {
    try {
        use();
    } catch (const InputError&) {
        return true;
    }
    return false;
}

}  // namespace

Outcome measure_bare_scenes(const CheckSettings& settings) {
    Outcome outcome;
    const Options options = all_methods(settings);
    size_t not_finite = 0, wrongly_lit = 0, contradicted = 0;
    const std::vector<BareScene> scenes = bare_scenes();
    for (const BareScene& bare : scenes) {
        const Rendered r = render(bare.scene, options);
        not_finite += values_not_finite(r.picture);
        wrongly_lit += is_black(r.state.film) != bare.black;
        contradicted += contradictions(r);
        const size_t useless = built(r).size() - without(built(r), bare.useless).size();
        if (!bare.useless.empty())
            outcome.figures.push_back(exactly("stages of no use, without " + bare.lacks, double(useless), 0));
        else
            outcome.figures.push_back(told("stages built, without " + bare.lacks, double(built(r).size())));
    }
    const std::string of_all = " in " + std::to_string(scenes.size()) + " scenes";
    Options none = options;
    none.spp = 0;
    const Rendered unsampled = render(bare_scenes().back().scene, none);
    outcome.figures.insert(
        outcome.figures.end(),
        {exactly("values not finite" + of_all, double(not_finite), 0),
         exactly("pictures black that should be lit, or lit that should be black" + of_all, double(wrongly_lit), 0),
         exactly("stages built unplanned, or left out without a reason" + of_all, double(contradicted), 0),
         holds("a picture of no samples is black and finite",
               is_black(unsampled.state.film) && all_finite(unsampled.picture)),
         holds("no samples are refused as an option", is_refused([&] { set_option(none, "--spp", "spp", "0"); })),
         holds("a picture without pixels is refused", is_refused([] { check_film_size(0, kSize); }))});
    return outcome;
}

}  // namespace tress
