// SPDX-License-Identifier: MIT
#include "gather/projection/calibrate_gap.h"

#include <tbb/parallel_for.h>

#include "core/rng.h"
#include "gather/projection/light_through_cells.h"
#include "gather/visibility.h"

namespace tress {
namespace {

constexpr uint64_t kKey = hash(0, 0x676170);
constexpr float kLeastGap = -1, kMostGap = 4;  // below 0: fibers side by side, which hide less of each other
constexpr float kUsualGap = 1;                 // where no hair is seen: about what is right for hair everywhere

using Means = std::vector<double>;  // luminance that leaves each point

/// light(trial, its index) is what leaves the point.
template <class Light>
Means means_of(std::span<const LightTrial> trials, const Light& light) {
    Means means(trials.size());
    tbb::parallel_for(size_t(0), means.size(), [&](size_t i) { means[i] = double(luminance(light(trials[i], i))); });
    return means;
}

Means by_rays(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials) {
    return means_of(trials, [&](const LightTrial& t, size_t) {
        RayBuffer rays;
        for (const SeenLight& light : t.seen)
            rays.add(t.point.position, light.direction, light.distance, t.point.excluded);
        std::vector<Rgb> through(rays.size());
        through_hair(prepared, rays, options, through);
        Rgb sum(0);
        for (size_t i = 0; i < t.seen.size(); ++i) sum += t.seen[i].radiance * through[i];
        return sum;
    });
}

Means by_projection(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials) {
    return means_of(trials, [&](const LightTrial& t, size_t i) {
        LightThroughCells through_cells;
        return through_cells(prepared, t.point, t.probe ? &*t.probe : nullptr, t.seen, hash(kKey, i), options.isa);
    });
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

/// `gap` is the one that trials with this projection see.
void calibrate(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials,
               CellGap& gap) {
    const bool wanted = options.projection.gap < 0;
    if (wanted) gap.share = kUsualGap;
    if (trials.empty()) return;
    const Means truth = by_rays(prepared, options, trials);
    gap.error = error_of(by_projection(prepared, options, trials), truth);
    if (!wanted) return;
    gap.share = 0;
    const double without = error_of(by_projection(prepared, options, trials), truth).bias;
    const double slope = (gap.error.bias - without) / double(kUsualGap);  // bias is nearly linear in the gap
    gap.share = slope > 0 ? glm::clamp(float(-without / slope), kLeastGap, kMostGap) : 0.0f;
    gap.error = error_of(by_projection(prepared, options, trials), truth);
}

}  // namespace

void calibrate_gap(PreparedScene& prepared, const Options& options, const LightTrials& trials) {
    calibrate(prepared, options, trials.at_hair, prepared.projection.at_hair);
    calibrate(prepared, options, trials.at_polygons, prepared.projection.at_polygons);
    if (trials.at_polygons.empty()) prepared.projection.at_polygons.share = prepared.projection.at_hair.share;
}

}  // namespace tress
