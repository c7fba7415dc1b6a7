// SPDX-License-Identifier: MIT
// A fiber asked for f_R alone: what is left when light that goes straight through is another's.
#include <doctest/doctest.h>

#include "tools/check/support/fiber_quadrature.h"

using namespace tress;

namespace {

constexpr FiberModel kModels[] = {FiberModel::chiang, FiberModel::marschner};

glm::vec4 four(uint64_t key) { return {random(key, 0), random(key, 1), random(key, 2), random(key, 3)}; }

}  // namespace

TEST_CASE("what f_R evaluates to is f_R of the whole, with no forward part, drawn or asked for") {
    for (const FiberModel model : kModels)
        for (const float beta : {0.1f, 0.3f, 1.0f}) {
            const Fiber fiber = fiber_of(beta, beta, model);
            const Rgb sigma_a(0.1f, 0.4f, 1.5f);
            const Vec3 wo = direction(0.4, -1.2);
            for (uint64_t k = 0; k < 300; ++k) {
                CAPTURE(int(model));
                CAPTURE(beta);
                CAPTURE(k);
                const float h = 2 * random(21, k) - 1;
                const FiberSample drawn = sample(fiber, sigma_a, wo, h, four(hash(22, k)), FiberLobes::reflected);
                const FiberSample asked = evaluate_with_pdf(fiber, sigma_a, wo, drawn.wi, h, FiberLobes::reflected);
                CHECK(drawn.value.forward == Rgb(0));
                CHECK(asked.value.forward == Rgb(0));
                CHECK(asked.value.reflected == evaluate(fiber, sigma_a, wo, drawn.wi, h).reflected);
                CHECK(drawn.value.reflected == asked.value.reflected);
                CHECK(drawn.pdf == asked.pdf);
                CHECK(drawn.pdf > 0);
            }
        }
}

TEST_CASE("the density of directions drawn by f_R integrates to one") {
    // Of the near field: nodes resolve lobes of any width. Of the far field: lobes at beta = 0.3 are over 0.1 wide,
    // and 600 x 1200 midpoints are 0.005 apart.
    for (const float beta_m : {0.0f, 0.1f, 1.0f})
        for (const double h : {0.0, -0.6, 1.0}) {
            const Fiber fiber = fiber_of(beta_m, 0.3f);
            const double sum = pdf_integral(fiber, Rgb(0.1f, 0.4f, 1.5f), 0.7, -1.1, h, FiberLobes::reflected);
            CAPTURE(beta_m);
            CAPTURE(h);
            CHECK(std::abs(sum - 1) < 1e-3);
        }
    constexpr int kRows = 300, kColumns = 600;
    const Fiber far = fiber_of(0.3f, 0.3f, FiberModel::marschner);
    double sum = 0;
    for (int i = 0; i < kRows; ++i)
        for (int k = 0; k < kColumns; ++k) {
            const double theta = kPiD * ((i + 0.5) / kRows - 0.5), phi = 2 * kPiD * ((k + 0.5) / kColumns - 0.5);
            sum += std::cos(theta) * double(evaluate_with_pdf(far, Rgb(0.1f, 0.4f, 1.5f), direction(0.7, -1.1),
                                                              direction(theta, phi), 0, FiberLobes::reflected)
                                                .pdf);
        }
    CHECK(std::abs(sum * 2 * kPiD * kPiD / (kRows * kColumns) - 1) < 1e-3);
}

TEST_CASE("directions drawn by f_R weigh its share of the white furnace") {
    constexpr int kSamples = 20000;
    for (const float beta : {0.1f, 0.3f, 1.0f})
        for (const double h : {0.0, -0.8}) {
            const Fiber fiber = fiber_of(beta, beta);
            const double theta = 0.5, phi = 2;
            const Albedo albedo = albedo_of(fiber, Rgb(0), theta, phi, h);
            double sum = 0, squares = 0;
            for (uint64_t k = 0; k < kSamples; ++k) {
                const FiberSample s =
                    sample(fiber, Rgb(0), direction(theta, phi), float(h), four(hash(23, k)), FiberLobes::reflected);
                const double x = double(s.value.reflected.x / s.pdf);
                sum += x;
                squares += x * x;
            }
            const double average = sum / kSamples;
            const double error = std::sqrt(std::max(squares / kSamples - square(average), 0.0) / kSamples);
            CAPTURE(beta);
            CAPTURE(h);
            // The density is f_R over its albedo where that is grey: no spread but rounding; the quadrature's is 1e-3.
            CHECK(std::abs(average - albedo.reflected.x) < 4 * error + 1e-3);
            CHECK(albedo.reflected.x + albedo.forward.x == doctest::Approx(1).epsilon(1e-3));
            CHECK(error < 1e-4);
        }
}
