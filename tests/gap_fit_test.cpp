// SPDX-License-Identifier: MIT
#include "gather/projection/gap_fit.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace tress;

namespace {

constexpr size_t kPoints = 256;

/// What points see through cells, and what a whole share of the gap and of scatter adds.
struct Points {
    Means without, gap, scatter;

    Means with(const GapShares& shares) const {
        Means light(kPoints);
        for (size_t i = 0; i < kPoints; ++i)
            light[i] = without[i] + double(shares.gap) * gap[i] + double(shares.scatter) * scatter[i];
        return light;
    }
    std::array<Means, 3> tried() const { return {with(kTriedGaps[0]), with(kTriedGaps[1]), with(kTriedGaps[2])}; }
};

/// `apart`: how far scatter is from being a fixed share of the gap.
Points some_points(double apart) {
    Points p;
    for (uint64_t i = 0; i < kPoints; ++i) {
        const auto u = [&](uint32_t k) { return double(random(hash(3, i), k)); };
        p.without.push_back(0.2 + 0.3 * u(0));
        p.gap.push_back(0.01 + 0.02 * u(1));
        p.scatter.push_back(-1.6 * p.gap.back() * (1 + apart * (u(2) - 0.5)));
    }
    return p;
}

/// Even noise of this standard deviation.
Means noisy(Means light, double deviation) {
    for (uint64_t i = 0; i < kPoints; ++i)
        light[i] += deviation * std::sqrt(12.0) * (double(random(hash(4, i), 0)) - 0.5);
    return light;
}

double rms(const Means& a, const Means& b) {
    double squares = 0;
    for (size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(squares / double(a.size()));
}

}  // namespace

TEST_CASE("shares that light was made with are found again") {
    const Points points = some_points(0.8);
    for (const GapShares& shares :
         {GapShares{0, 0}, GapShares{1.5f, 0.5f}, GapShares{2.5f, 1.25f}, GapShares{-0.5f, 0}}) {
        CAPTURE(shares.gap);
        const GapShares found = fit_gaps(points.with(shares), points.tried());
        CHECK(found.gap == doctest::Approx(double(shares.gap)).epsilon(1e-5));
        CHECK(found.scatter == doctest::Approx(double(shares.scatter)).epsilon(1e-5));
    }
}

TEST_CASE("whatever points see, there is no bias, and no more error than with the best share of the gap alone") {
    for (const double apart : {0.0, 0.3, 2.0})
        for (const double noise : {0.0, 0.001, 0.01}) {
            CAPTURE(apart);
            CAPTURE(noise);
            const Points points = some_points(apart);
            const Means truth = noisy(points.with({1.2f, 0.6f}), noise);
            const Means found = points.with(fit_gaps(truth, points.tried()));
            CHECK(sum(found) == doctest::Approx(sum(truth)).epsilon(1e-6));
            const float alone = float((sum(truth) - sum(points.without)) / sum(points.gap));
            // No scatter is two spreads from the usual, by which squares may outdo the least by four of one point.
            CHECK(rms(found, truth) < rms(points.with({alone, 0}), truth) * (1 + 2.0 / kPoints) + 1e-7);
        }
}

TEST_CASE("where scatter cannot be told from the gap, or noise hides it, it is what hair usually has") {
    const Points same = some_points(0), apart = some_points(0.3);
    CHECK(fit_gaps(same.with({1, 0}), same.tried()).scatter == doctest::Approx(double(kUsualGaps.scatter)));
    const Means hidden = noisy(apart.with({3, 1.5f}), 0.2);
    // One deviation of what points tell is some 20 spreads: what is known has 400 times their weight.
    CHECK(std::abs(fit_gaps(hidden, apart.tried()).scatter - kUsualGaps.scatter) < 0.1f);
}

TEST_CASE("shares stay in range, and are none where cells do not differ or nothing is seen") {
    const Points points = some_points(0.8);
    for (const GapShares& shares : {GapShares{40, 0}, GapShares{-40, 0}, GapShares{40, 20}, GapShares{0, -20}}) {
        const GapShares found = fit_gaps(points.with(shares), points.tried());
        CHECK((found.gap >= kLeastGap && found.gap <= kMostGap));
        CHECK((found.scatter >= 0 && found.scatter < 10));
    }
    const Means even(kPoints, 0.5);
    for (const GapShares& found : {fit_gaps(even, {even, even, even}), fit_gaps({}, {})}) {
        CHECK(found.gap == 0);
        CHECK(found.scatter == 0);
    }
}
