// SPDX-License-Identifier: MIT
// The parts fibers are made of: longitudinal and azimuthal lobes, Fresnel, and where light leaves a cylinder.
#include <doctest/doctest.h>

#include "core/depressed_cubic.h"
#include "core/fresnel.h"
#include "tools/check/support/fiber_quadrature.h"

using namespace tress;

TEST_CASE("the longitudinal lobe keeps all energy at every variance and inclination") {
    for (const double v : {1e-6, 1e-5, 1e-4, 1e-3, 0.0112, 0.03, 0.1, 0.3, 1.0})
        for (const double theta_o : {0.0, 0.3, -0.9, 1.4, 1.57, kPiD / 2, -kPiD / 2}) {
            CAPTURE(v);
            CAPTURE(theta_o);
            CHECK(std::abs(longitudinal_integral(make_longitudinal(v), theta_o) - 1) < 1e-5);
        }
}

TEST_CASE("the longitudinal lobe is the direct formula where that does not overflow") {
    // Relative 2e-6: the Bessel function's 5e-7, the normalisation, and rounding of chord^2 / v below 4 / v ulps.
    for (const double v : {0.05, 0.2, 1.0, 30.0})
        for (double i = -1.5; i < 1.55; i += 0.1)
            for (double o = -1.5; o < 1.55; o += 0.1) {
                const double direct = std::exp(-std::sin(i) * std::sin(o) / v) *
                                      std::cyl_bessel_i(0.0, std::cos(i) * std::cos(o) / v) /
                                      (2 * v * std::sinh(1 / v));
                const double value = double(longitudinal(make_longitudinal(v), sin_cos(i), sin_cos(o)));
                CAPTURE(v);
                CAPTURE(i);
                CAPTURE(o);
                CHECK(std::abs(value - direct) <= (2e-6 + 4 / v * 6e-8) * direct);
            }
}

TEST_CASE("inclinations are drawn with the density of the longitudinal lobe") {
    constexpr int kSide = 400, kBins = 8;
    for (const double v : {1e-6, 0.01, 1.0, 100.0})
        for (const double theta_o : {0.0, 0.7, -1.5, kPiD / 2}) {
            const LongitudinalLobe lobe = make_longitudinal(v);
            const double reach = std::min(4 * std::sqrt(v), 3.2);
            int count[kBins] = {};
            for (int a = 0; a < kSide; ++a)
                for (int b = 0; b < kSide; ++b) {
                    const SinCos i = sample_longitudinal(lobe, sin_cos(theta_o), (float(a) + 0.5f) / kSide,
                                                         (float(b) + 0.5f) / kSide);
                    const double theta = std::atan2(double(i.sin), double(i.cos));
                    const double bin = (theta + theta_o + reach) / (2 * reach) * kBins;
                    if (bin >= 0 && bin < kBins) ++count[int(bin)];
                }
            for (int k = 0; k < kBins; ++k) {
                const double lo = std::max(-theta_o - reach + 2 * reach * k / kBins, -kPiD / 2);
                const double hi = std::min(-theta_o - reach + 2 * reach * (k + 1) / kBins, kPiD / 2);
                double expected = 0;
                if (lo < hi)
                    for (const QuadratureNode& n : gauss_legendre(24, lo, hi))
                        expected +=
                            n.weight * std::cos(n.x) * double(longitudinal(lobe, sin_cos(n.x), sin_cos(theta_o)));
                CAPTURE(v);
                CAPTURE(theta_o);
                CAPTURE(k);
                // A grid of 400 x 400 places the edge of a bin to within about a row and a column of cells.
                CHECK(std::abs(count[k] / double(kSide * kSide) - expected) < 2.0 / kSide);
            }
        }
}

TEST_CASE("the azimuthal lobe keeps all energy at every scale") {
    // 1e-5: rounding of exp (1e-7) and a panel quadrature of a lobe whose panels start at half its scale.
    for (const double scale : {0.0, 1e-4, 1e-3, 0.03, 0.2, 1.0, 5.0, 100.0}) {
        const AzimuthalLobe lobe = make_azimuthal(scale);
        double sum = 0;
        for (const QuadratureNode& n : graded_nodes(-kPiD, kPiD, {0}, std::min(0.5 * double(lobe.scale), 0.5)))
            sum += n.weight * double(azimuthal(lobe, float(n.x)));
        CAPTURE(scale);
        CHECK(std::abs(sum - 1) < 1e-5);
    }
}

TEST_CASE("azimuths are drawn with the density of the azimuthal lobe") {
    // The density integrated from the middle to a drawn azimuth is u - 1/2; 1e-5: as above, the ends of u included.
    for (const double scale : {0.0, 1e-3, 0.2, 1.0, 5.0})
        for (const float u : {0.0f, 0x1p-24f, 0.01f, 0.3f, 0.5f, 0.77f, 0.999f, 1 - 0x1p-24f}) {
            const AzimuthalLobe lobe = make_azimuthal(scale);
            const double angle = double(sample_azimuthal(lobe, u));
            double sum = 0;
            const double near = std::min(0.5 * double(lobe.scale), 0.5);
            for (const QuadratureNode& n : graded_nodes(0, std::abs(angle), {0}, near))
                sum += n.weight * double(azimuthal(lobe, float(n.x)));
            CAPTURE(scale);
            CAPTURE(u);
            CHECK(std::abs(angle) <= double(kPi));
            CHECK(std::abs(std::copysign(sum, angle) - (double(u) - 0.5)) < 1e-5);
        }
}

TEST_CASE("Fresnel reflectance has its known ends") {
    CHECK(fresnel(1, 0) == 0);
    CHECK(fresnel(1, 0.3) == 0);
    CHECK(fresnel(1.55, 0) == doctest::Approx(1));
    CHECK(fresnel(1.55, 1) == doctest::Approx(square(0.55 / 2.55)));
    const double brewster = std::cos(std::atan(1.55));  // the in-plane part vanishes
    const double cos_t = std::sin(std::atan(1.55));
    CHECK(fresnel(1.55, brewster) ==
          doctest::Approx(0.5 * square((brewster - 1.55 * cos_t) / (brewster + 1.55 * cos_t))));
}

TEST_CASE("roots of the cubic satisfy it, and none is missed") {
    for (const double a : {-2.0, -1e-9, 0.0, 1e-9, 0.7, 4.0})
        for (const double b : {1e-12, 1e-4, 0.3, 1.0})
            for (double y = -3; y <= 3; y += 0.25) {
                const CubicRoots roots = solve_depressed_cubic(a, b, y);
                CAPTURE(a);
                CAPTURE(b);
                CAPTURE(y);
                const double height = a > 0 ? 2.0 / 3 * a * std::sqrt(a / (3 * b)) : 0;
                CHECK(roots.count == (std::abs(y) <= height && a > 0 ? 3 : 1));
                for (int i = 0; i < roots.count; ++i) {
                    const double x = roots.root[i];
                    const double scale = std::abs(a * x) + std::abs(b * x * x * x) + std::abs(y);
                    CHECK(std::abs(a * x - b * x * x * x - y) <= 1e-12 * scale);
                }
            }
}
