// SPDX-License-Identifier: MIT
#include "tools/check/rows/few_photons.h"

#include <algorithm>

#include "gather/photons/photon_display.h"
#include "tools/check/support/map_energy.h"
#include "tools/check/support/pictures.h"
#include "tools/check/support/tufts.h"

namespace tress {
namespace {

using namespace test;

constexpr TypeSet kShown = {false, false, false, true, true};
constexpr int kSigma = 3;

/// `n` photons of power 1 together, all at `place` on a polygon that faces +z, or in hair.
PhotonList heap(int n, const Vec3& place, bool on_polygon) {
    PhotonList list;
    for (int i = 0; i < n; ++i) {
        const Arrival photon{place, {0, 0, -1}, Rgb(1 / float(n)), PathType::type5};
        if (on_polygon)
            add(list, photon, Vec3(0, 0, 1));
        else
            add(list, photon, 1.0f);
    }
    return list;
}

/// Power that a map says lands about a point of the plane z = 0, by rings from the smallest radius to the largest.
double power_about(const IrradianceMap& map, const Vec3& center, double smallest, double largest) {
    constexpr int kRingsADecade = 100, kAngles = 8;
    const int rings = int(kRingsADecade * std::log10(largest / smallest));
    const double step = std::log(largest / smallest) / rings;
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        const double radius = smallest * std::exp((i + 0.5) * step), area = 2 * double(kPi) * radius * radius * step;
        for (int k = 0; k < kAngles; ++k) {
            const double angle = 2 * double(kPi) * (k + 0.5) / kAngles;
            const Vec3 place(center.x + float(radius * std::cos(angle)), center.y + float(radius * std::sin(angle)), 0);
            sum += area / kAngles * double(irradiance(map, place, {0, 0, 1}).x);
        }
    }
    return sum;
}

double in_sigma(double share, double photons) { return std::abs(share - 1) * std::sqrt(photons); }

struct LitSquare {
    Rendered rendered;
    double energy = 0;  // that the map says lands, in shares of what was emitted; 0: none was
};

/// A spot all of whose light falls on a black square (half a unit from its middle): what it emits is what lands.
LitSquare light_square(float half, int photons, int nearest, uint64_t seed, Isa isa) {
    constexpr size_t kReads = 100'000;
    Options options;
    options.isa = isa;
    options.seed = seed;
    options.spp = 1;
    options.photons.count = photons;
    options.photons.nearest = nearest;
    const Scene scene =
        assemble({}, {square(half, Rgb(0))}, {SpotLight{{0.2, 0.1, 2}, {0, 0, 0}, 30, Rgb(3)}}, camera_on_z(5, 20, 4));
    LitSquare lit{render(scene, options)};
    const std::vector<LightPhotons>& lights = lit.rendered.prepared.photon_statistics.lights;
    if (!lights.empty() && lights[0].power > 0)
        lit.energy = energy(lit.rendered.prepared.photons.irradiance, scene.mesh, lights[0].power, kReads).share;
    return lit;
}

Figure no_photons(const CheckSettings& settings) {
    Options options;
    options.isa = settings.isa;
    options.spp = 2;
    options.type1 = LampMethod::off;
    options.type3 = CrossingMethod::off;
    options.type4 = options.type5 = ScatteredMethod::photons;
    options.photons.count = 0;
    Scene scene = two_tufts(16);
    std::erase_if(scene.lights, [](const Light& l) { return std::holds_alternative<EnvironmentLight>(l); });
    const Rendered r = render(scene, options);
    double light = 0;
    for (const glm::dvec3& sum : r.state.film.beauty) light += std::abs(sum.x) + std::abs(sum.y) + std::abs(sum.z);
    return exactly("light of 0 photons, types 2, 4 and 5", light, 0);
}

/// Pictures with few photons of all kinds.
Figure few_photons_in_pictures(const CheckSettings& settings) {
    size_t not_finite = 0, all = 0;
    const Scene scene = two_tufts(16);
    for (const int count : {0, 1, 2, 10, 49})
        for (const float radius : {0.0f, 1e-20f, 1e20f}) {
            Options options;
            options.isa = settings.isa;
            options.spp = 2;
            options.type4 = options.type5 = ScatteredMethod::photons;
            options.photons.count = count;
            options.photons.radius = radius;
            const LayeredImage picture = render(scene, options).picture;
            all += values(picture);
            not_finite += values_not_finite(picture);
        }
    return exactly("values not finite by 0 to 49 photons, 50 to an estimate, of " + std::to_string(all),
                   double(not_finite), 0);
}

/// Of the worst of a few seeds.
Figure energy_of_few(const std::string& where, float half, int photons, int nearest, const CheckSettings& settings) {
    constexpr uint64_t kSeeds = 8;
    double worst = 0;
    for (uint64_t seed = 0; seed < kSeeds; ++seed)
        worst = std::max(worst, in_sigma(light_square(half, photons, nearest, seed, settings.isa).energy, photons));
    return at_most("energy by " + std::to_string(photons) + " photons, " + std::to_string(nearest) + " to an estimate" +
                       where + ": off by, worst of " + std::to_string(kSeeds) + " seeds",
                   worst, kSigma, "sigma");
}

/// Light of photons that all lie at one point of a fiber, shown there.
LightByType shown_on_fiber(int photons, const Vec3& moved, Isa isa) {
    Options options;
    options.isa = isa;
    PlacedHair fiber = upright_fibers({{0, 0}}, 1, 0.01f, white_fiber());
    const Scene scene = assemble({fiber, upright_fibers({{2 * moved.x, 2 * moved.z}}, 1, 0.01f, white_fiber())}, {}, {},
                                 camera_on_z(5, 20, 4));
    PreparedScene prepared;
    prepared.segments = view(scene.hair, scene.segments);
    const ShadingPoint point = fiber_point(scene, prepared, {0, 0, -1}, {1, 0, 0.5f, 0});
    prepared.photons.shown =
        make_shown_photons(heap(photons, point.position, false), {}, kShown, prepared.segments, options.photons);
    LightByType light{};
    PhotonDisplay()(scene, prepared, options, {&point, 1}, {&light, 1});
    return light;
}

LightByType shown_on_square(int photons, const Vec3& place, Isa isa) {
    Options options;
    options.isa = isa;
    const Scene scene = assemble({}, {square(1, Rgb(0.5f))}, {}, camera_on_z(5, 20, 4));
    PreparedScene prepared;
    prepared.mesh = build_triangle_tree(scene.mesh, options.accel);
    prepared.photons.shown = make_shown_photons({}, heap(photons, place, true), kShown, {}, options.photons);
    ShadingPoint point;
    point.position = point.on_surface = place;
    point.geometric_normal = {0, 0, 1};
    point.color = Rgb(0.5f);
    LightByType light{};
    PhotonDisplay()(scene, prepared, options, {&point, 1}, {&light, 1});
    return light;
}

size_t not_finite(const LightByType& light) {
    return size_t(std::count_if(light.begin(), light.end(), [](const Rgb& l) { return !is_finite(l); }));
}

/// Photons at one point: away from the origin, where coordinates round, and at it, where they do not.
void add_heaps(const CheckSettings& settings, std::vector<Figure>& figures) {
    const TriangleMesh mesh = square(1, Rgb(0)).mesh;
    size_t bad_shown = 0, bad_in_map = 0, cases = 0;
    for (const Vec3& place : {Vec3(0.5f, 0.25f, 0), Vec3(0)})
        for (const int n : {1, 2, 30, 5000}) {
            ++cases;
            bad_shown += not_finite(shown_on_fiber(n, place, settings.isa));
            bad_shown += not_finite(shown_on_square(n, place, settings.isa));
            const IrradianceMap map = map_of(heap(n, place, true), mesh);
            for (const Rgb& light : map.irradiance) bad_in_map += !is_finite(light);
        }
    const std::string of = ", " + std::to_string(cases) + " heaps of 1 to 5000 at one point";
    figures.push_back(exactly("light not finite, shown on hair and polygons" + of, double(bad_shown), 0));
    figures.push_back(exactly("light not finite in irradiance maps" + of, double(bad_in_map), 0));

    constexpr int kHeap = 5000;
    for (const Vec3& place : {Vec3(0.5f, 0.25f, 0), Vec3(0)}) {
        const std::string where = place == Vec3(0) ? " at the origin" : " at one point";
        const IrradianceMap map = map_of(heap(kHeap, place, true), mesh);
        const double share = power_about(map, place, 1e-2 * double(map.farthest), 1);
        figures.push_back(told("energy of 5000 photons" + where + ", in shares of theirs", share));
        figures.push_back(at_most("the same: off by", in_sigma(share, kHeap), kSigma, "sigma"));
        figures.push_back(told("its least radius of a disc", double(map.farthest)));
    }
}

}  // namespace

Outcome measure_few_photons(const CheckSettings& settings) {
    std::vector<Figure> figures{no_photons(settings), few_photons_in_pictures(settings)};
    for (const int photons : {1, 2, 30}) figures.push_back(energy_of_few("", 1, photons, 50, settings));
    figures.push_back(energy_of_few(", on a wide square", 5, 300, 500, settings));
    figures.push_back(energy_of_few(", on a square that discs reach beyond", 1, 300, 500, settings));
    add_heaps(settings, figures);
    return {figures, {}};
}

}  // namespace tress
