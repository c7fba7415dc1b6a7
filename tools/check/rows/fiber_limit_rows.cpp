// SPDX-License-Identifier: MIT
#include "tools/check/rows/fiber_limit_rows.h"

#include "core/attenuation.h"
#include "core/error.h"
#include "core/fiber_chiang.h"
#include "core/fiber_marschner.h"
#include "core/marschner_azimuthal.h"
#include "tools/check/support/fiber_extremes.h"

namespace tress {
namespace {

constexpr double kTolerance = 1e-3;
constexpr FiberModel kModels[] = {FiberModel::chiang, FiberModel::marschner};

Fiber fiber_of_index(float eta, FiberModel model = FiberModel::chiang) {
    FiberParameters q;
    q.model = model;
    q.eta = eta;
    return make_fiber(q);
}

std::string of_tried(const char* what, const Soundness& s) { return what + (" of " + std::to_string(s.tried)); }

Figure none_unsound(const Soundness& s) {
    return exactly(of_tried("negative, infinite or no number:", s), double(s.unsound), 0);
}

/// Energies of the lobes of clear glass, over extreme directions and offsets.
struct LobeWeights {
    double least_forward = 1, most_forward = 1, other = 0;
    int places = 0;
};

LobeWeights weights_at_index(float eta) {
    const Fiber fiber = fiber_of_index(eta);
    LobeWeights w;
    for (const Vec3& wo : extreme_directions())
        for (const float h : kOffsetEnds) {
            const ChiangPoint point = make_chiang_point(fiber, Rgb(0), wo, h);
            for (int p = 0; p < Fiber::kLobes; ++p) {
                const double energy = double(point.energy[p].x);
                if (p != Fiber::kTransmitted) w.other = std::max(w.other, energy);
            }
            const double forward = double(point.energy[Fiber::kTransmitted].x);
            w.least_forward = std::min(w.least_forward, forward), w.most_forward = std::max(w.most_forward, forward);
            ++w.places;
        }
    return w;
}

/// Greatest f_R of the far field model at an index of 1.
double far_field_reflects() {
    const Fiber fiber = fiber_of_index(1, FiberModel::marschner);
    double most = 0;
    for (const Vec3& wo : extreme_directions())
        for (const Vec3& wi : extreme_directions())
            most = std::max(most, double(max_component(evaluate(fiber, Rgb(0), wo, wi, 0).reflected)));
    return most;
}

/// Greatest share that does not go straight through, averaged over h, up to 86 degrees from the normal plane.
double turned_away(float eta) {
    double most = 0;
    for (const double theta : {0.0, 0.5, -1.0, 1.3, 1.5})
        most =
            std::max(most, std::abs(1 - double(forward_albedo(fiber_of_index(eta), Rgb(0), float(std::sin(theta))).x)));
    return most;
}

double taken_below_one() {
    int taken = 0;
    for (const float eta : {std::nextafter(1.0f, 0.0f), 0.9f, 0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        try {
            make_fiber({FiberModel::chiang, Rgb(0), 0.3f, 0.3f, 2, eta});
            ++taken;
        } catch (const InputError&) {
        }
    }
    return taken;
}

Outcome index_near_one(const CheckSettings&) {
    const float least_above = std::nextafter(1.0f, 2.0f);
    const LobeWeights one = weights_at_index(1);
    Soundness sound;
    for (const FiberModel model : kModels)
        for (const float eta : {1.0f, least_above, 1.000001f, 1.0001f, 1.01f, 1.1f, 10.0f})
            try_all(fiber_of_index(eta, model), extreme_directions(), sound);
    const double near_one = turned_away(least_above), farther = turned_away(1.0001f), far = turned_away(1.01f);
    return {
        {exactly("largest weight of R, TRT and the rest at an index of 1, " + std::to_string(one.places) + " places",
                 one.other, 0),
         exactly("least weight of TT there", one.least_forward, 1),
         exactly("largest weight of TT there", one.most_forward, 1),
         exactly("largest f_R of the far field model there", far_field_reflects(), 0),
         at_most("1 - TT at the next index above 1, largest of 5 inclinations", near_one, kTolerance),
         told("1 - TT at 1.0001", farther), told("1 - TT at 1.01", far),
         holds("1 - TT less the nearer the index is to 1", near_one <= farther && farther <= far),
         exactly("indices below 1 that are taken, of 5", taken_below_one(), 0), none_unsound(sound)},
        {}};
}

Outcome grazing(const CheckSettings&) {
    const Soundness all = try_all_extremes();
    return {{at_least("values asked for, to the exact ends of theta and h and a rounding past them", double(all.tried),
                      1e6),
             none_unsound(all)},
            {}};
}

/// Nothing but R is left of the far field model: its greatest relative error, TT and TRT included.
double far_field_beside_r() {
    const Fiber fiber = fiber_of_index(1.55f, FiberModel::marschner);
    double worst = 0;
    for (uint64_t k = 0; k < 1000; ++k) {
        const double theta_o = 2.8 * double(random(1, k)) - 1.4, theta_i = -theta_o + 0.4 * double(random(2, k)) - 0.2;
        const double phi = 6 * double(random(3, k)) - 3;
        const FiberScattering value =
            evaluate(fiber, Rgb(kInfinity), direction(theta_o, 0), direction(theta_i, phi), 0);
        const CrossSection section = make_cross_section(double(1.55f), marschner_cos_theta_d(theta_i, theta_o));
        const double r = std::max(marschner_longitudinal(fiber, 0, theta_i, theta_o), 0.0) * azimuthal_r(section, phi);
        if (r > 1e-6) worst = std::max(worst, std::abs(double(value.forward.x + value.reflected.x) - r) / r);
    }
    return worst;
}

Outcome absorption_ends(const CheckSettings&) {
    const Fiber fiber = fiber_of_index(1.55f);
    const Rgb ends(0, 1, kInfinity);  // side by side: one channel must not spoil another
    double clear = 0, black = 0, forward = 0;
    for (const double theta : {0.0, -0.6, 1.1, 1.5, kPiD / 2})
        for (const double h : {0.0, -0.6, 0.95, 1.0}) {
            const Albedo albedo = albedo_of(fiber, ends, theta, 0, h);
            clear = std::max(clear, std::abs(albedo.forward.x + albedo.reflected.x - 1));
            black = std::max(black, std::abs(albedo.reflected.z - first_reflectance(1.55, theta, h)));
            forward = std::max(forward, albedo.forward.z);
        }
    Soundness sound;
    for (const FiberModel model : kModels)
        for (const float sigma_a : {0.0f, 1e-45f, 1e-30f, 1e30f, std::numeric_limits<float>::max(), kInfinity})
            try_all(make_fiber({model, Rgb(sigma_a, 0, 1), 0.3f, 0.3f, 2, 1.55f}), extreme_directions(), sound);
    FiberParameters q;
    q.sigma_a = ends;
    double deepest = 0;
    for (const Rgb& depth : make_attenuation_table(make_fiber(q)).depth)
        deepest = std::max({deepest, double(depth.x), double(depth.y), double(depth.z)});
    return {
        {at_most("absorption 0: largest |albedo - 1|, 20 furnaces", clear, kTolerance),
         exactly("infinite: largest albedo of TT", forward, 0),
         at_most("infinite: |albedo - reflectance of the first wall|, 20 furnaces", black, kTolerance),
         at_most("infinite, far field model: relative error of R alone, 1000 pairs", far_field_beside_r(), kTolerance),
         at_most("largest depth in a table of a_k", deepest, double(kOpaqueDepth)), none_unsound(sound)},
        {}};
}

}  // namespace

std::vector<CheckRow> fiber_limit_rows() {
    return {{"D28", "Index of refraction to 1, at 1, below 1",
             "No reflection at 1; what goes straight through tends to 1; below 1 refused; nothing infinite.",
             index_near_one},
            {"D29", "Grazing light, and hits at the very rim", "Finite to the exact ends of theta and h.", grazing},
            {"D30", "Absorption 0 and infinite", "All light scattered, or R alone; infinity times 0 never formed.",
             absorption_ends}};
}

}  // namespace tress
