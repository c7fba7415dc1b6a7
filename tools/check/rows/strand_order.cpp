// SPDX-License-Identifier: MIT
#include "tools/check/rows/strand_order.h"

#include "core/image_error.h"
#include "core/layer_image.h"
#include "core/type_shares.h"
#include "tools/check/support/method_sets.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/tufts.h"
#include "tools/check/support/turned_scene.h"

namespace tress {
namespace {

using namespace test;

/// Two balls of hair without tilt, whose strands were changed by `change`, in their room.
template <class Change>
Scene changed_tufts(const Change& change) {
    constexpr int kSize = 32;
    std::vector<PlacedHair> hair = two_balls(0);
    for (PlacedHair& ball : hair) ball.strands = change(ball.strands);
    return in_room(std::move(hair), kSize);
}

double relative_error(const Rendered& reference, const Rendered& test) {
    const auto beauty = [](const Rendered& r) { return layer_image(r.picture, "", "the picture"); };
    return image_error(beauty(reference), beauty(test)).relmse;
}

/// Means of two pictures apart, in standard errors of their difference.
double errors_apart(const Film& a, const Film& b) {
    double difference = 0, variance = 0;
    for (const auto& [film, sign] : {std::pair(&a, 1.0), std::pair(&b, -1.0)})
        for (const TypeShare& share : type_shares(*film, ShareOf::picture)) {
            difference += sign * share.mean;
            variance += square(share.mean_error);
        }
    return std::abs(difference) / std::sqrt(variance);
}

std::vector<MethodSet> all_kinds(const Options& rays) {
    Options projected = rays;
    projected.spp = 2;
    projected.projection.gap = 1;  // not found by rays first, which takes longer than the picture
    return {{"rays", rays},
            {"opacity maps", by_maps(rays, LampMethod::opacity, CrossingMethod::ray_opacity)},
            {"clusters", by_maps(rays, LampMethod::clusters, CrossingMethod::ray_clusters)},
            {"all hair projected", by_projection(projected, ProjectionDetail::all)},
            {"a tree projected", by_projection(projected, ProjectionDetail::tree)}};
}

/// Methods that add up along rays, none of which is cut short: no sum tells in which order the tree holds its hair.
std::vector<MethodSet> in_the_order_of_rays(Options rays) {
    rays.cutoff = 0;
    Options paths = rays;
    use_paths(paths);
    return {{"rays", rays}, {"deep maps", by_maps(rays, LampMethod::deep, CrossingMethod::ray_deep)}, {"paths", paths}};
}

void compare_other_order(const Options& rays, const Scene& as_grown, std::vector<Figure>& figures) {
    const Scene other = changed_tufts([](const StrandSet& s) { return shuffled(s, 11); });
    for (const MethodSet& set : all_kinds(rays))
        figures.push_back(at_most(std::string("relMSE of another order, ") + set.name,
                                  relative_error(render(as_grown, set.options), render(other, set.options)), 1e-6));
    for (const MethodSet& set : in_the_order_of_rays(rays)) {
        const LayeredImage first = render(as_grown, set.options).picture;
        const size_t different = different_values(first, render(other, set.options).picture);
        figures.push_back(exactly(
            std::string("bits: values that differ, ") + set.name + ", cutoff 0, of " + std::to_string(values(first)),
            double(different), 0));
    }
}

/// Directions are drawn in a fiber's own frame: turned round, it draws others, and only lamps light without noise.
void compare_from_tips(const Options& rays, const Scene& as_grown, std::vector<Figure>& figures) {
    const Scene from_tips = changed_tufts([](const StrandSet& s) { return reversed(s); });
    Options lamps = rays;
    for (int t = 1; t < kPathTypes; ++t) switch_off(lamps, PathType(t));
    for (const auto& [method, name] :
         {std::pair(LampMethod::ray, "rays"), {LampMethod::deep, "deep maps"}, {LampMethod::clusters, "clusters"}}) {
        lamps.type1 = method;
        figures.push_back(at_most(std::string("relMSE from tip to root, type 1 by ") + name,
                                  relative_error(render(as_grown, lamps), render(from_tips, lamps)), 1e-6));
    }
    figures.push_back(told("mean of types 1 to 3 from tip to root, standard errors apart",
                           errors_apart(render(as_grown, rays).state.film, render(from_tips, rays).state.film)));
}

}  // namespace

Outcome measure_order_of_strands(const CheckSettings& settings) {
    const Scene as_grown = changed_tufts([](const StrandSet& s) { return s; });
    const Options rays = by_rays(settings.isa);
    Outcome outcome;
    compare_other_order(rays, as_grown, outcome.figures);
    compare_from_tips(rays, as_grown, outcome.figures);
    return outcome;
}

}  // namespace tress
