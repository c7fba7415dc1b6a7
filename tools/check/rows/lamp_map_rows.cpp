// SPDX-License-Identifier: MIT
#include "tools/check/rows/lamp_map_rows.h"

#include "gather/shadow_maps/ribbon.h"
#include "tools/check/support/hair_lit_by_lamp.h"
#include "tools/check/support/turned_scene.h"

namespace tress {
namespace {

using namespace test;

constexpr int kRays = 256;         // through the texels of a look-up
constexpr uint64_t kPlaces = 800;  // all over the hair, a case

/// Texels a quarter as wide as fibers, and a bound on light that is one on depth too where little is left.
Options fine_deep_maps(Isa isa) {
    Options options = by_maps(MapKind::deep);
    options.maps.resolution = 512;
    options.deep.error = 0.005f;
    options.isa = isa;
    return options;
}

/// Light through places of a view, backwards: from a depth to the lamp, or to before all hair.
class LightThrough {
public:
    explicit LightThrough(const LightView& view) : view_(view) {
        // Axes are not exactly square to one another, which tells from a lamp that is far away.
        const glm::dmat3 to_local = transpose(glm::dmat3(view.frame.x, view.frame.y, view.frame.z));
        to_world_ = inverse(to_local);
    }

    void add(RayBuffer& rays, const glm::dvec2& place, double depth) const {
        constexpr double kBefore = 1;
        const Vec3 from(at(place, view_.start + depth));
        const double first = view_.start - kBefore;
        const DVec3 way = at(place, view_.parallel ? first : std::max(first, 0.0)) - DVec3(from);
        rays.add(from, Vec3(normalize(way)), short_of(from, float(length(way))), {});
    }

private:
    /// `z`: along the view, from its origin.
    DVec3 at(const glm::dvec2& place, double z) const {
        const glm::dvec2 across = (view_.low + place * view_.texel) * (view_.parallel ? 1 : z);
        return view_.origin + to_world_ * DVec3(across, z);
    }

    const LightView& view_;
    glm::dmat3 to_world_;
};

/// Four numbers in [0, 1), of which every beginning of the sequence is spread evenly: multiples of powers of the root
/// of x^5 = x + 1 (a Kronecker sequence), from a random start.
glm::dvec4 spread_evenly(uint64_t key, int i) {
    constexpr double kRoot = 1.1673039782614187;
    glm::dvec4 u;
    double step = 1;
    for (int k = 0; k < 4; ++k) {
        step /= kRoot;
        u[k] = glm::fract(double(tress::random(key, uint64_t(k))) + step * (i + 1));
    }
    return u;
}

/// Rays through the texels that a look-up at `at` takes, as many in each as it weighs there.
RayBuffer rays_through_texels(const LightView& view, const ViewPoint& at, uint64_t key) {
    const LightThrough light(view);
    const glm::dvec2 last(view.width - 1, view.height - 1);
    RayBuffer rays;
    for (int i = 0; i < kRays; ++i) {
        const glm::dvec4 u = spread_evenly(key, i);
        const glm::dvec2 about = glm::dvec2(double(at.x), double(at.y)) - 0.5 + glm::dvec2(u.x, u.y);
        const glm::dvec2 texel = clamp(floor(about), glm::dvec2(0), last);
        light.add(rays, texel + glm::dvec2(u.z, u.w), double(at.depth));
    }
    return rays;
}

/// Whether the axis of a segment is on maps at `u`: nothing of it that touches the lamp is (ribbon.h).
bool is_on_maps(const LightView& view, const SegmentView& hair, uint32_t segment, double u) {
    const DVec3 start = to_local(view, DVec3(hair.start(segment))), end = to_local(view, DVec3(hair.end(segment)));
    const DVec3 axis = end - start;
    const double along = glm::clamp(-dot(start, axis) / dot(axis, axis), 0.0, 1.0);
    const double near = kNearRadii * double(std::max(hair.start_radius(segment), hair.end_radius(segment)));
    return view.parallel || (length(start + along * axis) >= near && start.z + u * axis.z >= near);
}

/// Mean of what is left of rays: by hair that maps hold, and by all of it.
struct Left {
    double by_held = 0, by_all = 0;
};

Left left_of(const RayBuffer& rays, const LightView& view, const Lit& l) {
    const SegmentView& hair = l.prepared.segments;
    const Crossings met = crossings(l.prepared.hair, rays.for_hair(), l.options.isa);
    Left left;
    for (size_t ray = 0; ray < rays.size(); ++ray) {
        Rgb held(0), all(0);
        for (uint64_t k = met.first[ray]; k < met.first[ray + 1]; ++k) {
            const uint32_t segment = met.id[k];
            const Vec3 axis = normalize(hair.end(segment) - hair.start(segment));
            const float sine = std::min(std::abs(dot(axis, rays.direction(ray))), 1.0f);
            const Rgb depth = l.prepared.attenuation.depth(segment, sine);
            all += depth;
            if (is_on_maps(view, hair, segment, double(met.u[k]))) held += depth;
        }
        left.by_held += double(mean(exp(-held))) / double(rays.size());
        left.by_all += double(mean(exp(-all))) / double(rays.size());
    }
    return left;
}

/// Optical depths of maps against rays, means.
struct DepthError {
    double error = 0;   // |map - rays|
    double of_all = 0;  // the same where rays meet hair that the lamp touches
    double depth = 0;   // by rays
};

/// At points all over the box of hair.
DepthError depth_error(const Lit& l) {
    const Bounds& box = l.scene.bounds;
    const auto depth_of = [&](double left) { return -std::log(std::max(left, double(l.options.cutoff))); };
    DepthError sum;
    double seen = 0;
    for (uint64_t i = 0; i < kPlaces; ++i) {
        const Vec3 share(tress::random(5, 3 * i), tress::random(5, 3 * i + 1), tress::random(5, 3 * i + 2));
        const MapPlace at = place_on(maps_of(l), l.scene.lights[0], 0, Vec2(0), box.lo + share * box.extent());
        if (!at.map) continue;
        const LightView& view = at.map->view;
        const Left left = left_of(rays_through_texels(view, at.at, i), view, l);
        const double by_map = depth_of(double(mean(transmittance(*at.map, at.at))));
        sum.error += std::abs(by_map - depth_of(left.by_held));
        sum.of_all += std::abs(by_map - depth_of(left.by_all));
        sum.depth += depth_of(left.by_all);
        ++seen;
    }
    return {sum.error / seen, sum.of_all / seen, sum.depth / seen};
}

struct LampCase {
    std::string name;
    Light lamp;
    std::vector<PlacedHair> hair;
};

std::vector<LampCase> lamp_cases() {
    constexpr size_t kBeside = 150, kWithin = 6;  // strands 2.1 and 0.4 radii from the next one
    const PlacedHair ball = fair_ball();
    std::vector<LampCase> all;
    for (const PlacedLamp& placed : lamps_about_ball()) all.push_back({placed.name, placed.lamp, {ball}});
    all.push_back({"straight up", DistantLight{{0, 1, 0}, Rgb(1)}, {ball}});
    all.push_back({"nearly straight down", DistantLight{{1e-7, -1, 0}, Rgb(1)}, {ball}});
    all.push_back({"at a hair point, beside another hair", lamp_at_hair(ball, kBeside), {ball}});
    all.push_back({"at a hair point, within another hair", lamp_at_hair(ball, kWithin), {ball}});
    all.push_back({"with hair behind it", PointLight{}, {fair_ball({0, 0, -2.5f}), fair_ball({0, 0, 2.5f})}});
    return all;
}

/// Largest difference that turning hair and lamp makes to the mean of what is left of the light.
double change_by_turning(Isa isa) {
    constexpr uint64_t kTurns = 4;
    const Options options = fine_deep_maps(isa);
    const Lit upright = lit({fair_ball()}, {}, PointLight{{1, 2, 5}, Rgb(1)}, options);
    const double mean = mean_visibility(upright);
    double most = 0;
    for (uint64_t turn = 0; turn < kTurns; ++turn) {
        const Lit about = lit(turned(upright.scene, random_turn(turn)), options);
        most = std::max(most, std::abs(mean_visibility(about) - mean));
    }
    return most;
}

Outcome awkward_lamps(const CheckSettings& settings) {
    constexpr double kDepthBound = 0.02, kTurnBound = 1e-3;
    const std::string of_places =
        ": mean |tau - tau of " + std::to_string(kRays) + " rays|, up to " + std::to_string(kPlaces) + " points";
    Outcome outcome;
    double touched = 0, depth = 0;
    const std::vector<LampCase> cases = lamp_cases();
    for (const LampCase& c : cases) {
        const DepthError e = depth_error(lit(c.hair, {}, c.lamp, fine_deep_maps(settings.isa)));
        outcome.figures.push_back(at_most("lamp " + c.name + of_places, e.error, kDepthBound));
        touched = std::max(touched, e.of_all);
        depth += e.depth / double(cases.size());
    }
    outcome.figures.push_back(told("largest of these were hair that the lamp touches counted", touched));
    outcome.figures.push_back(told("mean tau", depth));
    outcome.figures.push_back(at_most("change of the mean transmittance by turning the scene, largest of 4 turns",
                                      change_by_turning(settings.isa), kTurnBound));
    return outcome;
}

}  // namespace

std::vector<CheckRow> lamp_map_rows() {
    return {{"D34", "Deep shadow maps of lamps in awkward places",
             "Hair counts between lamp and point alone, wherever the lamp is and however the scene is turned; what the "
             "lamp touches, within two radii, counts for nothing. Maps of 512 texels, deep.error 0.005, asked without "
             "rays next to the point.",
             awkward_lamps}};
}

}  // namespace tress
