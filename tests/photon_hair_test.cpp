// SPDX-License-Identifier: MIT
// What photons do in hair.
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "accel/queries.h"
#include "core/frame.h"
#include "core/rng.h"
#include "tests/photon_support.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr int kCount = 1 << 13;

Fiber coloured_fiber() {
    FiberParameters p;
    p.sigma_a = {0.1f, 0.3f, 0.6f};
    return make_fiber(p);
}

Options showing(int count) {
    Options o = photon_options(count);
    o.type4 = o.type5 = ScatteredMethod::photons;
    return o;
}

DVec3 passed(const PhotonScene& s, float abs_sin_theta = 0) {
    return DVec3(exp(-s.prepared.attenuation.depth(0, abs_sin_theta)));
}

/// `n` fibers one behind the other, each as wide as what light comes down -z, before a black square.
PhotonScene row_of_fibers(int n, const Options& options) {
    std::vector<Vec2> at;
    for (int i = 0; i < n; ++i) at.push_back({0, 10 + 5 * float(i)});
    return photon_scene({upright_fibers(at, 20, 2, coloured_fiber())}, {square(1, Rgb(0))},
                        {SpotLight{{0, 0, 60}, {0, 0, 0}, 1, Rgb(1, 2, 4)}}, options);
}

/// Strands of length 1 at random about the origin: straight ones of one segment, or bent ones of five.
enum class Shape { straight, bent };
PlacedHair ball_of_hair(const Fiber& fiber, int strands, float radius, Shape shape = Shape::bent) {
    PlacedHair hair;
    hair.strands.constant_radius = radius;
    hair.strands.first = {0};
    uint64_t at = 0;
    const auto uniform = [&] { return 2 * random(99, at++) - 1; };
    for (int strand = 0; strand < strands; ++strand) {
        Vec3 p, step;
        p.x = uniform(), p.y = uniform(), p.z = uniform();
        step.x = uniform(), step.y = uniform(), step.z = uniform();
        const int pieces = shape == Shape::straight ? 1 : 5;
        step *= 1 / (float(pieces) * length(step));
        for (int i = 0; i <= pieces; ++i) {
            hair.strands.add_point(0.5f * (p - step * float(pieces)) + float(i) * step);
            if (shape == Shape::bent) step.x += 0.05f * uniform();
        }
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    hair.fiber = fiber;
    return hair;
}

/// A grey square under the ball.
PlacedMesh floor_below() {
    PlacedMesh floor = square(3, Rgb(0.5f));
    for (float& z : floor.mesh.z) z = -1.5f;
    return floor;
}

bool same(const PhotonList& a, const PhotonList& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.direction == b.direction && a.normal == b.normal &&
           a.power == b.power && a.type == b.type;
}

}  // namespace

TEST_CASE("behind n fibers arrives a_k to the n of the light, and each fiber is met by what the ones before let pass") {
    for (const int n : {1, 3}) {
        CAPTURE(n);
        const PhotonScene s = row_of_fibers(n, showing(kCount));
        const DVec3 a = passed(s);
        // By type: light that came straight, alone.
        const std::vector<Estimate> behind = over_seeds(s, 3, [](const TracedPhotons& photons, size_t c) {
            return power_of(photons.on_polygons, int(c), of_type(photons.on_polygons, PathType::type1));
        });
        const std::vector<Estimate> met = over_seeds(s, 2, [](const TracedPhotons& photons, size_t what) {
            const CrossingShare& share = photons.statistics.hair[size_t(LightSource::lamp)][0];
            return what == 0 ? share.power : photons.statistics.lights[0].power;
        });
        const DVec3 color(1, 2, 4);
        const double whole = met[1].mean / double(luminance(Rgb(color)));  // of a channel of 1
        DVec3 before = color * whole, sum(0);
        for (int k = 0; k < n; ++k) sum += before, before *= a;
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            CAPTURE(behind[size_t(c)].mean);
            CHECK(agrees(behind[size_t(c)], before[c]));
        }
        CHECK(agrees(met[0], double(luminance(Rgb(sum)))));
    }
}

TEST_CASE("light that one fiber scatters leaves by f_R |cos theta_o|, averaged over h, whatever the tilt") {
    FiberParameters parameters;
    parameters.alpha_degrees = 10;
    parameters.sigma_a = Rgb(0.2f);
    const Fiber fiber = make_fiber(parameters);
    // A narrow spot, wider than the fiber, at 45 degrees to its normal, in a black box.
    const float sine = std::sin(kPi / 4);
    const Vec3 from(0, sine, sine);
    const SpotLight spot{9.0 * DVec3(from), {0, 0, 0}, 2, Rgb(1)};
    const PhotonScene s = photon_scene({upright_fibers({{0, 0}}, 2, 0.05f, fiber)}, {closed_box(10, Rgb(0))}, {spot},
                                       photon_options(1 << 15));
    constexpr int rows = 8, sectors = 8;
    const Frame frame = fiber_frame({0, 1, 0}, from);
    const auto bin_of = [&](const Vec3& wo) {
        const float turn = std::atan2(wo.y, wo.z) / (2 * kPi) + 0.5f;
        return size_t(glm::min(int((wo.x + 1) / 2 * rows), rows - 1) * sectors +
                      glm::min(int(turn * sectors), sectors - 1));
    };
    const std::vector<Estimate> scattered = over_seeds(s, rows * sectors, [&](const TracedPhotons& p, size_t bin) {
        const double met = p.statistics.hair[size_t(LightSource::lamp)][0].power;
        const PhotonList& list = p.on_polygons;
        return power_of(list, 0,
                        [&](size_t i) {
                            return list.type[i] == index_of(PathType::type3) &&
                                   bin_of(frame.to_local(list.direction[i])) == bin;
                        }) /
               met;
    });

    std::vector<double> expected(rows * sectors), exchanged(rows * sectors);
    constexpr int n_x = 160, n_phi = 160, n_h = 32;
    const Vec3 wi = frame.to_local(from);
    const float cos_i = safe_sqrt(1 - wi.x * wi.x);
    for (int i = 0; i < n_x * n_phi; ++i) {
        const float x = 2 * (float(i % n_x) + 0.5f) / n_x - 1, cos_o = safe_sqrt(1 - x * x);
        const float phi = 2 * kPi * ((float(i / n_x) + 0.5f) / n_phi - 0.5f);
        const Vec3 wo(x, cos_o * std::sin(phi), cos_o * std::cos(phi));
        const double measure = 4 * double(kPi) / (n_x * n_phi) / n_h;
        for (int k = 0; k < n_h; ++k) {
            const float h = 2 * (float(k) + 0.5f) / n_h - 1;
            const float right = evaluate(fiber, parameters.sigma_a, wo, wi, h).reflected.x * cos_o / cos_i;
            expected[bin_of(wo)] += measure * double(right);
            exchanged[bin_of(wo)] += measure * double(evaluate(fiber, parameters.sigma_a, wi, wo, h).reflected.x);
        }
    }
    int told_apart = 0;
    for (size_t bin = 0; bin < expected.size(); ++bin) {
        CAPTURE(bin);
        CAPTURE(scattered[bin].mean);
        CAPTURE(scattered[bin].error);
        CAPTURE(expected[bin]);
        // The spot spans two degrees: of lobes some twenty wide, that is the second order.
        const double tolerance = 4.5 * scattered[bin].error + 0.01 * expected[bin] + 1e-4;
        CHECK(std::abs(scattered[bin].mean - expected[bin]) <= tolerance);
        told_apart += std::abs(exchanged[bin] - expected[bin]) > 2 * tolerance;
    }
    CHECK(told_apart >= 5);
}

TEST_CASE("white hair under a white sky is met everywhere by the light of that sky") {
    // Radiance is 1 all through, so every segment is met by 2 r l times the integral of |cos theta|, pi^2.
    const float radius = 0.003f;
    EnvironmentLight sky;
    sky.radiance = Rgb(1);
    FiberParameters tilted;
    tilted.alpha_degrees = 5;
    const PhotonScene s =
        photon_scene({ball_of_hair(make_fiber(tilted), 2500, radius, Shape::straight)}, {}, {sky}, [] {
            Options o = showing(1 << 14);
            o.type2 = GatherMethod::off;
            return o;
        }());
    const SegmentView& segments = s.prepared.segments;
    double expected = 0;
    for (size_t i = 0; i < segments.size(); ++i)
        expected += 2 * double(radius) * double(length(segments.end(i) - segments.start(i))) * double(kPi * kPi);
    const std::vector<Estimate> met = over_seeds(s, 2, [](const TracedPhotons& p, size_t what) {
        double sum = 0;
        for (const CrossingShare& share : p.statistics.hair[size_t(LightSource::elsewhere)]) sum += share.power;
        return what == 0 ? sum : p.statistics.hair[size_t(LightSource::elsewhere)][2].power / sum;
    });
    CAPTURE(met[0].mean);
    CAPTURE(met[0].error);
    CAPTURE(met[1].mean);
    CAPTURE(expected);
    // Rays may meet the ends of a fiber within a radius: that is 0.003 of its length.
    CHECK(std::abs(met[0].mean - expected) <= 4.5 * met[0].error + 0.003 * expected);
    CHECK(met[0].error < 0.01 * expected);
    CHECK(met[1].mean > 0.1);
}

TEST_CASE("figures and lists agree, and hair keeps no photons but those to be shown") {
    const std::vector<Light> lights{PointLight{{0, 0, 0}, Rgb(1)}, PointLight{{0, 3, 1}, Rgb(1, 2, 3)},
                                    EnvironmentLight{}};  // one inside the hair
    const auto traced = [&](ScatteredMethod type4, ScatteredMethod type5) {
        Options o = photon_options(kCount);
        o.type4 = type4, o.type5 = type5;
        return photon_scene({ball_of_hair(coloured_fiber(), 600, 0.004f)}, {floor_below()}, lights, o).trace();
    };
    const TracedPhotons both = traced(ScatteredMethod::photons, ScatteredMethod::photons);
    const PhotonStatistics& figures = both.statistics;
    const auto& lamp = figures.hair[size_t(LightSource::lamp)];
    const auto& elsewhere = figures.hair[size_t(LightSource::elsewhere)];
    size_t of4 = 0, of5 = 0;
    double power4 = 0;
    for (size_t i = 0; i < both.in_hair.size(); ++i) {
        REQUIRE(is_finite(both.in_hair.power[i]));
        const bool four = both.in_hair.type[i] == index_of(PathType::type4);
        (four ? of4 : of5) += 1;
        if (four) power4 += double(luminance(both.in_hair.power[i]));
    }
    CHECK(of4 > 0);
    CHECK(of4 == lamp[2].crossings);
    CHECK(of5 == elsewhere[1].crossings + elsewhere[2].crossings);
    CHECK(power4 == doctest::Approx(lamp[2].power));
    CHECK(both.in_hair.normal.empty());
    uint64_t emitted = 0, stored = 0;
    for (const LightPhotons& light : figures.lights) {
        CHECK(light.met_hair <= light.emitted);
        CHECK(light.met_hair > 0);
        emitted += light.emitted, stored += light.on_polygons;
    }
    CHECK(emitted == kCount);
    CHECK(stored == both.on_polygons.size());

    const TracedPhotons none = traced(ScatteredMethod::off, ScatteredMethod::off);
    CHECK(none.in_hair.size() == 0);
    CHECK(same(none.on_polygons, both.on_polygons));
}

TEST_CASE("without a map of polygons they keep only the types that are shown, and photons of no use are not made") {
    Options o = showing(kCount);
    o.type2 = GatherMethod::off;
    o.type5 = ScatteredMethod::off;
    const PhotonScene s = photon_scene({ball_of_hair(white_fiber(), 1500, 0.004f)}, {floor_below()},
                                       {PointLight{{0, 3, 1}, Rgb(1)}, EnvironmentLight{}}, o);
    const TracedPhotons photons = s.trace();
    CHECK(photons.statistics.lights.size() == 1);
    CHECK(photons.on_polygons.size() > 0);
    for (const PhotonList* list : {&photons.on_polygons, &photons.in_hair})
        for (const uint8_t type : list->type) CHECK(type == index_of(PathType::type4));
}

TEST_CASE("the lists are the same bit for bit for any number of threads and any instruction set") {
    PhotonScene s = photon_scene({ball_of_hair(coloured_fiber(), 300, 0.004f)}, {floor_below()},
                                 {PointLight{{0, 3, 1}, Rgb(1, 2, 3)}, EnvironmentLight{}}, showing(3 * 4096 + 5));
    const TracedPhotons reference = s.trace();
    const auto check = [&](const TracedPhotons& other) {
        CHECK(same(reference.on_polygons, other.on_polygons));
        CHECK(same(reference.in_hair, other.in_hair));
        CHECK(reference.statistics.lights[0].power == other.statistics.lights[0].power);
        CHECK(reference.statistics.hair[1][2].power == other.statistics.hair[1][2].power);
    };
    for (const size_t threads : {size_t(1), size_t(2)}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        check(s.trace());
    }
    for (const Isa isa : supported_isas()) {
        CAPTURE(isa_name(isa));
        s.options.isa = isa;
        check(s.trace());
    }
}

TEST_CASE("a fiber's power is kept where f_R has no light, and hostile fibers stay finite") {
    for (const float beta : {0.0f, 0.05f, 1.0f}) {
        for (const Rgb& sigma : {Rgb(0), Rgb(kInfinity), Rgb(0, 1, kInfinity)}) {
            for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner}) {
                FiberParameters p;
                p.model = model;
                p.beta_m = p.beta_n = beta, p.alpha_degrees = 20, p.sigma_a = sigma;
                const TracedPhotons photons = photon_scene({ball_of_hair(make_fiber(p), 200, 0.01f)}, {},
                                                           {PointLight{{0, 0, 0}, Rgb(1e30f)}}, showing(1000))
                                                  .trace();
                for (const Rgb& power : photons.in_hair.power) REQUIRE(is_finite(power));
            }
        }
    }
}
