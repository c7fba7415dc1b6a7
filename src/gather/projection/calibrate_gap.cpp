// SPDX-License-Identifier: MIT
#include "gather/projection/calibrate_gap.h"

#include <tbb/parallel_for.h>

#include "core/rng.h"
#include "gather/projection/viewpoints.h"
#include "gather/seen_points.h"
#include "gather/visibility.h"

namespace tress {
namespace {

constexpr size_t kPoints = 64;
constexpr uint32_t kTruthCells = 1024;  // a hemisphere, a ray each
constexpr uint64_t kKey = hash(0, 0x676170);
constexpr float kMostGap = 4;
constexpr float kUsualGap = 1;  // where no hair is seen: about what is right for hair everywhere

using Means = std::vector<double>;  // of transmittance over the sphere, one a point, mean of channels

Means by_rays(const PreparedScene& prepared, const Options& options, const std::vector<ShadingPoint>& points) {
    const Igloo igloo = make_igloo(kTruthCells);
    Means means(points.size());
    tbb::parallel_for(size_t(0), points.size(), [&](size_t i) {
        RayBuffer rays;
        for (uint32_t cell = 0; cell < igloo.cells_of(Dome::sphere); ++cell) {
            const uint64_t key = hash(hash(kKey, i), cell);
            const float u = random(key, 0), v = random(key, 1);
            rays.add(points[i].position, direction_in(igloo, cell, {u, v}), kInfinity, points[i].excluded);
        }
        std::vector<Rgb> through(rays.size());
        through_hair(prepared, rays, options, through);
        for (const Rgb& t : through) means[i] += double(mean(t)) / double(through.size());
    });
    return means;
}

Means by_projection(const PreparedScene& prepared, const Options& options, const std::vector<ShadingPoint>& points) {
    Means means(points.size());
    tbb::parallel_for(size_t(0), points.size(), [&](size_t i) {
        ProjectionScratch scratch;
        CellLight light;
        project(prepared.projection, prepared.segments, viewpoint_of(points[i], hash(kKey, i)), unseen_from(points[i]),
                options.isa, scratch, light);
        for (uint32_t cell = 0; cell < light.cells; ++cell)
            means[i] += double(mean(light.transmittance(cell))) / double(light.cells);
    });
    return means;
}

ProjectionError error_of(const Means& test, const Means& truth) {
    ProjectionError e;
    double squares = 0, sum = 0;
    for (size_t i = 0; i < truth.size(); ++i) {
        squares += square(test[i] - truth[i]);
        e.bias += test[i] - truth[i];
        sum += truth[i];
    }
    e.points = int(truth.size());
    if (!(sum > 0)) return e;
    e.bias /= sum;
    e.rms = std::sqrt(squares * double(truth.size())) / sum;
    return e;
}

std::vector<ShadingPoint> some_points(const Scene& scene, const PreparedScene& prepared, const Options& options) {
    const std::vector<ShadingPoint> seen = find_seen_points(scene, prepared, options);
    std::vector<ShadingPoint> some;
    const size_t count = std::min(seen.size(), kPoints);
    for (size_t i = 0; i < count; ++i) some.push_back(seen[i * seen.size() / count]);
    return some;
}

}  // namespace

void calibrate_gap(const Scene& scene, PreparedScene& prepared, const Options& options) {
    HairProjection& projection = prepared.projection;
    float& gap = projection.options.gap;
    const bool wanted = gap < 0;
    const std::vector<ShadingPoint> points = some_points(scene, prepared, options);
    if (wanted) gap = kUsualGap;
    if (points.empty()) return;
    const Means truth = by_rays(prepared, options, points);
    ProjectionError found = error_of(by_projection(prepared, options, points), truth);
    if (wanted) {
        gap = 0;
        const double without = error_of(by_projection(prepared, options, points), truth).bias;
        const double slope = (found.bias - without) / double(kUsualGap);  // bias is nearly linear in the gap
        gap = slope > 0 ? glm::clamp(float(-without / slope), 0.0f, kMostGap) : 0.0f;
        found = error_of(by_projection(prepared, options, points), truth);
    }
    projection.error = found;
}

}  // namespace tress
