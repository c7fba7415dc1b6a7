// SPDX-License-Identifier: MIT
#include "tools/check/rows/bad_segments.h"

#include "accel/build.h"
#include "tools/check/support/bad_hair.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/oracle_verdict.h"
#include "tools/check/support/pictures.h"

namespace tress {
namespace {

using namespace test;

constexpr int kSize = 40;  // pixels a side

/// Coarse strands, and strands cut so finely that light leaves several segments of its own.
std::vector<PlacedHair> two_balls_of_cuts() {
    std::vector<PlacedHair> hair = two_balls();
    hair[1] = ball_of_hair(60, 24, 0.7, 0.03f, {0.8f, 0, 0}, 2, hair[1].fiber);
    return hair;
}

std::string values_that_differ(const LayeredImage& picture) {
    return "values whose bits differ, of " + std::to_string(values(picture));
}

void add_command_figures(const StrandSet& strands, uint64_t dropped, std::vector<Figure>& to) {
    const CommandEnd end = render_file_of(strands);
    to.push_back(exactly("exit code of tress render", end.exit_code, 0));
    to.push_back(exactly("lines that say 'dropped " + std::to_string(dropped) + "'",
                         double(end.lines_with("dropped " + std::to_string(dropped) + " ")), 1));
}

}  // namespace

Outcome measure_no_length(const CheckSettings& settings) {
    Options options = small_effort(settings.isa);
    options.type4 = options.type5 = ScatteredMethod::photons;
    const std::vector<PlacedHair> good = two_balls_of_cuts();
    std::vector<PlacedHair> bad = good;
    uint64_t added = 0;
    for (PlacedHair& hair : bad) {
        const size_t before = segments(hair.strands);
        hair.strands = with_no_lengths(hair.strands);
        added += segments(hair.strands) - before;
    }
    std::vector<PlacedHair> stray = bad;
    const std::vector<Vec3> outside(3, Vec3(-4.7f, 3.1f, 2.3f));
    add_strand(stray[0].strands, outside.data(), outside.size());

    const Scene scene = in_room(bad, kSize);
    const LayeredImage picture = render(in_room(good, kSize), options).picture;
    std::vector<Figure> figures{
        exactly("dropped, of " + std::to_string(added) + " segments without length", double(scene.segments.dropped),
                double(added)),
        exactly(values_that_differ(picture) + " from the scene without them",
                double(different_values(picture, render(scene, options).picture)), 0),
        exactly("the same with a strand of equal points far outside",
                double(different_values(picture, render(in_room(stray, kSize), options).picture)), 0)};
    const StrandSet& file = bad[0].strands;
    add_command_figures(file, list_segments(file).dropped, figures);
    return {figures, {}};
}

namespace {

/// Lengths from the small to the smallest there is.
std::vector<float> lengths() {
    std::vector<float> lengths;
    for (int e = -12; e >= -38; e -= 2) lengths.push_back(float(std::pow(10.0, e)));
    lengths.insert(lengths.end(), {1e-40f, 1e-43f, std::numeric_limits<float>::denorm_min()});
    return lengths;
}

/// A segment of each length at the middle, and at `place`, where most are lost to rounding.
StrandSet with_hardly_any_length(StrandSet strands, const Vec3& place) {
    for (const float length : lengths())
        for (const Vec3& start : {Vec3(0), place}) {
            const Vec3 points[] = {start, start + Vec3(0, length, 0)};
            add_strand(strands, points, 2);
        }
    return strands;
}

/// A lone segment a hundredth of its radius long, seen from near: longer than what is dropped.
Scene speck(float length) {
    PlacedHair hair = upright_fibers({{0, 0}}, 0.5f * length, 100 * length, white_fiber());
    const double size = 100 * double(length);
    Camera camera = camera_on_z(10 * size, 30, 8);
    const std::vector<Light> lights = {PointLight{{0, 5 * size, 5 * size}, Rgb(1)}, DistantLight{{0, -1, -1}, Rgb(1)},
                                       EnvironmentLight{}};
    return assemble({hair}, {}, lights, camera);
}

struct Specks {
    size_t kept = 0, values = 0, not_finite = 0, on_hair = 0;
};
Specks render_specks(const Options& options) {
    Specks sum;
    for (const float length : lengths()) {
        const Scene scene = speck(length);
        const Rendered r = render(scene, options);
        sum.kept += scene.segments.point.size();
        sum.values += values(r.picture);
        sum.not_finite += values_not_finite(r.picture);
        for (const uint32_t hits : r.state.film.hair_hits) sum.on_hair += hits;
    }
    return sum;
}

/// Segments just long enough to be kept, and up to a radius long.
scenes::Hair short_segments(size_t n) {
    scenes::Hair hair;
    scenes::Dice dice(31);
    constexpr float kRadius = 0.05f;
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = dice.in_cube();
        const float length = kRadius * std::pow(10.0f, -2.9f * dice.unit());
        hair.add(start, start + length * dice.direction(), kRadius);
    }
    return hair;
}

Figure wrong_at_short_segments(Isa isa) {
    constexpr size_t kRays = 100000;
    const scenes::Hair hair = short_segments(200);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const scenes::Rays rays = scenes::mixed_rays(kRays, Vec3(0), 32);
    const oracle::Answers answers(tree, rays.batch(), isa);
    const oracle::Scene scene(hair.view());
    size_t wrong = 0;
    for (size_t i = 0; i < kRays; ++i) wrong += oracle::judge(scene, rays.batch(), i, answers, false).fault != nullptr;
    return exactly("wrong answers of 100,000 rays at segments of 0.0013 to 1 radii", double(wrong), 0);
}

}  // namespace

Outcome measure_hardly_any_length(const CheckSettings& settings) {
    const Options options = small_effort(settings.isa);
    std::vector<PlacedHair> hair = two_balls();
    hair[0].strands = with_hardly_any_length(hair[0].strands, {0.3f, -0.2f, 0.1f});
    const uint64_t added = 2 * lengths().size();
    const Scene scene = in_room(hair, kSize);
    const LayeredImage picture = render(scene, options).picture;
    const Specks specks = render_specks(options);
    std::vector<Figure> figures{
        exactly("dropped, of " + std::to_string(added) + " segments of 1e-12 to 1e-45 among hair of radius 0.03",
                double(scene.segments.dropped), double(added)),
        exactly("values that are not finite, of " + std::to_string(values(picture)), double(values_not_finite(picture)),
                0),
        told("of " + std::to_string(lengths().size()) + " alone with radii of 100 lengths, kept", double(specks.kept)),
        told("of their camera rays, on hair", double(specks.on_hair)),
        exactly("of their values, not finite, of " + std::to_string(specks.values), double(specks.not_finite), 0),
        wrong_at_short_segments(settings.isa)};
    add_command_figures(hair[0].strands, added, figures);
    return {figures, {}};
}

}  // namespace tress
