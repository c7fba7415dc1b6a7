// SPDX-License-Identifier: MIT
#include "tools/check/rows/radius_limits.h"

#include "accel/build.h"
#include "io/load_scene.h"
#include "io/scene_file.h"
#include "tools/check/support/bad_hair.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/refusal.h"
#include "tools/check/support/tree_scenes.h"

namespace tress {
namespace {

using namespace test;

constexpr int kSize = 40;  // pixels a side

/// Hair of radius 0 between the rest.
PlacedHair hair_of_no_radius() {
    PlacedHair hair = ball_of_hair(100, 5, 0.3, 1, Vec3(0), 41, white_fiber());
    hair.strands.constant_radius = 0;
    hair.strands.radius.assign(hair.strands.points(), 0.0f);
    return hair;
}

/// Rays that pass exactly through the axes of segments of radius 0, at right angles and along them; what they meet.
struct Met {
    size_t rays = 0, hits = 0, crossings = 0;
};
Met met_at_no_radius(Isa isa) {
    constexpr int kSegments = 64;
    scenes::Hair hair;
    scenes::Rays rays;
    for (int i = 0; i < kSegments; ++i) {
        const Vec3 start(float(i % 8) / 4 - 1, float(i / 8) / 4 - 1, 0);
        hair.add(start, start + Vec3(0.25f, 0, 0), 0);
        for (int k = 0; k < 8; ++k) {
            const Vec3 middle = start + Vec3(float(k) / 32, 0, 0);
            rays.add(middle + Vec3(0, 0, 2), Vec3(0, 0, -1));
            rays.add(middle - Vec3(0, 2, 0), Vec3(0, 1, 0));
            rays.add(middle - Vec3(2, 0, 0), Vec3(1, 0, 0));
        }
    }
    Met met{rays.size()};
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    for (const uint32_t id : scenes::nearest(tree, rays.batch(), isa).id) met.hits += id != kNone;
    for (const uint32_t n : scenes::constant(tree, rays.batch(), 0.5f, 0, isa).crossings) met.crossings += n;
    return met;
}

/// Whether a scene file whose hair has this field is refused.
bool is_refused(const std::string& field) {
    const Folder folder;
    const std::string scene =
        write_bytes(folder.file("scene.json"), R"({"hair": [{"groom": "short", "segments": 100, )" + field + "}]}");
    return contains(message_of([&] { read_scene_file(scene); }), "radius");
}

/// Whether a .hair file with such widths is refused.
bool is_refused(const StrandSet& strands) {
    const Folder folder;
    const SceneDescription description = scene_of_file(strands, folder);
    return !message_of([&] { load_scene(description); }).empty();
}

/// Segments that a scene of this hair drops.
double dropped_of(const StrandSet& strands) { return double(list_segments(strands).dropped); }

void add_refusals(std::vector<Figure>& to) {
    StrandSet strands = ball_of_hair(3, 3, 1, 0.04f, Vec3(0), 42, white_fiber()).strands;
    to.push_back(holds("a negative radius in a scene file is an error", is_refused(R"("radius": -0.004)")));
    to.push_back(holds("a negative radius_scale is an error", is_refused(R"("radius_scale": -1)")));
    strands.constant_radius = -0.04f;
    to.push_back(holds("a negative width of all strands of a .hair file is an error", is_refused(strands)));
    strands.radius.assign(strands.points(), 0.04f);
    strands.constant_radius = 0.04f;
    strands.radius[5] = -0.04f;  // between two segments
    to.push_back(exactly("segments dropped and counted at one point of negative width", dropped_of(strands), 2));
}

}  // namespace

Outcome measure_radius_limits(const CheckSettings& settings) {
    Options options = small_effort(settings.isa);
    options.type4 = options.type5 = ScatteredMethod::photons;
    std::vector<PlacedHair> hair = two_balls();
    const LayeredImage without = render(in_room(hair, kSize), options).picture;
    hair.push_back(hair_of_no_radius());
    const Scene scene = in_room(hair, kSize);
    const LayeredImage picture = render(scene, options).picture;
    const Met met = met_at_no_radius(settings.isa);
    std::vector<Figure> figures{
        exactly("values that are not finite, of " + std::to_string(values(picture)), double(values_not_finite(picture)),
                0),
        exactly("values that differ from the scene without 500 segments of radius 0",
                double(different_values(picture, without)), 0),
        exactly("hits of " + std::to_string(met.rays) + " rays right through axes of radius 0", double(met.hits), 0),
        exactly("crossings of these that take light", double(met.crossings), 0)};
    add_refusals(figures);
    return {figures, {}};
}

}  // namespace tress
