// SPDX-License-Identifier: MIT
#include "tools/check/rows/huge_lights.h"

#include <algorithm>

#include "io/exr_file.h"
#include "tools/check/support/folder.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/small_scenes.h"

namespace tress {
namespace {

using namespace test;

constexpr double kLargestHalf = 65504;

/// Three fibers before a square.
Scene lit_by(const Light& light) {
    const PlacedHair hair = upright_fibers({{0, 1}, {0.2f, 1}, {-0.1f, 1.2f}}, 1, 0.05f, white_fiber());
    return assemble({hair}, {square(2, Rgb(1))}, {light}, camera_on_z(10, 25, 12));
}

std::vector<Light> absurd_lights() {
    EnvironmentLight sky;
    sky.radiance = Rgb(1e30f);
    return {PointLight{{0, 0, 3}, Rgb(1e30f)},
            PointLight{{0, 0, 1e-20}, Rgb(1)},    // a hair's breadth of nothing above the square
            PointLight{{0, 0.5, 1}, Rgb(1e30f)},  // on a fiber's axis
            SpotLight{{0, 0, 1e-20}, {0, 0, 1}, 40, Rgb(1e30f)},
            DistantLight{{0, 0, -1e-300}, Rgb(1e30f)},
            QuadLight{{-1, -1, 1e-20}, {{2, 0, 0}, {0, -2, 0}}, Rgb(1e30f)},
            QuadLight{{0, 0, 1e-20}, {{1e-20, 0, 0}, {0, -1e-20, 0}}, Rgb(1e30f)},
            sky};
}

double largest(const LayeredImage& picture) {
    double most = 0;
    for (const Layer& layer : picture.layers)
        for (const float v : layer.data) most = std::max(most, double(v));
    return most;
}

}  // namespace

Outcome measure_huge_lights(const CheckSettings& settings) {
    size_t pictures = 0, all = 0, not_finite = 0, changed_by_file = 0;
    double brightest = 0;
    const Folder folder;
    for (const Light& light : absurd_lights()) {
        const Scene scene = lit_by(light);
        for (const MethodSet& set : method_sets(settings.isa)) {
            const LayeredImage picture = render(scene, set.options).picture;
            ++pictures;
            all += values(picture);
            not_finite += values_not_finite(picture);
            brightest = std::max(brightest, largest(picture));
            write_exr(folder.file("a.exr"), picture);
            LayeredImage sorted = picture;
            std::sort(sorted.layers.begin(), sorted.layers.end(),
                      [](const Layer& a, const Layer& b) { return a.name < b.name; });
            changed_by_file += different_values(sorted, read_exr(folder.file("a.exr")));
        }
    }
    const std::string of = ", of " + std::to_string(all) + " in " + std::to_string(pictures) + " pictures";
    return {{exactly("values not finite" + of, double(not_finite), 0),
             at_least("the brightest value, where halves end at 65504", brightest, kLargestHalf),
             exactly("values whose bits differ when read from their EXR file", double(changed_by_file), 0)},
            {}};
}

}  // namespace tress
