// SPDX-License-Identifier: MIT
// Methods that use photons against path tracing, through whole renders.
#include <doctest/doctest.h>

#include "core/type_shares.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

/// Two tufts by a wall and a floor; one lamp more, as bright wherever it stands.
Scene tufts_under_quad(double distance) {
    Scene scene = two_tufts(24);
    const double side = 0.2 * distance, d = distance;
    scene.lights.push_back(QuadLight{{0.3 * d, 0.3 * d, 0.9 * d}, {{0, side, 0}, {side, 0, 0}}, Rgb(9)});
    return scene;
}

TypeShare mean_of(const Scene& scene, const Options& options, PathType type) {
    for (const TypeShare& share : type_shares(render(scene, options).state.film, ShareOf::picture))
        if (share.type == type) return share;
    return {type, 0, 0, 0, 0};
}

/// One type, by path or by what photons serve.
Options only(PathType type, bool by_path) {
    Options options;
    options.type1 = LampMethod::off;
    options.type3 = CrossingMethod::off;
    const ScatteredMethod scattered = by_path ? ScatteredMethod::path : ScatteredMethod::photons;
    options.type2 = type != PathType::type2 ? GatherMethod::off : by_path ? GatherMethod::path : GatherMethod::ray;
    if (type == PathType::type4) options.type4 = scattered;
    if (type == PathType::type5) options.type5 = scattered;
    options.spp = by_path ? 512 : 32;
    options.photons.count = 200000;
    return options;
}

/// What photons make wrong, as a share of the mean: of type 2 what is asked of the map; of photons shown in the hair a
/// quarter, for the discs that 50 of them need reach past the rims of so small a tuft.
double allowed(PathType type) { return type == PathType::type2 ? 0.02 : 0.25; }

}  // namespace

TEST_CASE("photons bring as much light of their types as paths do, also from a lamp far away") {
    for (const double distance : {6.0, 6000.0})
        for (const PathType type : {PathType::type2, PathType::type4, PathType::type5}) {
            const Scene scene = tufts_under_quad(distance);
            const TypeShare path = mean_of(scene, only(type, true), type);
            const TypeShare photons = mean_of(scene, only(type, false), type);
            CAPTURE(distance);
            CAPTURE(std::string(type_name(type)));
            CAPTURE(path.mean);
            CAPTURE(path.mean_error);
            CAPTURE(photons.mean);
            MESSAGE(std::string(type_name(type)) << " " << path.mean << " +- " << path.mean_error << ", by photons "
                                                 << photons.mean << " +- " << photons.mean_error);
            CHECK(path.mean_error < 0.06 * path.mean);
            const double error = std::sqrt(square(path.mean_error) + square(photons.mean_error));
            CHECK(std::abs(photons.mean - path.mean) < 3 * error + allowed(type) * path.mean);
        }
}
