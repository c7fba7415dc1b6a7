// SPDX-License-Identifier: MIT
#include "tools/check/rows/moved_scenes.h"

#include <cstdio>

#include "core/image_error.h"
#include "core/layer_image.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/refusal.h"
#include "tools/check/support/tufts.h"

namespace tress {
namespace {

using namespace test;

constexpr double kMost = 1e-6;

/// Hair of this radius in a room.
SceneParts tufts_of(double radius, int size) {
    return moved(parts_of_room(two_balls(), size), {radius / 0.03, DVec3(0)});
}

double relmse(const LayeredImage& reference, const LayeredImage& picture) {
    return image_error(layer_image(reference, "", "reference"), layer_image(picture, "", "picture")).relmse;
}

std::string power(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", value);
    return text;
}

/// Hair of radius `radius` whose own coordinates are `away` from 0.
PlacedHair hair_away(float away, float radius) { return upright_fibers({{away, 0}}, 1, radius, white_fiber()); }

void add_refusals(std::vector<Figure>& to) {
    constexpr float kRadius = 1e-3f;
    const auto refused = [](const PlacedHair& hair) {
        return contains(message_of([&] { assemble({hair}, {}, {}, {}); }), "4 ulp");
    };
    // An ulp at 2000 is 1.2e-4 to 2.4e-4.
    to.push_back(holds("hair of radius 1e-3 given in single precision at 1e3, 8 ulp thick, is taken",
                       !refused(hair_away(1e3f, kRadius))));
    for (const float away : {1e5f, 1e6f})
        to.push_back(holds("at " + power(double(away)) + ", less than 4 ulp thick, it is refused with a message",
                           refused(hair_away(away, kRadius))));
    const float ulp = 1024 * std::numeric_limits<float>::epsilon();
    to.push_back(holds("at 1024, of 4.01 ulp, taken", !refused(hair_away(1024, 4.01f * ulp))));
    to.push_back(holds("at 1024, of 3.99 ulp, refused", refused(hair_away(1024, 3.99f * ulp))));
}

}  // namespace

Outcome measure_far_from_origin(const CheckSettings& settings) {
    Options options = small_effort(settings.isa);
    options.spp = 4;
    const SceneParts parts = tufts_of(1e-3, 40);
    const LayeredImage near = render(assembled(parts), options).picture;
    std::vector<Figure> figures;
    for (const double away : {1e3, 1e6}) {
        const Scene scene = assembled(moved(parts, {1, {away, -away, 0.7 * away}}));
        figures.push_back(
            at_most("relMSE once moved by " + power(away), relmse(near, render(scene, options).picture), kMost));
    }
    add_refusals(figures);
    return {figures, {}};
}

namespace {

/// Options at another size: those that are lengths.
Options sized(Options options, double scale) {
    options.photons.radius *= float(scale);
    options.projection.cube *= float(scale);
    options.projection.layer *= float(scale);
    return options;
}

/// The picture of a scene `scale` times as large, whose depths are brought back.
LayeredImage picture_at(const SceneParts& parts, const Options& options, double scale) {
    LayeredImage picture = render(assembled(moved(parts, {scale, DVec3(0)})), sized(options, scale)).picture;
    for (Layer& layer : picture.layers)
        if (layer.name == "depth")
            for (float& depth : layer.data) depth = float(double(depth) / scale);
    return picture;
}

/// The same methods by fewer cells.
MethodSet lighter(MethodSet set) {
    set.options.projection.cells = 64;
    return set;
}

void add_figures(const SceneParts& parts, const MethodSet& set, std::vector<Figure>& to) {
    const LayeredImage whole = picture_at(parts, set.options, 1);
    const auto at = [&](double scale) { return picture_at(parts, set.options, scale); };
    const std::string by = std::string(": ") + set.name;
    to.push_back(exactly("values whose bits differ at 2^-20 and 2^20, of " + std::to_string(2 * values(whole)) + by,
                         double(different_values(whole, at(0x1p-20)) + different_values(whole, at(0x1p20))), 0));
    const double error = std::max(relmse(whole, at(1e-6)), relmse(whole, at(1e6)));
    // A path that rounding sends past a fiber goes another way for good: that is noise.
    const bool chaotic = set.options.type5 == ScatteredMethod::path;
    to.push_back(chaotic ? told("relMSE at 1e-6 and 1e6, noise of paths that part" + by, error)
                         : at_most("relMSE at 1e-6 and 1e6" + by, error, kMost));
}

}  // namespace

Outcome measure_sizes(const CheckSettings& settings) {
    const SceneParts parts = tufts_of(0.004, 16);
    std::vector<Figure> figures;
    for (const MethodSet& set : method_sets(settings.isa)) add_figures(parts, lighter(set), figures);
    return {figures, {}};
}

}  // namespace tress
