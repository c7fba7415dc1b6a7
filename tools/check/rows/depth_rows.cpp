// SPDX-License-Identifier: MIT
#include <algorithm>

#include "accel/build.h"
#include "accel/transmission_powers.h"
#include "gather/shadow_maps/cluster_texels.h"
#include "gather/shadow_maps/deep_texels.h"
#include "gather/shadow_maps/opacity_texels.h"
#include "gather/shadow_maps/optical_depth.h"
#include "tools/check/rows/lamp_map_rows.h"
#include "tools/check/support/hair_views.h"
#include "tools/check/support/step_functions.h"
#include "tools/number_text.h"

namespace tress {
namespace {

constexpr float kCutoff = 1e-6f;  // of Options

/// Fibers along x that a ray along z from the origin meets one after another, one at each whole number from 1 on.
struct Layers {
    scenes::Hair hair;
    KdTree tree;

    explicit Layers(size_t count) {
        for (size_t i = 1; i <= count; ++i) hair.add({-0.5f, 0, float(i)}, {0.5f, 0, float(i)}, 0.1f);
        tree = build_segment_tree(hair.view(), {});
    }
};

/// Rays that end behind 0, `step`, 2 `step` ... layers, up to `most`.
scenes::Rays rays_through(size_t step, size_t most) {
    scenes::Rays rays;
    for (size_t layers = 0; layers <= most; layers += step) rays.add(Vec3(0), {0, 0, 1}, 0, float(layers) + 0.5f);
    return rays;
}

std::vector<float> transmittances(const Layers& layers, const scenes::Rays& rays, float depth, float cutoff, Isa isa) {
    std::vector<Rgb> light(rays.size());
    transmittance(layers.tree, rays.batch(), fragments::constant_attenuation(Rgb(depth)), cutoff, light, isa);
    std::vector<float> red;
    for (const Rgb& t : light) red.push_back(t.x);
    return red;
}

/// Layers of one opacity in one texel.
FragmentTile layered_tile(size_t layers, float opacity) {
    FragmentTile tile;
    tile.first = {0, uint32_t(layers)};
    tile.opacity[0].assign(layers, opacity);
    for (size_t i = 0; i < layers; ++i) tile.depth.push_back(float(i));
    return tile;
}

/// Relative error of -log T of maps that keep depths, behind all layers of one texel.
double error_of_maps(size_t layers, float opacity) {
    const FragmentTile tile = layered_tile(layers, opacity);
    const double exact = -double(layers) * std::log1p(-double(opacity));
    const OpacityTexels planes = make_opacity_texels(tile, {}, {0, float(layers)});
    const ClusterTexels clusters = make_cluster_texels(tile, {});
    double worst = 0;
    for (const float t :
         {transmittance(planes, 0, 2 * float(layers)).x, transmittance(clusters, 0, 2 * float(layers)).x})
        worst = std::max(worst, std::abs(-std::log(double(t)) / exact - 1));
    return worst;
}

/// Largest relative error of tau of rays that end behind more and more layers.
double error_of_rays(size_t count, size_t step, float depth, Isa isa) {
    const Layers layers(count);
    const std::vector<float> light = transmittances(layers, rays_through(step, count), depth, kCutoff, isa);
    double worst = 0;
    for (size_t i = 1; i < light.size(); ++i)
        worst = std::max(worst, std::abs(-std::log(double(light[i])) / (double(i * step) * double(depth)) - 1));
    return worst;
}

bool is_denormal(float v) { return v != 0 && std::abs(v) < std::numeric_limits<float>::min(); }

Outcome many_layers(const CheckSettings& settings) {
    constexpr size_t kLayers = 10'000;
    constexpr double kTauBound = 1e-5, kDeepest = 14;
    Outcome outcome;
    const Layers layers(kLayers);
    size_t denormal = 0, without_cutoff = 0, rays = 0;
    for (const double alpha : {0.05, 0.3, 0.7}) {
        const float depth = optical_depth(float(alpha));
        const std::vector<float> light = transmittances(layers, rays_through(1, kLayers), depth, kCutoff, settings.isa);
        const std::string at = "alpha " + significant(alpha, 1) + ", 1e4 layers: ";
        outcome.figures.push_back(at_most(at + "what is left", double(light.back()), double(kCutoff)));
        outcome.figures.push_back(at_most(at + "summed before the ray is given up",
                                          std::round(-std::log(double(light.back())) / double(depth)),
                                          std::ceil(kDeepest / double(depth))));
        denormal += size_t(std::count_if(light.begin(), light.end(), is_denormal));
        const std::vector<float> all = transmittances(layers, rays_through(1, kLayers), depth, 0, settings.isa);
        without_cutoff += size_t(std::count_if(all.begin(), all.end(), is_denormal));
        rays += light.size();
    }
    const std::string of_rays = ", of " + std::to_string(rays) + " rays";
    outcome.figures.push_back(exactly("denormal transmittances" + of_rays, double(denormal), 0));
    outcome.figures.push_back(told("denormal transmittances with a cutoff of 0" + of_rays, double(without_cutoff)));
    outcome.figures.push_back(at_most("relative error of tau, up to 1e4 layers of alpha 1e-4, 100 rays",
                                      error_of_rays(kLayers, 100, optical_depth(1e-4f), settings.isa), kTauBound));
    outcome.figures.push_back(at_most("relative error of tau, up to 1e6 layers of alpha 1e-5, 10 rays",
                                      error_of_rays(1'000'000, 100'000, optical_depth(1e-5f), settings.isa),
                                      kTauBound));
    outcome.figures.push_back(at_most("relative error of tau of opacity maps and clusters, 1e6 layers of alpha 1e-5",
                                      error_of_maps(1'000'000, 1e-5f), kTauBound));
    return outcome;
}

/// A fiber of no refraction that stops `alpha` of what meets it square on: on average it is pi / 2 radii thick.
Attenuation thin_fiber(double alpha) {
    FiberParameters q;
    q.eta = 1;
    q.sigma_a = Rgb(float(alpha * 2 / std::acos(-1.0)));
    return {{make_attenuation_table(make_fiber(q))}, {}, {}, {}};
}

Attenuation black_fiber() {
    FiberParameters q;
    q.sigma_a = Rgb(kInfinity);
    return {{make_attenuation_table(make_fiber(q))}, {}, {}, {}};
}

/// tau of `rays` rays through `count` layers each, taken together.
double tau_of_stacks(size_t count, size_t rays, double alpha, Isa isa) {
    const Layers layers(count);
    scenes::Rays through;
    for (size_t i = 0; i < rays; ++i) through.add(Vec3(0), {0, 0, 1}, 0, float(count) + 0.5f);
    std::vector<Rgb> light(rays);
    transmittance(layers.tree, through.batch(), thin_fiber(alpha), kCutoff, light, isa);
    double tau = 0;
    for (const Rgb& t : light) tau -= std::log(double(t.x));
    return tau;
}

Outcome faint_and_opaque(const CheckSettings& settings) {
    constexpr double kAlpha = 1e-8, kTolerance = 1e-3;
    constexpr size_t kOpaqueLayers = 1000;
    const Layers layers(kOpaqueLayers);
    const scenes::Rays rays = rays_through(1, kOpaqueLayers);
    double most = 0, unsound = 0;
    for (const float cutoff : {0.0f, kCutoff}) {
        std::vector<Rgb> light(rays.size());
        transmittance(layers.tree, rays.batch(), black_fiber(), cutoff, light, settings.isa);
        for (size_t i = 0; i < light.size(); ++i) {
            unsound += !(std::isfinite(light[i].x) && light[i].x >= 0);
            if (i > 0) most = std::max(most, double(light[i].x));
        }
    }
    const FragmentTile wall = layered_tile(1, 1);
    const double behind[] = {double(transmittance(make_deep_texels(wall, 0.02f), 0, 1).x),
                             double(transmittance(make_opacity_texels(wall, {}, {0, 1}), 0, 2).x),
                             double(transmittance(make_cluster_texels(wall, {}), 0, 1).x)};
    return {{told("1 - 1e-8 in single precision", double(1 - float(kAlpha))),
             within("depth of a fragment of alpha = 1e-8, over alpha", double(optical_depth(float(kAlpha))) / kAlpha, 1,
                    kTolerance),
             within("depth of a fiber that stops 1e-8, over alpha", double(thin_fiber(kAlpha).depth(0, 0).x) / kAlpha,
                    1, kTolerance),
             within("tau of 1e8 such layers, as 100 stacks of 1e6", tau_of_stacks(1'000'000, 100, kAlpha, settings.isa),
                    1, kTolerance),
             at_most("light through 1 to 1000 layers of alpha = 1, largest", most, double(kCutoff)),
             exactly("of these, negative, infinite or no number", unsound, 0),
             exactly("light through 1 layer of transmission 0", double(TransmissionPowers{0.0}(1)), 0),
             at_most("light behind a wall on maps of three kinds, largest", *std::max_element(behind, behind + 3),
                     double(kCutoff))},
            {}};
}

Outcome compression(const CheckSettings&) {
    constexpr uint64_t kCases = 100'000;
    double over = 0, rising = 0, outside = 0, inexact = 0, share = 0;
    StepCompressor compress;
    StepNodes nodes;
    for (uint64_t i = 0; i < kCases; ++i) {
        const StepCase tried = step_case(i);
        const float bound = kStepBounds[tried.bound];
        compress(tried.steps.view(), bound, nodes);
        const double error = greatest_error(tried.steps, nodes);
        over += !(error <= double(bound));
        rising += !is_monotone(tried.steps, nodes);
        outside += !is_within_unit(tried.steps, nodes);
        inexact += !starts_exactly(tried.steps, nodes);
        if (bound > 0) share = std::max(share, error / double(bound));
    }
    return {{exactly("cases that err by more than their bound, of 1e5", over, 0),
             told("largest share of its bound that a case takes", share), exactly("cases that rise", rising, 0),
             exactly("cases that leave [0, 1]", outside, 0),
             exactly("cases whose first node is not the first step to the bit", inexact, 0)},
            {}};
}

}  // namespace

std::vector<CheckRow> depth_rows() {
    std::vector<CheckRow> rows = {
        {"D32", "A ray through 1e4 layers of hair",
         "Given up once less than 1e-6 is left; depths summed without loss up to 1e6 layers; no denormal numbers.",
         many_layers},
        {"D33", "Hair that stops 1e-8 of the light, or all of it",
         "What 1 - alpha would lose in rounding is kept as a depth; an opaque layer lets nothing through; all finite.",
         faint_and_opaque},
        {"D35", "Compression of deep shadow maps",
         "Nowhere wrong by more than the bound; falls, stays in [0, 1], starts at the first depth exactly.",
         compression}};
    const std::vector<CheckRow> lamps = lamp_map_rows();
    rows.insert(rows.end(), lamps.begin(), lamps.end());
    return rows;
}

}  // namespace tress
