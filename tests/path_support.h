// SPDX-License-Identifier: MIT
// What tests of paths share: points that an eye sees, and means with their standard errors.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "core/rng.h"
#include "gather/paths/path_tracer.h"
#include "tests/plain_path_tracer.h"
#include "tools/check/support/small_scenes.h"

namespace tress::test {

/// Mean of independent numbers.
struct Mean {
    double sum = 0, squares = 0;
    size_t count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double value() const { return sum / double(count); }
    double variance_of_mean() const {
        const double n = double(count);
        return std::max(squares / n - value() * value(), 0.0) / (n - 1);
    }
    double standard_error() const { return std::sqrt(variance_of_mean()); }
};

inline double standard_error_of_difference(const Mean& a, const Mean& b) {
    return std::sqrt(a.variance_of_mean() + b.variance_of_mean());
}

inline Options all_by_path(ScatteringModel scattering = ScatteringModel::straight) {
    Options options;
    use_paths(options);
    options.scattering = scattering;
    return options;
}

/// The scene under some options, and what its camera sees at the middle of each pixel.
struct Viewed {
    const Scene& scene;
    Options options;
    Plan plan;
    PreparedScene prepared;
    std::vector<ShadingPoint> points;

    Viewed(const Scene& from, const Options& by)
        : scene(from), options(by), plan(make_plan(from, by)), prepared(prepare(from, plan, by)) {
        const CameraFrame frame = camera_frame(scene.camera);
        for (int y = 0; y < scene.camera.height; ++y)
            for (int x = 0; x < scene.camera.width; ++x)
                look(Vec3(scene.camera.from), camera_direction(frame, scene.camera, x + 0.5, y + 0.5));
    }

    /// Points on one fiber, or on polygons (kPolygon).
    std::vector<ShadingPoint> points_on(uint32_t fiber) const {
        std::vector<ShadingPoint> some;
        for (const ShadingPoint& point : points)
            if (point.fiber == fiber) some.push_back(point);
        return some;
    }

private:
    void look(const Vec3& origin, const Vec3& direction) {
        RayBuffer ray;
        ray.add(origin, direction, kInfinity, {});
        Hit hair{kInfinity, kNone, 0, 0}, polygon = hair;
        const auto out = [](Hit& hit) { return NearestHits{{&hit.t, 1}, {&hit.id, 1}, {&hit.u, 1}, {&hit.h, 1}}; };
        if (!prepared.hair.empty()) nearest_segment(prepared.hair, ray.for_hair(), out(hair), options.isa);
        if (!prepared.mesh.empty()) nearest_triangle(prepared.mesh, ray.for_mesh(), out(polygon), options.isa);
        if (polygon.t < hair.t)
            points.push_back(polygon_point(scene, direction, polygon));
        else if (hair.id != kNone)
            points.push_back(fiber_point(scene, prepared, direction, hair));
    }
};

/// Luminance of each type and of their sum.
struct TypeMeans {
    PerType<Mean> type;
    Mean sum;

    void add(const LightByType& light) {
        double all = 0;
        for (size_t t = 0; t < size_t(kPathTypes); ++t) {
            type[t].add(double(luminance(light[t])));
            all += double(luminance(light[t]));
        }
        sum.add(all);
    }
};

/// Of `count` independent samples, spread evenly over `points`.
inline TypeMeans trace_paths(const Viewed& view, const std::vector<ShadingPoint>& points, size_t count, uint64_t seed) {
    std::vector<LightByType> light(count, LightByType{});
    constexpr size_t kBatch = 1024;
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, kBatch), [&](const tbb::blocked_range<size_t>& range) {
        std::vector<ShadingPoint> batch;
        std::vector<Sampler> samplers;
        for (size_t i = range.begin(); i < range.end(); ++i) {
            batch.push_back(points[i % points.size()]);
            samplers.push_back({hash(seed, i), 0});
        }
        const std::span<LightByType> to(&light[range.begin()], range.size());
        PathTracer()(view.scene, view.prepared, view.plan, view.options, batch, samplers, to);
    });
    TypeMeans means;
    for (const LightByType& one : light) means.add(one);
    return means;
}

/// The same light by the plain path tracer.
inline Mean trace_plainly(const Viewed& view, const std::vector<ShadingPoint>& points, size_t count, uint64_t seed,
                          PlainSky sky = PlainSky::met) {
    const PlainPathTracer tracer(view.scene, view.prepared, view.options.scattering, sky);
    std::vector<double> light(count);
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
        light[i] = double(luminance(tracer.sample(points[i % points.size()], hash(seed, i))));
    });
    Mean mean;
    for (const double one : light) mean.add(one);
    return mean;
}

}  // namespace tress::test
