// SPDX-License-Identifier: MIT
#include "gather/projection/calibrate_gap.h"

#include <tbb/parallel_for.h>

#include <array>

#include "core/rng.h"
#include "gather/projection/gap_fit.h"
#include "gather/projection/light_through_cells.h"
#include "gather/visibility.h"

namespace tress {
namespace {

constexpr uint64_t kKey = hash(0, 0x676170);
constexpr float kStep = 1 / 16.0f;  // of the gap's share, to see what it does near the best

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

/// With each of some shares of gaps.
template <size_t n>
std::array<Means, n> by_projection(const PreparedScene& prepared, const Options& options,
                                   std::span<const LightTrial> trials, const std::array<GapShares, n>& shares) {
    std::array<Means, n> means;
    for (size_t k = 1; k < n; ++k) means[k].resize(trials.size());
    means[0] = means_of(trials, [&](const LightTrial& t, size_t i) {
        LightThroughCells through_cells;
        const LightProbe* probe = t.probe ? &*t.probe : nullptr;
        through_cells(prepared, t.point, probe, t.seen, hash(kKey, i), options.isa);
        const auto with = [&](size_t k) { return through_cells.with_gaps(prepared, t.seen, shares[k], options.isa); };
        for (size_t k = 1; k < n; ++k) means[k][i] = double(luminance(with(k)));
        return with(0);
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

/// Sets the shares so that rays say the same of the mean, and says what error is left.
void fit(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials, const Means& truth,
         CellGap& gap) {
    gap.shares = fit_gaps(truth, by_projection(prepared, options, trials, kTriedGaps));
    const std::array near = by_projection(
        prepared, options, trials, std::array{gap.shares, GapShares{gap.shares.gap + kStep, gap.shares.scatter}});
    const double rise = sum(near[1]) - sum(near[0]);
    float steps = rise > 0 ? float((sum(truth) - sum(near[0])) / rise) : 0;
    steps = (glm::clamp(gap.shares.gap + steps * kStep, kLeastGap, kMostGap) - gap.shares.gap) / kStep;
    gap.shares.gap += steps * kStep;
    Means found = near[0];
    for (size_t i = 0; i < found.size(); ++i) found[i] += double(steps) * (near[1][i] - near[0][i]);
    gap.error = error_of(found, truth);
}

/// `gap` is the one that trials with this projection see.
void calibrate(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials,
               CellGap& gap) {
    const bool wanted = options.projection.gap < 0;
    if (wanted) gap.shares = kUsualGaps;
    if (trials.empty()) return;
    const Means truth = by_rays(prepared, options, trials);
    if (wanted)
        fit(prepared, options, trials, truth, gap);
    else
        gap.error = error_of(by_projection(prepared, options, trials, std::array{gap.shares})[0], truth);
}

}  // namespace

void calibrate_gap(PreparedScene& prepared, const Options& options, const LightTrials& trials) {
    calibrate(prepared, options, trials.at_hair, prepared.projection.at_hair);
    calibrate(prepared, options, trials.at_polygons, prepared.projection.at_polygons);
    if (trials.at_polygons.empty()) prepared.projection.at_polygons.shares = prepared.projection.at_hair.shares;
}

}  // namespace tress
