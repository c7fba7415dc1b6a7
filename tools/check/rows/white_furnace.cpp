// SPDX-License-Identifier: MIT
#include "tools/check/rows/white_furnace.h"

#include "tools/check/support/tufts.h"

namespace tress {
namespace {

using namespace test;

constexpr double kPercent = 100;

/// What the eye sees of hair, against a sky of 1: the mean over all samples that met it.
struct Furnace {
    double all = 0, error = 0;  // of all types; standard error of it, an upper estimate
    double first_three = 0;     // of types 1 to 3
    uint64_t samples = 0;
};

Furnace furnace_of(const Film& film) {
    Furnace f;
    double light = 0, variance = 0, first = 0;
    for (size_t i = 0; i < film.beauty.size(); ++i) {
        const double n = film.samples[i], missed = n - film.hits[i], sum = film.beauty[i].x;
        light += sum - missed;
        variance += (film.squares[i].x - sum * sum / n) * n / (n - 1);
        for (int t = 0; t < 3; ++t)
            if (!film.types[size_t(t)].light.empty()) first += film.types[size_t(t)].light[i].x;
        f.samples += film.hits[i];
    }
    f.all = light / double(f.samples);
    f.error = std::sqrt(variance) / double(f.samples);
    f.first_three = first / double(f.samples);
    return f;
}

void add_figures(const std::string& model, const Furnace& f, std::vector<Figure>& figures) {
    figures.push_back(within("all types by path, " + model + ", " + std::to_string(f.samples) + " paths",
                             kPercent * f.all, kPercent, 1, "%"));
    figures.push_back(told("its standard error, " + model, kPercent * f.error, "%"));
    figures.push_back(told("types 1 to 3 alone, " + model, kPercent * f.first_three, "%"));
}

}  // namespace

Outcome measure_white_furnace(const CheckSettings& settings) {
    const Scene scene = assemble({ball_of_hair(300, 5, 1, 0.02f, Vec3(0), 3, white_fiber())}, {}, {EnvironmentLight{}},
                                 camera_on_z(8, 14, 24));
    Outcome outcome;
    Options options;
    options.isa = settings.isa;
    options.spp = 256;
    use_paths(options);
    add_figures("straight", furnace_of(render(scene, options).state.film), outcome.figures);
    options.scattering = ScatteringModel::full;
    add_figures("full scattering", furnace_of(render(scene, options).state.film), outcome.figures);

    Options rays;
    rays.isa = settings.isa;
    const Furnace by_rays = furnace_of(render(scene, rays).state.film);
    outcome.figures.push_back(
        told("types 1 to 3 by rays, the methods without further options", kPercent * by_rays.first_three, "%"));
    return outcome;
}

}  // namespace tress
