// SPDX-License-Identifier: MIT
// Shadow maps against rays at the points of hair that the eye sees: error, time to build, bytes, time to ask.
//     shadow_bench [SCENE] [--points N] [--rays N] [--set "key=value ..."]...
// One row for every --set (default: one row, no setting): the settings of that row; Type 1's method says which maps.
// Errors are of the transmittance of hair alone, on ways that no polygon stops:
//     a way     mean over points, lamps and samples of the lamp of |map - ray|: what one shadow ray would differ by
//     a lamp    mean over points and lamps of |mean over the lamp of map - of ray|: what a converged picture differs by
//     signed    the same without the absolute value
// Rays of a lamp: N x N, stratified over its area. Times: of asking, one thread, nanoseconds a way; rays on the same
// ways.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/builtin_scene.h"
#include "core/error.h"
#include "gather/camera_points.h"
#include "gather/connection.h"
#include "gather/lamp_visibility.h"
#include "io/load_scene.h"
#include "io/scene_file.h"
#include "tests/bench_support.h"

using namespace tress;
using namespace tress::test;

namespace {

struct Arguments {
    std::string scene;
    std::vector<std::string> rows;
    int points = 400, rays = 24;
};

Arguments read_arguments(int count, char** values) {
    Arguments a;
    a.scene = read_flags(count, values, [&](const std::string& name, const std::string& value) {
        if (name == "--points") a.points = std::max(std::atoi(value.c_str()), 1);
        if (name == "--rays") a.rays = std::max(std::atoi(value.c_str()), 1);
        if (name == "--set") a.rows.push_back(value);
    });
    if (a.rows.empty()) a.rows.push_back("");
    return a;
}

/// Ways from one point to the samples of one lamp.
LampRays ways(const Scene& scene, const ShadingPoint& point, uint32_t light, int n) {
    LampRays to;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 u((float(i) + 0.5f) / float(n), (float(j) + 0.5f) / float(n));
            const LightSample s = sample_lamp(scene.lights[light], point.position, u);
            if (max_component(s.irradiance) > 0)
                to.add(point.position, s.direction, short_of(point.position, s.distance), point.excluded, light, u,
                       point.segment);
        }
    return to;
}

struct Errors {
    double way = 0, lamp = 0, of_sign = 0, mean = 0;  // sums over points and lamps
    double ray_seconds = 0, map_seconds = 0;
    size_t lamps = 0, asked = 0;
};

void add(Errors& sum, const Errors& e) {
    sum.way += e.way, sum.lamp += e.lamp, sum.of_sign += e.of_sign, sum.mean += e.mean;
    sum.ray_seconds += e.ray_seconds, sum.map_seconds += e.map_seconds;
    sum.lamps += e.lamps, sum.asked += e.asked;
}

/// By one point and one lamp. Ways that a polygon stops are left out.
Errors compare(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
               const ShadingPoint& point, uint32_t light, int n) {
    const LampRays all = ways(scene, point, light, n);
    OpenRays open;
    find_open_rays(prepared, all.rays, options.isa, open);
    LampRays to;
    for (const uint32_t i : open.index)
        to.add(all.rays.origin(i), all.rays.direction(i), all.rays.far(i), point.excluded, light, all.place[i],
               all.segment[i]);
    Errors e;
    if (to.size() == 0) return e;
    LampVisibility query;
    std::vector<Rgb> by_ray(to.size()), by_map(to.size());
    const double start = seconds();
    query(scene, prepared, nullptr, 0, options, to, by_ray);
    const double between = seconds();
    const LampMaps* maps = plan.lamp_maps ? &prepared.shadow_maps[size_t(*plan.lamp_maps)] : nullptr;
    query(scene, prepared, maps, options.maps.near, options, to, by_map);
    e.ray_seconds = between - start;
    e.map_seconds = seconds() - between;
    Rgb difference(0), sum(0);
    for (size_t i = 0; i < to.size(); ++i) {
        e.way += double(mean(abs(by_map[i] - by_ray[i]))) / double(to.size());
        difference += (by_map[i] - by_ray[i]) / float(to.size());
        sum += by_ray[i] / float(to.size());
    }
    e.lamp = double(mean(abs(difference)));
    e.of_sign = double(mean(difference));
    e.mean = double(mean(sum));
    e.lamps = 1;
    e.asked = to.size();
    return e;
}

std::vector<ShadingPoint> hair_points(const Scene& scene, const PreparedScene& prepared, const Options& options,
                                      size_t most) {
    std::vector<ShadingPoint> points;
    CameraPoints seen;
    const Camera& camera = scene.camera;
    find_camera_points(scene, prepared, camera_frame(camera), options, {0, 0, camera.width, camera.height}, 0, seen);
    for (const ShadingPoint& point : seen.points)
        if (point.fiber != kPolygon) points.push_back(point);
    const size_t step = std::max<size_t>(points.size() / most, 1);
    std::vector<ShadingPoint> kept;
    for (size_t i = 0; i < points.size(); i += step) kept.push_back(points[i]);
    return kept;
}

void measure(const Scene& scene, Options options, const std::string& row, const Arguments& arguments) {
    set_options(options, row);
    const Plan plan = make_plan(scene, options);
    const PreparedScene prepared = prepare(scene, plan, options);
    const std::vector<ShadingPoint> points = hair_points(scene, prepared, options, size_t(arguments.points));
    std::vector<Errors> errors(points.size());
    tbb::parallel_for(size_t(0), points.size(), [&](size_t i) {
        for (const uint32_t light : plan.lamps)
            add(errors[i], compare(scene, prepared, plan, options, points[i], light, arguments.rays));
    });
    Errors sum;
    for (const Errors& e : errors) add(sum, e);
    StageCost cost;
    for (const StageCost& c : prepared.costs)
        for (const char* name : stage::kShadowMaps)
            if (c.name == name) cost = c;
    const double n = double(std::max<size_t>(sum.lamps, 1)), asked = double(std::max<size_t>(sum.asked, 1));
    std::printf("%-70s %7.2f s %8.1f MB  a way %.4f  a lamp %.4f  signed %+.4f  of %.4f  %5.0f ns (rays %5.0f ns)\n",
                row.c_str(), cost.seconds, double(cost.bytes) / 1e6, sum.way / n, sum.lamp / n, sum.of_sign / n,
                sum.mean / n, 1e9 * sum.map_seconds / asked, 1e9 * sum.ray_seconds / asked);
    std::fflush(stdout);
}

void run(const Arguments& arguments) {
    SceneDescription description = arguments.scene.empty() ? builtin_scene() : read_scene_file(arguments.scene);
    description.camera.width = description.camera.height = 128;
    Options& o = description.options;
    o.type1 = LampMethod::deep;
    o.type2 = GatherMethod::off;
    o.type3 = CrossingMethod::off;
    const LoadedScene loaded = load_scene(description);
    for (const std::string& row : arguments.rows) measure(loaded.scene, o, row, arguments);
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
