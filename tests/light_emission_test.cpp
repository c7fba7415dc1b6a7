// SPDX-License-Identifier: MIT
#include "core/light_emission.h"

#include <doctest/doctest.h>

#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/light_sample.h"
#include "core/sampler.h"
#include "core/sampling.h"

using namespace tress;

namespace {

constexpr int kCount = 1 << 14;
constexpr double kPi64 = std::numbers::pi;
const Sphere kSphere{{1, 2, 3}, 2};

struct Total {
    DVec3 power{0};
    int sent = 0;
};

/// Mean power, and how many are not 0. Each of those starts in the sphere, is unit, and goes through it.
template <class L>
Total total(const L& light, const Sphere& sphere = kSphere) {
    Total t;
    for (uint32_t i = 0; i < kCount; ++i) {
        const Emission e = emit(light, sphere, Sampler{7, i}.get4(0));
        if (e.power == Rgb(0)) continue;
        ++t.sent;
        t.power += DVec3(e.power) / double(kCount);
        CAPTURE(i);
        REQUIRE(is_finite(e.position));
        REQUIRE(is_finite(e.power));
        REQUIRE(length(e.direction) == doctest::Approx(1).epsilon(1e-5));
        REQUIRE(length(DVec3(e.position) - sphere.center) <= sphere.radius * (1 + 1e-5));
        const DVec3 after = DVec3(e.position) + 1e-3 * sphere.radius * DVec3(e.direction);
        const bool inward = length(after - sphere.center) < length(DVec3(e.position) - sphere.center);
        REQUIRE((inward || length(DVec3(e.position) - sphere.center) < 0.999 * sphere.radius ||
                 length(cross(DVec3(e.position) - sphere.center, DVec3(e.direction))) > 0.999 * sphere.radius));
    }
    return t;
}

void check_power(const Total& t, const DVec3& expected) {
    // All powers are equal: of k in n that are sent the deviation is below sqrt(k (1 - k / n)) of k.
    const double k = t.sent, tolerance = 4 * std::sqrt(k * (1 - k / kCount)) / k + 1e-5;
    for (int c = 0; c < 3; ++c) CHECK(t.power[c] == doctest::Approx(expected[c]).epsilon(tolerance));
}

const Rgb kColor{1, 2, 4};

}  // namespace

TEST_CASE("a point light sends the cone about the sphere from outside, and all its light from inside") {
    const double distance = 5, below = 1 - std::sqrt(1 - square(2.0 / distance));
    const Total outside = total(PointLight{kSphere.center + DVec3(0, 3, -4), kColor});
    CHECK(outside.sent >= kCount - 2);  // rounding at the rim
    check_power(outside, DVec3(kColor) * (2 * kPi64 * below));
    const Total inside = total(PointLight{kSphere.center + DVec3(0.5, 1, 0), kColor});
    CHECK(inside.sent == kCount);
    check_power(inside, DVec3(kColor) * (4 * kPi64));
}

TEST_CASE("a spot sends its cone with the soft rim, from inside and from outside") {
    const double half = glm::radians(35.0);
    double integral = 0;  // midpoint rule
    SpotLight spot{kSphere.center, kSphere.center + DVec3(1, 1, 1), 70, kColor};
    const DVec3 axis = normalize(DVec3(1, 1, 1)), side = normalize(cross(axis, DVec3(1, 0, 0)));
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const double theta = half * (i + 0.5) / steps;
        integral += 2 * kPi64 * std::sin(theta) * half / steps *
                    spot_falloff(spot, std::cos(theta) * axis + std::sin(theta) * side);
    }
    check_power(total(spot), DVec3(kColor) * integral);
    spot = {kSphere.center - 50.0 * axis, kSphere.center, 70, kColor};  // the sphere lies in its flat middle
    check_power(total(spot), DVec3(kColor) * (2 * kPi64 * (1 - std::sqrt(1 - square(2.0 / 50)))));
    spot = {kSphere.center - 50.0 * axis, kSphere.center, 1, kColor};  // it lies in the sphere, soft rim and all
    const double narrow = glm::radians(0.5);
    // Over the outer tenth a smooth step, 1/2 on average about 0.95: in area, near the axis.
    double share = 0;
    for (int i = 0; i < steps; ++i) {
        const double x = (i + 0.5) / steps;
        share += 2 * x / steps * (1 - glm::smoothstep(0.9, 1.0, x));
    }
    check_power(total(spot), DVec3(kColor) * (kPi64 * square(narrow) * share));
}

TEST_CASE("a distant light covers the sphere") {
    const Total t = total(DistantLight{{3, -4, 12}, kColor});
    CHECK(t.sent == kCount);
    check_power(t, DVec3(kColor) * (kPi64 * 4));
}

TEST_CASE("a quad sends all its light from inside, and from outside what the sphere spans") {
    const QuadLight inside{kSphere.center, {{0.5, 0, 0}, {0, 0, -0.4}}, kColor};
    check_power(total(inside), DVec3(kColor) * (kPi64 * 0.2));
    // A speck that faces the sphere at distance d sees it under the form factor (R / d)^2.
    const QuadLight outside{kSphere.center + DVec3(0, 0, 4), {{0, 1e-3, 0}, {1e-3, 0, 0}}, kColor};
    check_power(total(outside), DVec3(kColor) * (kPi64 * 1e-6 * 0.25));
    CHECK(total(QuadLight{kSphere.center + DVec3(0, 0, 4), {{1e-3, 0, 0}, {0, 1e-3, 0}}, kColor}).sent == 0);
}

TEST_CASE("a quad far away aims at the sphere: all its light arrives, as much as the sphere spans") {
    for (const double distance : {20.0, 1e4, 1e9}) {
        CAPTURE(distance);
        const double side = 1e-3 * distance;
        const QuadLight quad{kSphere.center + DVec3(0, 0, distance), {{0, side, 0}, {side, 0, 0}}, kColor};
        const Total t = total(quad);
        CHECK(t.sent >= kCount - 2);  // rounding at the rim
        check_power(t, DVec3(kColor) * (kPi64 * square(side) * square(2 / distance)));
        CHECK(double(luminance(emission_power(quad, kSphere))) ==
              doctest::Approx(double(luminance(Rgb(t.power)))).epsilon(0.02));  // cosines in the cone: from 0.995 to 1
    }
}

TEST_CASE("an environment sends what comes from everywhere across the sphere") {
    const Total even = total(make_environment_sampler(Image{}, kColor, 0));
    CHECK(even.sent == kCount);
    check_power(even, DVec3(kColor) * (4 * kPi64 * kPi64 * 4));

    Image image;
    image.width = 8, image.height = 4;
    for (int i = 0; i < 32; ++i) image.pixel.push_back(Rgb(float(i % 5), float(i % 3), i == 9 ? 50.0f : 0.5f));
    const EnvironmentSampler sky = make_environment_sampler(image, Rgb(1), 30);
    DVec3 integral(0);
    constexpr int n = 1 << 18;
    for (uint32_t i = 0; i < n; ++i)
        integral += DVec3(radiance(sky, sample_uniform_sphere(Sampler{3, i}.get2(0)))) * (4 * kPi64 / n);
    const Total t = total(sky);
    const double mean_power = double(luminance(emission_power(sky, kSphere)));
    // Powers differ within texels, here by less than their mean: 1 / sqrt(n), and low discrepancy does better.
    for (int c = 0; c < 3; ++c)
        CHECK(t.power[c] == doctest::Approx(integral[c] * kPi64 * 4).epsilon(4 / std::sqrt(double(kCount))));
    CHECK(double(luminance(Rgb(t.power))) == doctest::Approx(mean_power).epsilon(4 / std::sqrt(double(kCount))));
}

TEST_CASE("of one light all emissions have the same power, and emission_power tells its luminance") {
    const SpotLight light{{9, 9, 9}, kSphere.center, 40, kColor};
    for (uint32_t i = 0; i < 1000; ++i) {
        const Emission e = emit(light, kSphere, Sampler{1, i}.get4(0));
        if (e.power != Rgb(0)) CHECK(e.power == emission_power(light, kSphere));
    }
}

TEST_CASE("lights very far, in the middle, very strong, black or without shape send finite light") {
    for (const double distance : {0.0, 1e-20, 1.5, 2.5, 1e6, 1e20, 1e200}) {
        CAPTURE(distance);
        const DVec3 at = kSphere.center + DVec3(distance, 0, 0);
        const Rgb strong(1e30f);
        const Total point = total(PointLight{at, strong});
        CHECK(point.power.x <= double(kLargestPower) * (1 + 1e-6));
        total(SpotLight{at, kSphere.center, 40, strong});
        total(QuadLight{at, {{0, 0, 1}, {0, 1, 0}}, strong});
        if (distance == 1e6) CHECK(point.sent >= kCount * 0.999);
    }
    total(DistantLight{{1e-200, 0, 0}, Rgb(1e30f)});
    total(make_environment_sampler(Image{}, Rgb(1e30f), 0));
    CHECK(total(PointLight{{0, 0, 0}, Rgb(0)}).sent == 0);
    CHECK(total(DistantLight{{0, 0, 0}, Rgb(1)}).sent == 0);
    CHECK(total(SpotLight{{1, 1, 1}, {1, 1, 1}, 40, Rgb(1)}).sent == 0);
    CHECK(total(QuadLight{{1, 1, 1}, {{1, 0, 0}, {2, 0, 0}}, Rgb(1)}).sent == 0);
    CHECK(total(make_environment_sampler(Image{}, Rgb(0), 0)).sent == 0);
}
