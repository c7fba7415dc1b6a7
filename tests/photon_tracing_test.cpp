// SPDX-License-Identifier: MIT
// What photons bring to polygons.
#include "gather/photons/photon_tracing.h"

#include <doctest/doctest.h>

#include "core/error.h"
#include "core/light_reach.h"
#include "core/light_sample.h"
#include "core/sampler.h"
#include "tests/photon_support.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr int kCount = 1 << 13;

/// Light that arrives at the square of half-width `half` from the side of +z, W, by quadrature.
struct FluxOnSquare {
    double half;

    template <class L>
    DVec3 operator()(const L& light) const {
        constexpr int n = 64, m = std::is_same_v<L, QuadLight> ? 16 : 1;
        DVec3 sum(0);
        for (int i = 0; i < n * n; ++i) {
            const Vec3 p(float(half * ((i % n + 0.5) * 2 / n - 1)), float(half * ((i / n + 0.5) * 2 / n - 1)), 0);
            for (int j = 0; j < m * m; ++j) {
                const LightSample s = sample(light, p, {(float(j % m) + 0.5f) / m, (float(j / m) + 0.5f) / m});
                sum += DVec3(s.irradiance) * double(std::max(s.direction.z, 0.0f));
            }
        }
        return sum * (4 * half * half / (n * n * m * m));
    }
    DVec3 operator()(const EnvironmentLight& light) const {
        return DVec3(light.radiance) * (double(kPi) * 4 * half * half);
    }
};

const Rgb kColor{1, 2, 4};

std::vector<Light> one_of_each() {
    EnvironmentLight sky;
    sky.radiance = kColor;
    return {PointLight{{0.3, 0.4, 1.5}, kColor},
            PointLight{{8, 0, 9}, kColor},
            SpotLight{{1, 0, 2}, {0.2, 0, 0}, 30, kColor},
            DistantLight{{1, 0.5, -2}, kColor},
            QuadLight{{0.2, 0.1, 2}, {{0, 1, 0}, {1.5, 0, 0}}, kColor},
            sky};
}

}  // namespace

TEST_CASE("the photons on a lone square carry the irradiance of each kind of light") {
    for (const Light& light : one_of_each()) {
        CAPTURE(light_name(light));
        const PhotonScene s = photon_scene({}, {square(1, Rgb(0))}, {light}, photon_options(kCount));
        const std::vector<Estimate> power = over_seeds(s, 3, [](const TracedPhotons& photons, size_t channel) {
            const PhotonList& list = photons.on_polygons;
            return power_of(list, int(channel), [&](size_t i) { return list.normal[i].z > 0; });
        });
        // The quadrature errs by less than a thousandth: its cells span 1/32, the nearest light is 1.5 away; where a
        // spot's rim cuts across cells, by more.
        const DVec3 expected = std::visit(FluxOnSquare{1}, light);
        const double slack = std::holds_alternative<SpotLight>(light) ? 3e-3 : 1e-3;
        for (int c = 0; c < 3; ++c) {
            CAPTURE(power[size_t(c)].mean);
            CAPTURE(power[size_t(c)].error);
            CAPTURE(expected[c]);
            CHECK(std::abs(power[size_t(c)].mean - expected[c]) <= 4.5 * power[size_t(c)].error + slack * expected[c]);
            CHECK(power[size_t(c)].error < 0.02 * expected[c]);
        }
    }
}

TEST_CASE("lights share the photons by power, so that all are equal, and each brings its own light") {
    const std::vector<Light> lights{DistantLight{{0, 0, -1}, Rgb(1)}, PointLight{{0, 0, 3}, Rgb(0)},
                                    DistantLight{{0, 0, -1}, Rgb(3)}, DistantLight{{0, 0, 1}, Rgb(4)}};
    const PhotonScene s = photon_scene({}, {square(1, Rgb(0))}, lights, photon_options(kCount));
    const TracedPhotons photons = s.trace();
    REQUIRE(photons.statistics.lights.size() == 3);  // the plan leaves the black one out
    CHECK(photons.statistics.lights[0].emitted == doctest::Approx(kCount / 8.0).epsilon(0.001));
    CHECK(photons.statistics.lights[1].emitted == doctest::Approx(kCount * 3 / 8.0).epsilon(0.001));
    CHECK(photons.statistics.lights[2].light == 3);
    uint64_t emitted = 0, stored = 0;
    for (const LightPhotons& light : photons.statistics.lights) emitted += light.emitted, stored += light.on_polygons;
    CHECK(emitted == kCount);
    CHECK(stored == photons.on_polygons.size());
    for (const Rgb& power : photons.on_polygons.power)
        CHECK(power.x == doctest::Approx(double(photons.on_polygons.power[0].x)).epsilon(1e-5));
    for (size_t i = 0; i < stored; ++i) CHECK(dot(photons.on_polygons.normal[i], photons.on_polygons.direction[i]) < 0);
}

TEST_CASE("photons lie in the plane of a polygon, however large it is") {
    // Rays start a hundredth above this square, by its corners' rounding; discs of photons may be smaller than that.
    const SpotLight spot{{3, 4, 2}, {3, 4, 0}, 30, Rgb(1)};
    const PhotonScene s = photon_scene({}, {square(1e4f, Rgb(0.5f))}, {spot}, photon_options(1000));
    const TracedPhotons photons = s.trace();
    REQUIRE(photons.on_polygons.size() > 900);
    for (const float z : photons.on_polygons.z) REQUIRE(z == 0);
}

TEST_CASE("light in a closed box goes round as the geometric series of its albedo, channel by channel") {
    const Rgb albedo(0.8f, 0.5f, 0.2f);
    const PhotonScene s =
        photon_scene({}, {closed_box(1, albedo)}, {PointLight{{0.3, 0.2, -0.4}, kColor}}, photon_options(kCount / 2));
    const std::vector<Estimate> all = over_seeds(s, 3, [](const TracedPhotons& photons, size_t c) {
        return power_of(photons.on_polygons, int(c), [](size_t) { return true; });
    });
    for (int c = 0; c < 3; ++c) {
        const double emitted = 4 * double(kPi) * double(kColor[c]);
        CHECK(agrees(all[size_t(c)], emitted / (1 - double(albedo[c]))));
    }
    const TracedPhotons photons = s.trace();
    const PhotonList& list = photons.on_polygons;
    CHECK(power_of(list, 0, of_type(list, PathType::type1)) ==
          doctest::Approx(4 * double(kPi) * double(kColor.x)).epsilon(1e-5));
    for (const uint8_t type : list.type) CHECK(type <= index_of(PathType::type2));
}

TEST_CASE("a closed white box about a light ends, and stays finite") {
    const PhotonScene s =
        photon_scene({}, {closed_box(1, Rgb(1))}, {PointLight{{0, 0, 0}, Rgb(1e30f)}}, photon_options(1000));
    const TracedPhotons photons = s.trace();
    CHECK(photons.on_polygons.size() == doctest::Approx(1000 * 100).epsilon(4 / std::sqrt(1000.0)));
    for (const Rgb& power : photons.on_polygons.power) REQUIRE(is_finite(power));
}

TEST_CASE("a quad in the plane of a ceiling lights the room, not the ceiling's back") {
    const QuadLight lamp{{-0.5, 1, -0.5}, {{1, 0, 0}, {0, 0, 1}}, Rgb(1)};  // faces -y
    const PhotonScene s = photon_scene({}, {closed_box(1, Rgb(0))}, {lamp}, photon_options(kCount));
    const TracedPhotons photons = s.trace();
    CHECK(photons.on_polygons.size() == kCount);
    for (const float y : photons.on_polygons.y) CHECK(y < 0.999f);
}

TEST_CASE("lists that would outgrow memory are refused, naming the option") {
    const PhotonScene s =
        photon_scene({}, {closed_box(1, Rgb(0.5f))}, {PointLight{{0, 0, 0}, Rgb(1)}}, photon_options(3 * kCount));
    const TracedPhotons all = s.trace();
    const size_t needed = all.on_polygons.size() * kPolygonPhotonBytes;
    const auto trace = [&](size_t most) { return trace_photons(s.scene, s.prepared, s.plan, s.options, most); };
    CHECK(trace(needed).on_polygons.size() == all.on_polygons.size());
    CHECK_THROWS_WITH_AS(trace(needed - 1), doctest::Contains("photons.count"), InputError);
    CHECK(bytes(all.on_polygons) == needed);
}

TEST_CASE("no photon, one photon and black lights leave finite lists") {
    const auto traced = [](int count, const std::vector<Light>& lights) {
        PhotonScene s = photon_scene({}, {square(1, Rgb(0.5f))}, lights, photon_options(count));
        s.plan.polygon_gather = true;  // whatever the plan thinks of it
        return s.trace();
    };
    const DistantLight bright{{0, 0, -1}, Rgb(1)};
    CHECK(traced(0, {bright}).on_polygons.size() == 0);
    CHECK(traced(0, {bright}).statistics.lights.size() == 1);
    CHECK(traced(1, {bright}).statistics.lights[0].emitted == 1);
    CHECK(traced(1, {bright}).on_polygons.size() <= 1);
    CHECK(traced(100, {}).on_polygons.size() == 0);
    CHECK(traced(100, {DistantLight{{0, 0, -1}, Rgb(0)}}).on_polygons.size() == 0);
    for (const Light& light : std::vector<Light>{PointLight{{1e6, 0, 1e6}, Rgb(1e30f)}, PointLight{{0, 0, 0}, Rgb(1)},
                                                 SpotLight{{1e6, 0, 1e6}, {0, 0, 0}, 1, Rgb(1)}})
        for (const Rgb& power : traced(100, {light}).on_polygons.power) CHECK(is_finite(power));
}
