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
constexpr float kStep = 1 / 16.0f;   // of the gap's share, to see what it does near the best
constexpr double kLeastRise = 1e-5;  // of the light, by that step: less is rounding

Luminances by_rays(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials) {
    Luminances found(trials.size());
    tbb::parallel_for(size_t(0), trials.size(), [&](size_t i) {
        const LightTrial& t = trials[i];
        RayBuffer rays;
        for (const SeenLight& light : t.seen)
            rays.add(t.point.position, light.direction, light.distance, t.point.excluded);
        std::vector<Rgb> through(rays.size());
        through_hair(prepared, rays, options, through);
        Rgb sum(0);
        for (size_t k = 0; k < t.seen.size(); ++k) sum += t.seen[k].radiance * through[k];
        found[i] = double(luminance(sum));
    });
    return found;
}

/// With each of some shares of gaps.
template <size_t n>
std::array<Luminances, n> by_projection(const PreparedScene& prepared, const Options& options,
                                        std::span<const LightTrial> trials, const std::array<GapShares, n>& shares) {
    std::array<Luminances, n> found;
    for (Luminances& light : found) light.resize(trials.size());
    tbb::parallel_for(size_t(0), trials.size(), [&](size_t i) {
        const LightTrial& t = trials[i];
        if (t.seen.empty()) return;
        LightThroughCells cells;
        cells.project(prepared, t.point, t.probe ? &*t.probe : nullptr, hash(kKey, i), options.isa);
        for (size_t k = 0; k < n; ++k)
            found[k][i] = double(luminance(cells.light(prepared, t.seen, shares[k], options.isa)));
    });
    return found;
}

/// There is some light by rays.
ProjectionError error_of(const Luminances& test, const Luminances& truth) {
    double squares = 0;
    for (size_t i = 0; i < truth.size(); ++i) squares += square(test[i] - truth[i]);
    const double all = total(truth);
    return {std::sqrt(squares * double(truth.size())) / all, (total(test) - all) / all, int(truth.size())};
}

/// Fits light as if it were linear in the shares; what it is not, the gap's share then makes up for.
GapShares found_shares(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials,
                       const Luminances& truth) {
    GapShares shares = fit_gaps(truth, by_projection(prepared, options, trials, kTriedGaps));
    const std::array near =
        by_projection(prepared, options, trials, std::array{shares, GapShares{shares.gap + kStep, shares.scatter}});
    const double rise = total(near[1]) - total(near[0]), missing = total(truth) - total(near[0]);
    if (rise > kLeastRise * total(truth))
        shares.gap = glm::clamp(shares.gap + kStep * float(missing / rise), kLeastGap, kMostGap);
    return shares;
}

/// As it is, where shares are given or no light tells more.
CellGap calibrated(const PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials,
                   CellGap gap) {
    const bool wanted = options.projection.gap < 0;
    if (wanted) gap.shares = kUsualGaps;
    const Luminances truth = by_rays(prepared, options, trials);
    if (!(total(truth) > 0)) return gap;
    if (wanted) gap.shares = found_shares(prepared, options, trials, truth);
    gap.error = error_of(by_projection(prepared, options, trials, std::array{gap.shares})[0], truth);
    return gap;
}

}  // namespace

void calibrate_gap(PreparedScene& prepared, const Options& options, const LightTrials& trials) {
    HairProjection& p = prepared.projection;
    p.at_hair = calibrated(prepared, options, trials.at_hair, p.at_hair);
    p.at_polygons = calibrated(prepared, options, trials.at_polygons, p.at_polygons);
    if (p.at_polygons.error.points == 0) p.at_polygons.shares = p.at_hair.shares;
}

}  // namespace tress
