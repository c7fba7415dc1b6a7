// SPDX-License-Identifier: MIT
#include "tools/check/rows/whole_turn.h"

#include "tools/check/support/method_sets.h"
#include "tools/check/support/tufts.h"
#include "tools/check/support/turned_scene.h"

namespace tress {
namespace {

using namespace test;

std::vector<double> light_of_pixels(const Film& film) {
    std::vector<double> light;
    for (size_t i = 0; i < film.beauty.size(); ++i)
        light.push_back(double(luminance(Rgb(film.beauty[i]))) / film.samples[i]);
    return light;
}

/// Of another picture's mean light, in shares of the first's.
struct Shift {
    double mean = 0, error = 0;  // standard error
};

/// Pixel by pixel: both have the same camera rays, whose noise thus cancels.
Shift shift(const Film& first, const Film& other) {
    const std::vector<double> a = light_of_pixels(first), b = light_of_pixels(other);
    const double n = double(a.size());
    double light = 0, sum = 0, squares = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        light += a[i];
        sum += b[i] - a[i];
        squares += square(b[i] - a[i]);
    }
    const double variance = (squares - sum * sum / n) * n / (n - 1);
    return {sum / light, std::sqrt(variance) / light};
}

/// A ball of hair under a sky and two lamps, and nothing else; the camera sees little past it.
Scene lone_ball(int size) {
    EnvironmentLight sky;
    sky.radiance = {0.5f, 0.6f, 0.7f};
    const std::vector<Light> lights = {DistantLight{{0.2, -0.5, -1}, Rgb(2)},
                                       QuadLight{{-1, 3, 1}, {{2, 0, 0}, {0, 0.5, 1}}, Rgb(4)}, sky};
    const Fiber blonde = fiber_with(sigma_a_from_melanin(0.2f, 0.1f));
    return assemble({ball_of_hair(60, 3, 0.7, 0.05f, Vec3(0), 1, blonde)}, {}, lights, camera_on_z(8, 8, size));
}

/// The worst of a few turns.
void compare_turned(const std::string& name, const Scene& scene, const Options& options, std::vector<Figure>& figures) {
    constexpr int kTurns = 2;
    constexpr double kPercent = 100;
    const Rendered upright = render(scene, options);
    Shift worst;
    for (uint64_t turn = 0; turn < kTurns; ++turn) {
        const Scene other = turned(scene, random_turn(hash(5, turn)));
        const Shift s = shift(upright.state.film, render(other, options).state.film);
        if (std::abs(s.mean) > std::abs(worst.mean)) worst = s;
    }
    figures.push_back(at_most("mean light, " + name + ", worst of " + std::to_string(kTurns) + " turns: off by",
                              kPercent * std::abs(worst.mean), 0.2, "%"));
    figures.push_back(told("its standard error", kPercent * worst.error, "%"));
}

}  // namespace

Outcome measure_turned_scene(const CheckSettings& settings) {
    const Scene room = two_tufts(24), ball = lone_ball(20);
    Options rays = by_rays(settings.isa);
    rays.spp = 32;
    rays.gather.rays = 4;
    rays.photons.count = 100'000;
    Options lamps = by_maps(by_rays(settings.isa), LampMethod::deep, CrossingMethod::ray_deep);
    lamps.type2 = GatherMethod::off;
    lamps.spp = 32;
    Options all = by_projection(by_rays(settings.isa), ProjectionDetail::all);
    all.spp = 4;
    all.projection.gap = 1;
    Options tree = by_projection(by_rays(settings.isa), ProjectionDetail::tree);
    tree.spp = 4;
    Outcome outcome;
    compare_turned("hair and polygons by rays", room, rays, outcome.figures);
    compare_turned("hair lit by lamps, deep maps", ball, lamps, outcome.figures);
    compare_turned("hair under a sky, all projected", ball, all, outcome.figures);
    compare_turned("hair under a sky, a tree projected, its gap found by rays", ball, tree, outcome.figures);
    return outcome;
}

}  // namespace tress
