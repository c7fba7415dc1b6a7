// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "accel/queries.h"
#include "gather/shading_point.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

EnvironmentLight white_sky() { return {}; }

/// 40 fibers, a square behind them, every kind of light.
Scene busy_scene(int size) {
    std::vector<Vec2> xz;
    for (int i = 0; i < 40; ++i) xz.push_back({0.05f * float(i) - 1, 1 + 0.3f * float(i % 5)});
    FiberParameters brown;
    brown.sigma_a = sigma_a_from_melanin(0.8f, 0.1f);
    const std::vector<Light> lights = {PointLight{{1, 2, 4}, Rgb(30)}, SpotLight{{-2, 1, 5}, {0, 0, 0}, 40, Rgb(40)},
                                       DistantLight{{0.2, -0.5, -1}, Rgb(0.5f)},
                                       QuadLight{{-1, 2, 4}, {{2, 0, 0}, {0, 1, -1}}, Rgb(3)}, white_sky()};
    return assemble({upright_fibers(xz, 1.5f, 0.02f, make_fiber(brown))}, {square(3, {0.7f, 0.5f, 0.3f})}, lights,
                    camera_on_z(8, 30, size));
}

}  // namespace

TEST_CASE("a lone white fiber under a white sky cannot be seen: its white furnace is 1") {
    Options options = small_options();
    options.spp = 1024;
    const Scene scene =
        assemble({upright_fibers({{0, 0}}, 10, 1, white_fiber())}, {}, {white_sky()}, camera_on_z(30, 8, 16));
    const Rendered r = render(scene, options);
    // Directions are drawn by the sky, so the estimate's spread is that of the lobes: take what the film measured.
    double sum = 0, variance = 0;
    const Layer &beauty = *r.layer(""), &spread = *r.layer("variance");
    const size_t pixels = beauty.data.size() / 4;
    for (size_t i = 0; i < pixels; ++i) {
        sum += double(beauty.data[4 * i]);
        variance += double(spread.data[3 * i]);
    }
    const double mean = sum / double(pixels), standard_error = std::sqrt(variance) / double(pixels);
    CAPTURE(mean);
    CAPTURE(standard_error);
    CHECK(standard_error < 0.01);
    CHECK(std::abs(mean - 1) < 4 * standard_error + 1e-3);
}

TEST_CASE("an open square under a uniform sky sends back albedo times the sky") {
    Options options = small_options();
    options.spp = 64;
    const Scene scene = assemble({}, {square(1, Rgb(0.6f, 0.4f, 0.2f))}, {white_sky()}, camera_on_z(10, 5, 8));
    const Rendered r = render(scene, options);
    const Layer& type2 = *r.layer("type2");
    // 64 pixels x 64 samples of a cosine by uniform directions on the sphere: sd of one is sqrt(4/3 - 1/... ) < 1.3.
    const double bound = 4 * 1.3 / std::sqrt(64.0 * 64.0);
    for (int channel = 0; channel < 3; ++channel) {
        double sum = 0;
        for (size_t i = 0; i < 64; ++i) sum += double(type2.data[3 * i + size_t(channel)]);
        const double albedo = double(Rgb(0.6f, 0.4f, 0.2f)[channel]);
        CHECK(std::abs(sum / 64 / albedo - 1) < bound);
    }
}

TEST_CASE("a point light on a square gives albedo / pi cos / d^2") {
    Options options = small_options();
    options.spp = 1;
    options.film.filter_radius = 0.5f;
    const Scene scene =
        assemble({}, {square(1, Rgb(0.5f))}, {PointLight{{0, 0, 2}, Rgb(4)}}, camera_on_z(100, 0.001, 1));
    const Rendered r = render(scene, options);
    CHECK(r.layer("type1")->data[0] == doctest::Approx(0.5 / 3.14159265 * 4 / 4).epsilon(1e-5));
}

TEST_CASE("light through a fiber falls off by its attenuation, and only behind it") {
    // A fiber of radius 0.5 between a square and a far lamp straight ahead: the shadow is one fiber wide.
    Options options = small_options();
    options.spp = 4096;
    options.film.filter_radius = 0.5f;
    FiberParameters parameters;
    parameters.sigma_a = {0.1f, 0.5f, 2.0f};
    const Fiber fiber = make_fiber(parameters);
    Camera camera = camera_on_z(1, 120, 1);
    camera.from = {0, 0, 0.1};  // between the fiber and the square
    for (const double x : {0.0, 2.0}) {
        camera.from.x = camera.to.x = x;
        camera.fov = 0.01;
        const Scene scene = assemble({upright_fibers({{0, 5}}, 100, 0.5f, fiber)}, {square(50, Rgb(1))},
                                     {DistantLight{{0, 0, -1}, Rgb(3.14159265f)}}, camera);
        const Rendered r = render(scene, options);
        const Rgb through = exp(-make_attenuation_table(fiber).at(0));
        CAPTURE(x);
        for (size_t channel = 0; channel < 3; ++channel)
            CHECK(double(r.layer("type1")->data[channel]) ==
                  doctest::Approx(x == 0 ? double(through[int(channel)]) : 1.0).epsilon(1e-4));
    }
}

TEST_CASE("the picture is the same bit for bit for any number of threads and any division into passes") {
    Options options = small_options();
    options.spp = 4;
    const Scene scene = busy_scene(70);
    const Rendered one_pass = render(scene, options);
    for (const size_t threads : {size_t(1), size_t(2), size_t(3)}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Rendered parts = render(scene, [&] {
            Options o = options;
            o.spp = 1;
            return o;
        }());
        for (int pass = 1; pass < 4; ++pass) advance(parts.state, scene, parts.prepared, parts.plan, options, 1);
        const LayeredImage picture = develop(parts.state.film);
        CAPTURE(threads);
        REQUIRE(picture.layers.size() == one_pass.picture.layers.size());
        for (size_t i = 0; i < picture.layers.size(); ++i)
            CHECK(picture.layers[i].data == one_pass.picture.layers[i].data);
    }
}

TEST_CASE("every instruction set gives the same picture bit for bit") {
    Options options = small_options();
    options.spp = 2;
    const Scene scene = busy_scene(48);
    const Rendered best = render(scene, options);
    for (const Isa isa : supported_isas()) {
        options.isa = isa;
        CAPTURE(isa_name(isa));
        const Rendered other = render(scene, options);
        for (size_t i = 0; i < best.picture.layers.size(); ++i)
            CHECK(other.picture.layers[i].data == best.picture.layers[i].data);
    }
}

TEST_CASE("beauty is the sum of the layers where something is hit") {
    Options options = small_options();
    options.spp = 4;
    const Rendered r = render(busy_scene(32), options);
    const Layer &beauty = *r.layer(""), &type1 = *r.layer("type1"), &type2 = *r.layer("type2"),
                &type3 = *r.layer("type3");
    for (size_t i = 0; i < 32 * 32; ++i) {
        if (beauty.data[4 * i + 3] < 1) continue;  // some sky is seen directly
        for (size_t c = 0; c < 3; ++c) {
            const float sum = type1.data[3 * i + c] + type2.data[3 * i + c] + type3.data[3 * i + c];
            CHECK(beauty.data[4 * i + c] == doctest::Approx(double(sum)).epsilon(1e-6));
        }
    }
    CHECK(all_finite(r.picture));
}

TEST_CASE("what a scene does not need is neither built nor timed nor kept") {
    Options options = small_options();
    options.spp = 1;
    const auto names = [](const std::vector<StageCost>& costs) {
        std::vector<std::string> list;
        for (const StageCost& cost : costs) list.push_back(cost.name);
        return list;
    };
    const Camera camera = camera_on_z(10, 30, 4);
    SUBCASE("no hair, lamps alone") {
        options.type2 = GatherMethod::off;
        const Rendered r = render(assemble({}, {square(1, Rgb(1))}, {PointLight{{0, 0, 3}, Rgb(1)}}, camera), options);
        CHECK(r.prepared.hair.empty());
        CHECK(names(r.prepared.costs) == std::vector<std::string>{stage::kMeshTree});
        CHECK(names(loop_costs(r.state, r.prepared, r.plan)) ==
              std::vector<std::string>{stage::kCameraRays, stage::kType1});
        CHECK(r.state.film.types[1].light.empty());
    }
    SUBCASE("no meshes, no light") {
        const Rendered r =
            render(assemble({upright_fibers({{0, 0}}, 1, 0.1f, white_fiber())}, {}, {}, camera), options);
        CHECK(r.prepared.mesh.empty());
        CHECK(names(r.prepared.costs) == std::vector<std::string>{stage::kHairTree});
        CHECK(r.state.film.types[0].light.empty());
        CHECK(r.prepared.attenuation.table.empty());
    }
    SUBCASE("nothing at all, one pixel") {
        Camera pixel = camera;
        pixel.width = pixel.height = 1;
        const Rendered r = render(assemble({}, {}, {}, pixel), options);
        CHECK(r.prepared.costs.empty());
        CHECK(r.layer("")->data == std::vector<float>{0, 0, 0, 0});
    }
    SUBCASE("types switched off") {
        for (const PathType type : {PathType::type1, PathType::type2, PathType::type3}) switch_off(options, type);
        const Rendered r = render(busy_scene(8), options);
        CHECK(r.prepared.attenuation.table.empty());
        CHECK(names(loop_costs(r.state, r.prepared, r.plan)) == std::vector<std::string>{stage::kCameraRays});
    }
}

TEST_CASE("stages are timed in the order of the plan") {
    Options options;
    options.photons.count = 100;
    options.type4 = options.type5 = ScatteredMethod::photons;
    const Scene scene = assemble({upright_fibers({{0, 0}}, 1, 0.1f, white_fiber())}, {square(1, Rgb(1))},
                                 {PointLight{{0, 0, 3}, Rgb(1)}, EnvironmentLight{}}, camera_on_z(10, 30, 4));
    const Rendered r = render(scene, options);
    std::vector<std::string> planned, timed;
    for (const PlanItem& item : r.plan.stages)
        if (!item.name.starts_with("light ")) planned.push_back(item.name);
    for (const StageCost& cost : r.prepared.costs) timed.push_back(cost.name);
    for (const StageCost& cost : loop_costs(r.state, r.prepared, r.plan)) timed.push_back(cost.name);
    CHECK(timed == planned);
}

TEST_CASE("lights of absurd strength or nearness stay finite") {
    Options options = small_options();
    options.spp = 2;
    const Camera camera = camera_on_z(10, 30, 8);
    const PlacedHair hair = upright_fibers({{0, 1}, {0.2f, 1}}, 1, 0.05f, white_fiber());
    for (const Light& light : {Light(PointLight{{0, 0, 3}, Rgb(1e30f)}), Light(PointLight{{0, 0, 1e-20}, Rgb(1)}),
                               Light(PointLight{{0, 0.5, 1}, Rgb(1)}), Light(DistantLight{{0, 0, -1e-300}, Rgb(1)}),
                               Light(QuadLight{{-1, -1, 1e-9}, {{2, 0, 0}, {0, -2, 0}}, Rgb(1e20f)})}) {
        const Rendered r = render(assemble({hair}, {square(2, Rgb(1))}, {light}, camera), options);
        CHECK(all_finite(r.picture));
    }
}

TEST_CASE("a bad segment is dropped and the rest of the groom renders as without it") {
    Options options = small_options();
    options.spp = 4;
    const Camera camera = camera_on_z(10, 30, 32);
    PlacedHair good = upright_fibers({{-0.5f, 0}, {0.5f, 0}}, 1, 0.1f, white_fiber());
    PlacedHair bad = good;
    bad.strands.add_point({NAN, 0, 0});
    bad.strands.add_point({0, 0, 0});
    bad.strands.first.push_back(uint32_t(bad.strands.points()));
    const std::vector<Light> lights = {PointLight{{0, 0, 5}, Rgb(20)}};
    const Scene with_bad = assemble({bad}, {}, lights, camera);
    CHECK(with_bad.segments.dropped == 1);
    const Rendered a = render(assemble({good}, {}, lights, camera), options), b = render(with_bad, options);
    CHECK(a.layer("")->data == b.layer("")->data);
}

TEST_CASE("a lamp in the plane of a ceiling lights as one just below it") {
    Options options = small_options();
    options.spp = 16;
    const auto mean_light = [&](double gap) {
        PlacedMesh ceiling = square(20, Rgb(0.5f)), floor = square(5, Rgb(0.5f));
        ceiling.placement.m = {0.8, 0, 0.6, 1.2, 0, 1, 0, 0, -0.6, 0, 0.8, 9.1};  // tilted, so that rounding shows
        const DVec3 down(-0.6, 0, -0.8), along(0.8, 0, -0.6), middle(1.2, 0, 9.1);
        const QuadLight lamp{middle - along + gap * down, {DVec3(0, 1, 0), along}, Rgb(5)};
        Camera camera = camera_on_z(4, 60, 16);
        const Rendered r = render(assemble({}, {ceiling, floor}, {lamp}, camera), options);
        double sum = 0;
        for (const float v : r.layer("type1")->data) sum += double(v);
        return sum;
    };
    REQUIRE(mean_light(0.01) > 0);
    CHECK(mean_light(0) == doctest::Approx(mean_light(0.01)).epsilon(0.01));  // the gap itself moves the lamp by 0.1 %
}

TEST_CASE("a grazing lamp does not make a large floor shadow itself") {
    Options options = small_options();
    options.spp = 1;
    for (const float half : {10.0f, 1e3f, 1e5f}) {
        PlacedMesh floor = square(half, Rgb(1));
        floor.placement.m = {0.8, 0, 0.6, 0, 0, 1, 0, 0, -0.6, 0, 0.8, 0};
        const DVec3 normal(0.6, 0, 0.8), along(0.8, 0, -0.6);
        Camera camera;
        camera.from = 4.0 * normal;
        camera.to = {0, 0, 0};
        camera.width = camera.height = 32;
        const DistantLight lamp{-(0.05 * normal + along), Rgb(1)};
        const Rendered r = render(assemble({}, {floor}, {lamp}, camera), options);
        int dark = 0;
        for (size_t i = 0; i < 32 * 32; ++i) dark += r.layer("type1")->data[3 * i] <= 0;
        CAPTURE(half);
        CHECK(dark == 0);
    }
}

TEST_CASE("the albedo layer shows the segment that is hit, lit or not") {
    PlacedHair hair;
    hair.strands.constant_radius = 0.2f;
    hair.strands.first = {0, 3};
    for (const float y : {-2.0f, 0.0f, 2.0f}) hair.strands.add_point({0, y, 0});
    hair.strands.color = {Rgb(0.9f, 0.1f, 0.1f), Rgb(0.1f, 0.9f, 0.1f), Rgb(0.1f, 0.9f, 0.1f)};
    hair.fiber = white_fiber();
    Camera camera = camera_on_z(10, 0.1, 1);
    camera.from.y = camera.to.y = 1;
    Options options = small_options();
    options.spp = 1;
    for (const std::vector<Light>& lights : {std::vector<Light>{}, std::vector<Light>{EnvironmentLight{}}}) {
        const Rendered r = render(assemble({hair}, {}, lights, camera), options);
        CHECK(r.layer("albedo")->data[1] > r.layer("albedo")->data[0]);  // green, as its segment is
    }
}

TEST_CASE("scenes a billion times larger or smaller render without NaN, and alike") {
    Options options = small_options();
    options.spp = 4;
    std::vector<double> means;
    for (const double scale : {1.0, 0x1p30, 0x1p-30}) {
        PlacedHair hair = upright_fibers({{-0.3f, 1}, {0, 1}, {0.3f, 1}}, 1, 0.05f, white_fiber());
        PlacedMesh floor = square(2, Rgb(0.5f));
        for (auto* placement : {&hair.placement, &floor.placement})
            placement->m[0] = placement->m[5] = placement->m[10] = scale;
        Camera camera = camera_on_z(10 * scale, 30, 16);
        const DistantLight lamp{{0.1, 0, -1}, Rgb(1)};
        const Rendered r = render(assemble({hair}, {floor}, {lamp}, camera), options);
        CHECK(all_finite(r.picture));
        double sum = 0;
        for (const float v : r.layer("type1")->data) sum += double(v);
        means.push_back(sum);
    }
    CHECK(means[1] == means[0]);
    CHECK(means[2] == means[0]);
}

TEST_CASE("light of a sky with a small sun is its integral over the sphere, on a fiber and on a polygon") {
    EnvironmentLight sky;
    sky.image = make_image(16, 8);
    for (Rgb& texel : sky.image.pixel) texel = Rgb(0.2f, 0.3f, 0.5f);
    sky.image.at(9, 2) = Rgb(400, 300, 200);
    const EnvironmentSampler lookup = make_environment_sampler(sky);

    FiberParameters brown;
    brown.sigma_a = sigma_a_from_melanin(0.5f, 0.2f);
    for (const bool on_fiber : {true, false}) {
        CAPTURE(on_fiber);
        Camera camera = camera_on_z(10, 1e-4, 1);  // one point: the same offset for all samples
        camera.from.x = camera.to.x = 0.3;
        const std::vector<PlacedHair> hair(on_fiber ? 1 : 0, upright_fibers({{0, 0}}, 1, 1, make_fiber(brown)));
        const std::vector<PlacedMesh> mesh(on_fiber ? 0 : 1, square(1, Rgb(0.5f)));
        const Scene scene = assemble(hair, mesh, {sky}, camera);
        Options options = small_options();
        options.spp = 8192;
        const Rendered r = render(scene, options);

        const Hit hit{10, 0, on_fiber ? 0.5f : 0.65f, on_fiber ? 0.3f : 0.0f};
        const ShadingPoint point =
            on_fiber ? fiber_point(scene, r.prepared, {0, 0, -1}, hit) : polygon_point(scene, {0, 0, -1}, hit);
        glm::dvec3 integral(0);
        const int rows = 600, columns = 1200;
        for (int i = 0; i < rows; ++i)
            for (int k = 0; k < columns; ++k) {
                const float y = 1 - 2 * (float(i) + 0.5f) / rows, phi = 2 * kPi * (float(k) + 0.5f) / columns;
                const float radius = safe_sqrt(1 - y * y);
                const Vec3 wi(radius * std::cos(phi), y, radius * std::sin(phi));
                integral += glm::dvec3(scatter(scene, point, wi).value() * radiance(lookup, wi));
            }
        integral *= 4 * double(kPi) / (rows * columns);
        for (size_t c = 0; c < 3; ++c) {
            const double standard_error = std::sqrt(double(r.layer("variance")->data[c]));
            CAPTURE(integral[int(c)]);
            CAPTURE(standard_error);
            // Four standard errors, and the midpoint rule's error on bilinear texels and lobes (of order 1e-3 here).
            CHECK(std::abs(double(r.layer("type2")->data[c]) - integral[int(c)]) <
                  4 * standard_error + 2e-3 * integral[int(c)]);
        }
    }
}
