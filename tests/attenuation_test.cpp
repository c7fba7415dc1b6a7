// SPDX-License-Identifier: MIT
#include "core/attenuation.h"

#include <doctest/doctest.h>

#include "core/forward_albedo.h"
#include "tools/check/support/fiber_quadrature.h"

using namespace tress;

namespace {

/// Of both senses of the tangent, as the tables hold it.
double albedo_at(const Fiber& fiber, double sine, double sigma_a) {
    return 0.5 * (albedo(forward_paths(fiber, sine), sigma_a) + albedo(forward_paths(fiber, -sine), sigma_a));
}

std::vector<double> sines(int count) {
    std::vector<double> values;
    for (int k = 0; k <= count; ++k) values.push_back(std::sin(kPiD / 2 * k / count));
    return values;
}

constexpr double kTableError = 2e-3;  // what renderers are promised

}  // namespace

TEST_CASE("the forward albedo is the TT lobe of f integrated over the sphere and the fiber's width") {
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const double theta : {0.0, 0.6, -1.3}) {
            const Fiber fiber = fiber_of(0.3f, 0.3f, model);
            const Rgb sigma_a(0, 0.5f, 3);
            glm::dvec3 sum(0);
            if (model == FiberModel::marschner) {
                sum = albedo_of(fiber, sigma_a, theta, 0, 0).forward;
            } else {
                for (const QuadratureNode& gamma : gauss_legendre(12, -kPiD / 2, kPiD / 2))
                    sum += gamma.weight * std::cos(gamma.x) / 2 *
                           albedo_of(fiber, sigma_a, theta, 0, std::sin(gamma.x)).forward;
            }
            const Rgb expected = forward_albedo(fiber, sigma_a, float(std::sin(theta)));
            CAPTURE(int(model));
            CAPTURE(theta);
            // 1e-3: the outer quadrature over a sphere; the sharpest edge is that of the far field's TT in azimuth.
            for (int channel = 0; channel < 3; ++channel)
                CHECK(std::abs(sum[channel] - double(expected[channel])) < 1e-3);
        }
}

TEST_CASE("the table of one absorption keeps its error at every inclination") {
    double worst = 0;
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const float eta : {1.0f, 1.2f, 1.55f, 3.0f})
            for (const float beta_m : {0.0f, 0.3f, 1.0f}) {
                FiberParameters q;
                q.model = model;
                q.eta = eta;
                q.beta_m = beta_m;
                q.sigma_a = Rgb(0, 0.2f, 5);
                const Fiber fiber = make_fiber(q);
                const AttenuationTable table = make_attenuation_table(fiber);
                REQUIRE(table.depth.size() == size_t(AttenuationTable::kRows));
                for (const double sine : sines(97)) {
                    const Rgb depth = table.at(float(sine));
                    for (int channel = 0; channel < 3; ++channel) {
                        const double exact = std::min(albedo_at(fiber, sine, double(q.sigma_a[channel])), 1.0);
                        const double error = std::abs(std::exp(-double(depth[channel])) - exact);
                        CAPTURE(int(model));
                        CAPTURE(eta);
                        CAPTURE(beta_m);
                        CAPTURE(sine);
                        CAPTURE(channel);
                        CHECK(error < kTableError);
                        worst = std::max(worst, error);
                    }
                }
            }
    MESSAGE("worst error of a_k: " << worst);
}

TEST_CASE("the table over absorption keeps its error at every inclination and absorption") {
    double worst = 0;
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner}) {
        const Fiber fiber = fiber_of(0.3f, 0.3f, model);
        const AbsorptionTable table = make_absorption_table(fiber);
        REQUIRE(table.depth.size() == size_t(AbsorptionTable::kRows) * size_t(AbsorptionTable::kColumns));
        for (const double sine : sines(67))
            for (const float sigma_a : {0.0f, 1e-4f, 0.01f, 0.1f, 0.33f, 1.0f, 2.7f, 10.0f, 1e3f, 1e30f, kInfinity}) {
                const double exact = albedo_at(fiber, sine, double(sigma_a));
                const double error = std::abs(std::exp(-double(table.at(float(sine), sigma_a))) - exact);
                CAPTURE(int(model));
                CAPTURE(sine);
                CAPTURE(sigma_a);
                CHECK(error < kTableError);
                worst = std::max(worst, error);
            }
    }
    MESSAGE("worst error of a_k: " << worst);
}

TEST_CASE("depths are finite, opaque at grazing, and not read outside the table") {
    FiberParameters q;
    q.sigma_a = Rgb(0, 1, kInfinity);
    const AttenuationTable table = make_attenuation_table(make_fiber(q));
    for (const Rgb& depth : table.depth)
        for (int channel = 0; channel < 3; ++channel) {
            CHECK(depth[channel] >= 0);
            CHECK(depth[channel] <= kOpaqueDepth);
        }
    CHECK(table.at(0).z == kOpaqueDepth);
    CHECK(table.at(1).x == kOpaqueDepth);
    CHECK(table.at(1.0000001f).x == kOpaqueDepth);
    const AbsorptionTable varying = make_absorption_table(make_fiber(q));
    CHECK(varying.at(0, kInfinity) == kOpaqueDepth);
    CHECK(varying.at(0, 0) == doctest::Approx(double(table.at(0).x)).epsilon(1e-5));
}

TEST_CASE("light that meets no glass and no pigment passes whole") {
    FiberParameters q;
    q.eta = 1;
    const AttenuationTable table = make_attenuation_table(make_fiber(q));
    for (const double sine : sines(20)) CHECK(std::abs(table.at(float(sine)).x) < 1e-6f);
}

TEST_CASE("a segment finds its fiber and its own absorption") {
    FiberParameters dark, light;
    dark.sigma_a = Rgb(2);
    light.sigma_a = Rgb(0.1f);
    Attenuation attenuation;
    attenuation.table = {make_attenuation_table(make_fiber(dark)), make_attenuation_table(make_fiber(light))};
    CHECK(attenuation.depth(1, 0.2f) == attenuation.table[0].at(0.2f));
    attenuation.fiber_of_segment = {0, 1};
    CHECK(attenuation.depth(1, 0.2f) == attenuation.table[1].at(0.2f));

    attenuation.varying = {make_absorption_table(make_fiber(dark)), make_absorption_table(make_fiber(light))};
    attenuation.sigma_a = {Rgb(1), Rgb(0.1f, 2, 0)};
    const Rgb depth = attenuation.depth(1, 0.2f);
    CHECK(std::abs(std::exp(-depth.x) - std::exp(-attenuation.table[1].at(0.2f).x)) < 2 * float(kTableError));
    CHECK(std::abs(std::exp(-depth.y) - std::exp(-attenuation.table[0].at(0.2f).x)) < 2 * float(kTableError));
}
