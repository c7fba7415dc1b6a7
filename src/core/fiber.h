// SPDX-License-Identifier: MIT
// How one fiber scatters light: f(wi, wo; u, h), split into f = f_F + f_R, where f_F is the TT lobe (straight through)
// and f_R all the rest. Directions are unit and local to the fiber: x along the tangent u; theta is measured from the
// normal plane (sin theta = x); wo points to the eye, wi to the light. h in [-1, 1] is the signed offset of the hit
// from the axis in radii, seen from wo: the hit lies at h * normalize(cross(u, wo)) from the axis. The tangent runs
// from root to tip: only the tilt of the scales tells the two apart.
#pragma once

#include <span>

#include "core/azimuthal.h"
#include "core/longitudinal.h"
#include "core/math.h"

namespace tress {

enum class FiberModel { chiang, marschner };

/// What a scene says of a fiber.
struct FiberParameters {
    FiberModel model = FiberModel::chiang;
    Rgb sigma_a{0};           // absorption, 1 per fiber radius; may be infinite
    float beta_m = 0.3f;      // longitudinal roughness, [0, 1]
    float beta_n = 0.3f;      // azimuthal roughness, [0, 1]
    float alpha_degrees = 2;  // tilt of the cuticle scales, [-45, 45]
    float eta = 1.55f;        // refractive index, relative to air, [1, 10]
};

/// sigma_a of a mixture of melanins (d'Eon et al. 2011, sec. 6.1, as used by Chiang et al. 2016; concentrations >= 0).
Rgb sigma_a_from_melanin(float eumelanin, float pheomelanin);
/// sigma_a whose multiply scattered colour is `color` at azimuthal roughness beta_n (Chiang et al. 2016, eq. 9).
Rgb sigma_a_from_color(const Rgb& color, float beta_n);

/// A fiber made ready: what depends on its parameters alone.
struct Fiber {
    static constexpr int kLobes = 4;  // R, TT, TRT, and all the rest
    static constexpr int kTransmitted = 1;

    FiberParameters parameters;
    LongitudinalLobe longitudinal[kLobes];
    float shift[kLobes];  // of theta_i + theta_o at the peak of a lobe, radians
    SinCos tilt[kLobes];  // sine and cosine of `shift`
    AzimuthalLobe azimuthal;
};

/// Throws InputError, naming the parameter, where one is out of its range or not a number.
Fiber make_fiber(const FiberParameters& parameters);

/// Both parts of f * |cos theta_i|. The cosine is included because f alone is infinite at grazing wi.
/// Reversing the light keeps f * |cos theta_i|, averaged over h, where alpha = 0 and |theta_i| = |theta_o| or eta = 1;
/// elsewhere it differs, at the default roughness by less than 8 % of the sum of both, on average (chiang).
struct FiberScattering {
    Rgb forward{0};    // f_F |cos theta_i|
    Rgb reflected{0};  // f_R |cos theta_i|
};

/// `sigma_a` overrides the fiber's own absorption (strands with colours of their own).
FiberScattering evaluate(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h);
/// The same for many wi, at the cost of one preparation. `value` has the size of `wi`.
void evaluate(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, std::span<const Vec3> wi,
              std::span<FiberScattering> value);

struct FiberSample {
    Vec3 wi;
    float pdf;  // 1 / steradian; 0: no direction
    FiberScattering value;
};

/// What is sampled and evaluated: f, or f_R alone.
enum class FiberLobes { all, reflected };

/// Direction with density near proportional to f |cos theta_i|. `u` is uniform in [0, 1)^4.
FiberSample sample(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, const glm::vec4& u,
                   FiberLobes lobes = FiberLobes::all);
/// As many directions as `drawn`, at the cost of one preparation. `u` has as many rows.
void sample(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, std::span<const glm::vec4> u,
            std::span<FiberSample> drawn, FiberLobes lobes = FiberLobes::all);
/// The density with which `sample` chooses wi.
float pdf(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h);
/// Both at once, for little more than one of them: what `sample` would say had it drawn wi.
FiberSample evaluate_with_pdf(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h,
                              FiberLobes lobes = FiberLobes::all);

/// Albedo of the TT lobe for light that arrives at inclination theta, averaged over h: the a_k of the straight-through
/// model. By quadrature; renderers use the table of attenuation.h.
Rgb forward_albedo(const Fiber& fiber, const Rgb& sigma_a, float sin_theta);

}  // namespace tress
