// SPDX-License-Identifier: MIT
// Projection against rays at points that the eye sees: error of irradiance, time, bytes.
//     projection_bench [SCENE] [--points N] [--rays N] [--on hair|polygons] [--segments N] [--groom NAME] [--eumelanin
//     X] [--set "key=value ..."]...
// One row for every --set. E is the mean over the sphere (at polygons: the hemisphere) of transmittance of hair times
// the light of a sky: E0 uniform, E1 4 max(0, cos), E2 max(0, cos)^64, a lobe of 10 degrees. Errors are relative to
// the mean E of all points: root of mean square, and signed mean. Truth: rays, N stratified ones a point. Times: one
// thread.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>

#include "core/builtin_scene.h"
#include "core/error.h"
#include "core/rng.h"
#include "core/sampling.h"
#include "gather/camera_points.h"
#include "gather/projection/calibrate_gap.h"
#include "gather/projection/viewpoints.h"
#include "gather/seen_points.h"
#include "io/load_scene.h"
#include "io/scene_file.h"
#include "tests/bench_support.h"

using namespace tress;
using namespace tress::test;

namespace {

struct Arguments {
    std::string scene;
    std::vector<std::string> rows;
    int points = 200, rays = 16384;
    uint64_t segments = 0;
    float eumelanin = -1;  // below 0: the scene's own fibers
    std::string groom;     // in place of the scene's
    bool on_hair = true;
};

Arguments read_arguments(int count, char** values) {
    Arguments a;
    a.scene = read_flags(count, values, [&](const std::string& name, const std::string& value) {
        if (name == "--points") a.points = std::max(std::atoi(value.c_str()), 1);
        if (name == "--rays") a.rays = std::max(std::atoi(value.c_str()), 64);
        if (name == "--segments") a.segments = uint64_t(std::atoll(value.c_str()));
        if (name == "--eumelanin") a.eumelanin = float(std::atof(value.c_str()));
        if (name == "--groom") a.groom = value;
        if (name == "--on") a.on_hair = value == "hair";
        if (name == "--set") a.rows.push_back(value);
    });
    if (a.rows.empty()) a.rows.push_back("");
    return a;
}

constexpr int kSkies = 3;
/// Of the three skies, means over channels.
struct Irradiance {
    double e[kSkies] = {};
};

/// Radiance of the skies along a direction; their middle is `up`.
void add_light(const Vec3& direction, const Rgb& transmittance, double share, Irradiance& to) {
    static const Vec3 up = normalize(Vec3(0.3f, 0.9f, 0.4f));
    const double cosine = std::max(double(dot(direction, up)), 0.0), t = double(mean(transmittance));
    to.e[0] += share * t;
    to.e[1] += share * t * 4 * cosine;
    to.e[2] += share * t * std::pow(cosine, 64);
}

std::vector<ShadingPoint> seen_points(const Scene& scene, const PreparedScene& prepared, const Options& options,
                                      bool on_hair, size_t most) {
    CameraPoints seen;
    const Camera& camera = scene.camera;
    find_camera_points(scene, prepared, camera_frame(camera), options, {0, 0, camera.width, camera.height}, 0, seen);
    std::vector<ShadingPoint> points, kept;
    const Bounds hair = bounds(prepared.segments);
    for (const ShadingPoint& point : seen.points)
        if ((point.fiber != kPolygon) == on_hair && hair.holds(point.position)) points.push_back(point);
    const size_t step = std::max<size_t>(points.size() / most, 1);
    for (size_t i = 0; i < points.size() && kept.size() < most; i += step) kept.push_back(points[i]);
    return kept;
}

/// One ray a cell of an igloo of `count` cells, or several where there is none so fine.
Irradiance by_rays(const PreparedScene& prepared, const Options& options, const ShadingPoint& point,
                   const Viewpoint& from, int count) {
    const int upper = from.dome == Dome::sphere ? count / 2 : count;
    const Igloo igloo = make_igloo(uint32_t(std::clamp(upper, int(Igloo::kFewestCells), int(Igloo::kMostCells))));
    const uint32_t cells = igloo.cells_of(from.dome), rounds = std::max(uint32_t(upper) / igloo.cells, 1u);
    Irradiance sum;
    for (uint32_t round = 0; round < rounds; ++round) {
        RayBuffer rays;
        for (uint32_t cell = 0; cell < cells; ++cell) {
            const uint64_t key = hash(hash(0x7472757468 + round, cell), std::bit_cast<uint32_t>(point.position.x));
            const float u = random(key, 0), v = random(key, 1);
            rays.add(point.position, from.frame.to_world(direction_in(igloo, cell, {u, v})), kInfinity, point.excluded);
        }
        std::vector<Rgb> through(rays.size());
        transmittance(prepared.hair, rays.for_hair(), prepared.attenuation, options.cutoff, through, options.isa);
        for (uint32_t i = 0; i < cells; ++i) add_light(rays.direction(i), through[i], 1.0 / cells / rounds, sum);
    }
    return sum;
}

/// Light of the skies over each cell by 16 directions.
Irradiance by_cells(const Igloo& igloo, const Viewpoint& from, const CellLight& light) {
    Irradiance sum;
    constexpr int n = 4;
    for (uint32_t cell = 0; cell < light.cells; ++cell)
        for (int i = 0; i < n * n; ++i) {
            const Vec2 u((float(i / n) + 0.5f) / n, (float(i % n) + 0.5f) / n);
            add_light(from.frame.to_world(direction_in(igloo, cell, u)), light.transmittance(cell),
                      1.0 / (n * n * double(light.cells)), sum);
        }
    return sum;
}

struct Truth {
    std::vector<ShadingPoint> points;
    std::vector<Viewpoint> from;
    std::vector<Irradiance> e;
};

void print_errors(const std::vector<Irradiance>& test, const std::vector<Irradiance>& truth) {
    for (int sky = 0; sky < kSkies; ++sky) {
        double squares = 0, bias = 0, mean = 0;
        for (size_t i = 0; i < truth.size(); ++i) {
            const double off = test[i].e[sky] - truth[i].e[sky];
            squares += off * off, bias += off, mean += truth[i].e[sky];
        }
        const double n = double(truth.size());
        mean /= n;
        std::printf("  E%d %5.2f (%+5.2f)", sky, 100 * std::sqrt(squares / n) / mean, 100 * bias / n / mean);
    }
}

/// As for a render of the hair alone under a uniform sky, whatever the fibers do with the light.
std::vector<LightTrial> under_uniform_sky(const std::vector<ShadingPoint>& points, size_t most) {
    constexpr uint32_t kDirections = 512;
    std::vector<LightTrial> trials(std::min(points.size(), most));
    for (size_t i = 0; i < trials.size(); ++i) {
        trials[i].point = points[i * points.size() / trials.size()];
        const Sampler sampler{hash(2, i), 0};
        for (uint32_t j = 0; j < kDirections; ++j) {
            const Vec3 direction = sample_uniform_sphere(Sampler{sampler.key, j}.get2(0));
            const bool above =
                trials[i].point.fiber != kPolygon || dot(direction, trials[i].point.geometric_normal) > 0;
            if (above) trials[i].seen.push_back({direction, Rgb(1.0f / kDirections), kInfinity, false});
        }
    }
    return trials;
}

/// `seen`: points that the gap is chosen by.
void measure(const SeenPoints& seen, Options options, const std::string& row, PreparedScene& prepared,
             const Truth& truth) {
    set_options(options, row);
    const double start = seconds();
    ProjectionDetail detail = options.projection.detail;
    if (detail == ProjectionDetail::automatic) detail = ProjectionDetail::tree;
    HairProjection& projection = prepared.projection;
    projection = make_hair_projection(prepared.segments, prepared.attenuation, detail, options);
    const double built = seconds();
    if (options.projection.gap < 0)
        calibrate_gap(prepared, options, {under_uniform_sky(seen.hair, 256), under_uniform_sky(seen.polygons, 64)});
    ProjectionScratch scratch;
    CellLight light;
    const size_t n = truth.points.size();
    std::vector<double> times;
    std::vector<Irradiance> found;
    const auto project_from = [&](size_t i) {
        project(projection, prepared.segments, truth.from[i], unseen_from(truth.points[i], prepared.segments),
                options.isa, scratch);
    };
    for (size_t i = 0; i < n; ++i) project_from(i);  // the first look at memory is not measured
    for (size_t i = 0; i < n; ++i) {
        const double from = seconds();
        project_from(i);
        find_light(projection, truth.from[i], options.isa, scratch, light);
        times.push_back(seconds() - from);
        found.push_back(by_cells(projection.igloo, truth.from[i], light));
    }
    const GapShares& gaps = projection.gap(truth.from[0].dome).shares;
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    std::printf("%-60s build %5.2f s %7.1f MB  gap %.2f scatter %.2f %9.1f us a point", row.c_str(), built - start,
                double(bytes(projection)) / 1e6, double(gaps.gap), double(gaps.scatter), 1e6 * sum / double(n));
    if (detail == ProjectionDetail::all)
        std::printf(" (%.2f ns a segment)", 1e9 * sum / double(n) / double(prepared.segments.size()));
    print_errors(found, truth.e);
    std::printf("\n");
    std::fflush(stdout);
}

void run(const Arguments& arguments) {
    SceneDescription description = arguments.scene.empty() ? builtin_scene() : read_scene_file(arguments.scene);
    description.camera.width = description.camera.height = 128;
    for (HairDescription& hair : description.hair) {
        if (arguments.segments) hair.segments = arguments.segments;
        if (!arguments.groom.empty()) hair.groom = arguments.groom;
        if (arguments.eumelanin >= 0) hair.fiber.absorption = Melanin{arguments.eumelanin, 0};
    }
    Options& o = description.options;
    o.type1 = LampMethod::ray;
    o.type2 = GatherMethod::ray;
    const LoadedScene loaded = load_scene(description);
    Options no_photons = o;
    no_photons.photons.count = 0;
    no_photons.type3 = CrossingMethod::off;
    PreparedScene prepared = prepare(loaded.scene, make_plan(loaded.scene, no_photons), o);
    Truth truth;
    truth.points = seen_points(loaded.scene, prepared, o, arguments.on_hair, size_t(arguments.points));
    const size_t n = truth.points.size();
    truth.e.resize(n);
    for (const ShadingPoint& point : truth.points)
        truth.from.push_back(viewpoint_of(point, hash(1, truth.from.size())));
    const double start = seconds();
    tbb::parallel_for(size_t(0), n, [&](size_t i) {
        truth.e[i] = by_rays(prepared, o, truth.points[i], truth.from[i], arguments.rays);
    });
    double mean = 0;
    for (const Irradiance& e : truth.e) mean += e.e[0] / double(n);
    std::printf("%zu segments, %zu points, truth by %d rays a point in %.1f s, mean E0 %.4f\n",
                prepared.segments.size(), n, arguments.rays, seconds() - start, mean);
    for (const int rays : {256, 1024}) {
        std::vector<Irradiance> found(n);
        const double from = seconds();
        for (size_t i = 0; i < n; ++i) {
            Viewpoint turned = truth.from[i];
            turned.frame = viewpoint_of(truth.points[i], hash(2, i)).frame;
            found[i] = by_rays(prepared, o, truth.points[i], turned, rays);
        }
        std::printf("%5d rays, stratified %*s %9.1f us a point", rays, 59, "", 1e6 * (seconds() - from) / double(n));
        print_errors(found, truth.e);
        std::printf("\n");
    }
    SeenPoints seen = find_seen_points(loaded.scene, prepared, o);
    std::erase_if(seen.polygons,
                  [hair = bounds(prepared.segments)](const ShadingPoint& p) { return !hair.holds(p.position); });
    for (const std::string& row : arguments.rows) measure(seen, o, row, prepared, truth);
}

}  // namespace

int main(int count, char** values) {
    try {
        run(read_arguments(count, values));
        return 0;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
