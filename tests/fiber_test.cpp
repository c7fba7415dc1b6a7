// SPDX-License-Identifier: MIT
// The near field model as a whole: energy, sampling, reciprocity, extremes.
#include "core/fiber.h"

#include <doctest/doctest.h>

#include "tools/check/support/fiber_extremes.h"
#include "tools/check/support/fiber_reciprocity.h"

using namespace tress;

namespace {

const float kRoughness[] = {0, 1e-3f, 0.01f, 0.1f, 0.3f, 1};

/// f |cos theta_i| in double, from the formulas as published: angles, Bessel functions and the series term by term.
struct Direct {
    double forward = 0, reflected = 0;
};

double direct_longitudinal(double theta_i, double theta_o, double v) {
    return std::exp(-std::sin(theta_i) * std::sin(theta_o) / v) *
           std::cyl_bessel_i(0.0, std::cos(theta_i) * std::cos(theta_o) / v) / (2 * v * std::sinh(1 / v));
}

double direct_azimuthal(double x, double s) {
    const auto below = [&](double t) { return 1 / (1 + std::exp(-t / s)); };
    const double e = std::exp(-std::remainder(x, 2 * kPiD) / s);
    return e / (s * square(1 + e)) / (below(kPiD) - below(-kPiD));
}

Direct direct(const FiberParameters& q, double sigma_a, double theta_o, double phi_o, double theta_i, double phi_i,
              double h) {
    const double m = double(q.beta_m), n = double(q.beta_n), eta = double(q.eta);
    const double alpha = double(q.alpha_degrees) * kPiD / 180;
    const double v = square(0.726 * m + 0.812 * m * m + 3.7 * std::pow(m, 20));
    const double s = std::sqrt(kPiD / 8) * (0.265 * n + 1.194 * n * n + 5.372 * std::pow(n, 22));
    const double gamma_o = std::asin(h), sin_t = std::sin(theta_o) / eta, cos_t = std::sqrt(1 - sin_t * sin_t);
    const double bravais = std::sqrt(eta * eta - square(std::sin(theta_o))) / std::cos(theta_o);
    const double gamma_t = std::asin(h / bravais);
    const double transmittance = std::exp(-sigma_a * 2 * std::cos(gamma_t) / cos_t);

    const double cos_1 = std::cos(theta_o) * std::cos(gamma_o), cos_2 = std::sqrt(1 - (1 - cos_1 * cos_1) / eta / eta);
    const double rs = (cos_1 - eta * cos_2) / (cos_1 + eta * cos_2), rp = (eta * cos_1 - cos_2) / (eta * cos_1 + cos_2);
    const double f = (rs * rs + rp * rp) / 2;

    Direct value;
    const double variance[] = {v, v / 4, 4 * v}, shift[] = {2 * alpha, -alpha, -4 * alpha};
    double energy = f;
    for (int p = 0; p < 400; ++p) {
        if (p == 1) energy = square(1 - f) * transmittance;
        if (p > 1) energy *= f * transmittance;
        const double exit = phi_o + 2 * gamma_o + p * (kPiD - 2 * gamma_t);
        double tilted = p < 3 ? theta_o + shift[p] : theta_o;
        if (std::abs(tilted) > kPiD / 2) tilted = std::copysign(kPiD, tilted) - tilted;
        const double along = direct_longitudinal(theta_i, tilted, p < 3 ? variance[p] : 4 * v);
        const double around = p < 3 ? direct_azimuthal(phi_i - exit, s) : 1 / (2 * kPiD);
        (p == 1 ? value.forward : value.reflected) += energy * along * around;
    }
    return value;
}

Albedo furnace(const Fiber& fiber, double theta, double h) { return albedo_of(fiber, Rgb(0), theta, 0.4, h); }

}  // namespace

TEST_CASE("both parts of f are the published formulas in double precision") {
    uint64_t tested = 0;
    for (const float beta_m : {0.15f, 0.3f, 0.7f, 1.0f})
        for (const float beta_n : {0.1f, 0.4f, 1.0f})
            for (uint64_t k = 0; k < 300; ++k) {
                FiberParameters q;
                q.beta_m = beta_m;
                q.beta_n = beta_n;
                q.alpha_degrees = 3;
                const uint64_t key = hash(7, k);
                const Vec3 wo = uniform_direction(hash(key, 0)), wi = uniform_direction(hash(key, 1));
                const float h = 2 * random(key, 2) - 1, sigma_a = 2 * random(key, 3);
                const FiberScattering value = evaluate(make_fiber(q), Rgb(sigma_a), wo, wi, h);
                const auto theta = [](const Vec3& w) {
                    return std::atan2(double(w.x), std::hypot(double(w.y), double(w.z)));
                };
                const auto phi = [](const Vec3& w) { return std::atan2(double(w.z), double(w.y)); };
                const Direct expected = direct(q, double(sigma_a), theta(wo), phi(wo), theta(wi), phi(wi), double(h));
                CAPTURE(beta_m);
                CAPTURE(beta_n);
                CAPTURE(k);
                // Exponents reach 2 / v = 450 and pi / s = 129, each rounded to a few 6e-8.
                CHECK(std::abs(double(value.forward.x) - expected.forward) <= 1e-4 * expected.forward + 1e-30);
                CHECK(std::abs(double(value.reflected.x) - expected.reflected) <= 1e-4 * expected.reflected + 1e-30);
                ++tested;
            }
    CHECK(tested == 3600);
}

TEST_CASE("a fiber that does not absorb scatters all light, at every roughness") {
    const double kTheta[] = {0, 0.4, -0.8, 1.2, 1.5, 1.57, kPiD / 2, -kPiD / 2}, kH[] = {0, -0.4, 0.8, 0.99, 1, -1};
    int pick = 0;
    double worst = 0;
    for (const float beta_m : kRoughness)
        for (const float beta_n : kRoughness)
            for (int i = 0; i < 3; ++i, ++pick) {
                const double theta = kTheta[pick % 8], h = kH[(pick / 3) % 6];
                CAPTURE(beta_m);
                CAPTURE(beta_n);
                CAPTURE(theta);
                CAPTURE(h);
                const Albedo albedo = furnace(fiber_of(beta_m, beta_n), theta, h);
                const double error = std::abs(albedo.forward.x + albedo.reflected.x - 1);
                worst = std::max(worst, error);
                CHECK(error < 1e-3);
            }
    MESSAGE("worst error of the white furnace: " << worst);
}

TEST_CASE("a fiber that does not absorb scatters all light, at every inclination and offset") {
    const Fiber fiber = fiber_of(0.3f, 0.3f);
    for (const double theta : {0.0, 0.4, -0.8, 1.2, 1.5, 1.57, 1.5707, kPiD / 2, -kPiD / 2})
        for (const double h : {0.0, -0.4, 0.8, 0.99, 0.99999, 1.0, -1.0}) {
            CAPTURE(theta);
            CAPTURE(h);
            const Albedo albedo = furnace(fiber, theta, h);
            CHECK(std::abs(albedo.forward.x + albedo.reflected.x - 1) < 1e-3);
        }
}

TEST_CASE("the pdf integrates to one and is f over its albedo where that is grey") {
    for (const float beta_m : {0.0f, 0.1f, 0.3f, 1.0f})
        for (const float beta_n : {0.0f, 0.3f, 1.0f})
            for (const double h : {0.0, -0.6, 1.0}) {
                const Fiber fiber = fiber_of(beta_m, beta_n);
                const double theta = 0.7, phi = -1.1;
                const Rgb sigma_a(0.4f);  // one grey: the pdf is f over its albedo exactly
                const SphereNodes nodes = sphere_nodes(fiber, theta, phi, h);
                const Albedo albedo = albedo_of(fiber, sigma_a, theta, phi, h);
                const double total = albedo.forward.x + albedo.reflected.x;
                double sum = 0, unlike = 0;
                for (size_t i = 0; i < nodes.direction.size(); ++i) {
                    const Vec3 wo = direction(theta, phi), wi = nodes.direction[i];
                    const double density = double(pdf(fiber, sigma_a, wo, wi, float(h)));
                    sum += nodes.weight[i] * density;
                    if (i % 16 != 0) continue;
                    const FiberScattering value = evaluate(fiber, sigma_a, wo, wi, float(h));
                    unlike = std::max(unlike, std::abs(double(value.forward.x + value.reflected.x) - density * total) /
                                                  (density * total + 1e-30));
                }
                CAPTURE(beta_m);
                CAPTURE(beta_n);
                CAPTURE(h);
                CHECK(std::abs(sum - 1) < 1e-3);
                CHECK(unlike < 1e-3);
            }
}

TEST_CASE("sampled directions give the integral that uniform ones give") {
    constexpr int kSamples = 40000;
    const auto radiance = [](const Vec3& w) { return 1 + 0.5 * double(w.x) - 0.7 * double(w.y) * double(w.z); };
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const float beta : {0.25f, 0.5f, 1.0f})
            for (const double h : {0.0, -0.7}) {
                const Fiber fiber = fiber_of(beta, beta, model);
                const Rgb sigma_a(0.1f, 0.4f, 1.5f);
                const Vec3 wo = direction(0.5, 2.0);
                double sum[2] = {}, squares[2] = {};
                int unlike = 0;
                for (int k = 0; k < kSamples; ++k) {
                    const uint64_t key = hash(11, uint64_t(k));
                    const glm::vec4 u(random(key, 0), random(key, 1), random(key, 2), random(key, 3));
                    const FiberSample s = sample(fiber, sigma_a, wo, float(h), u);
                    unlike += s.pdf != pdf(fiber, sigma_a, wo, s.wi, float(h));
                    const Vec3 w = uniform_direction(hash(key, 4));
                    const FiberScattering f = evaluate(fiber, sigma_a, wo, w, float(h));
                    const double x[2] = {
                        s.pdf > 0 ? double(mean(s.value.forward + s.value.reflected) / s.pdf) * radiance(s.wi) : 0,
                        double(mean(f.forward + f.reflected)) * 4 * kPiD * radiance(w)};
                    for (int i = 0; i < 2; ++i) {
                        sum[i] += x[i];
                        squares[i] += x[i] * x[i];
                    }
                }
                double average[2], variance = 0;
                for (int i = 0; i < 2; ++i) {
                    average[i] = sum[i] / kSamples;
                    variance += (squares[i] / kSamples - square(average[i])) / kSamples;
                }
                CAPTURE(int(model));
                CAPTURE(beta);
                CAPTURE(h);
                CHECK(unlike == 0);
                CHECK(std::abs(average[0] - average[1]) < 4 * std::sqrt(variance));
            }
}

TEST_CASE("many directions at once get the values that each gets alone") {
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner}) {
        const Fiber fiber = fiber_of(0.2f, 0.4f, model);
        const Vec3 wo = direction(-0.3, 2);
        const Rgb sigma_a(0.1f, 0.4f, 1.5f);
        std::vector<Vec3> wi;
        for (uint64_t k = 0; k < 100; ++k) wi.push_back(uniform_direction(hash(5, k)));
        std::vector<FiberScattering> value(wi.size());
        evaluate(fiber, sigma_a, wo, 0.4f, wi, value);
        for (size_t k = 0; k < wi.size(); ++k) {
            const FiberScattering alone = evaluate(fiber, sigma_a, wo, wi[k], 0.4f);
            const FiberSample sampled = evaluate_with_pdf(fiber, sigma_a, wo, wi[k], 0.4f);
            CHECK(value[k].forward == alone.forward);
            CHECK(value[k].reflected == alone.reflected);
            CHECK(sampled.value.forward == alone.forward);
            CHECK(sampled.value.reflected == alone.reflected);
        }
    }
}

TEST_CASE("f keeps its value when light is reversed, exactly where the model says so") {
    // M is symmetric without tilt. At an index of 1 nothing else depends on h or theta_o: f |cos theta| is symmetric.
    const Reciprocity near_field = near_field_reciprocity(4000);
    CHECK(near_field.glassless.largest < 2e-4);  // exponents of M reach 2 / v = 95
    CHECK(near_field.opposite.largest < 5e-4);
    CHECK(near_field.any.of_sums < 0.08);  // as stated in core/fiber.h
    MESSAGE("mean asymmetry of f |cos theta|, averaged over h: " << near_field.any.of_sums);
    CHECK(far_field_reciprocity(4000).largest < 5e-4);
}

TEST_CASE("nothing is infinite, negative or not a number, to the exact ends of every range") {
    const Soundness all = try_all_extremes();
    CHECK(all.tried > 1000000);
    CHECK(all.unsound == 0);
}

TEST_CASE("an infinite absorption leaves only R, an index of 1 only TT") {
    FiberParameters q;
    const Fiber fiber = make_fiber(q);
    q.eta = 1;
    const Fiber glassless = make_fiber(q);
    for (const double theta : {0.0, 1.1, kPiD / 2})
        for (const double h : {0.0, 0.6, 1.0}) {
            CAPTURE(theta);
            CAPTURE(h);
            const Albedo black = albedo_of(fiber, Rgb(kInfinity), theta, 0, h);
            CHECK(black.forward.x == 0);
            CHECK(std::abs(black.reflected.x - first_reflectance(1.55, theta, h)) < 1e-3);
            const Albedo clear = albedo_of(glassless, Rgb(0), theta, 0, h);
            CHECK(std::abs(clear.forward.x - 1) < 1e-3);
            CHECK(clear.reflected.x == 0);
        }
    const FiberSample none = sample(glassless, Rgb(kInfinity), direction(0.2, 0), 0.3f, glm::vec4(0.5f));
    CHECK(none.pdf == 0);
}

TEST_CASE("directions drawn together are those drawn one by one") {
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const FiberLobes lobes : {FiberLobes::all, FiberLobes::reflected}) {
            FiberParameters parameters;
            parameters.model = model;
            const Fiber fiber = make_fiber(parameters);
            const Rgb sigma_a(0.1f, 0.3f, 0.6f);
            const Vec3 wo = normalize(Vec3(0.2f, 0.5f, 0.7f));
            std::vector<glm::vec4> u;
            for (uint64_t i = 0; i < 50; ++i)
                u.emplace_back(tress::random(i, 0), tress::random(i, 1), tress::random(i, 2), tress::random(i, 3));
            std::vector<FiberSample> together(u.size());
            sample(fiber, sigma_a, wo, 0.3f, u, together, lobes);
            for (size_t i = 0; i < u.size(); ++i) {
                const FiberSample one = sample(fiber, sigma_a, wo, 0.3f, u[i], lobes);
                CHECK(one.wi == together[i].wi);
                CHECK(one.pdf == together[i].pdf);
                CHECK(one.value.forward == together[i].value.forward);
                CHECK(one.value.reflected == together[i].value.reflected);
            }
        }
}
