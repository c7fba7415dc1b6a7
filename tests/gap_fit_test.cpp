// SPDX-License-Identifier: MIT
#include "gather/projection/gap_fit.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace tress;

namespace {

constexpr size_t kPoints = 256;

/// What points see through cells, and what a whole share of the gap and of scatter adds.
struct Points {
    Luminances without, gap, scatter;

    Luminances with(const GapShares& shares) const {
        Luminances light(kPoints);
        for (size_t i = 0; i < kPoints; ++i)
            light[i] = without[i] + double(shares.gap) * gap[i] + double(shares.scatter) * scatter[i];
        return light;
    }
    std::array<Luminances, 3> tried() const { return {with(kTriedGaps[0]), with(kTriedGaps[1]), with(kTriedGaps[2])}; }
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
Luminances noisy(Luminances light, double deviation) {
    for (uint64_t i = 0; i < kPoints; ++i)
        light[i] += deviation * std::sqrt(12.0) * (double(random(hash(4, i), 0)) - 0.5);
    return light;
}

double rms(const Luminances& a, const Luminances& b) {
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
        // What is known beforehand, at the least noise, weighs 1/300 of what these points tell.
        CHECK(found.gap == doctest::Approx(double(shares.gap)).epsilon(0.005));
        CHECK(found.scatter == doctest::Approx(double(shares.scatter)).epsilon(0.003));
    }
}

TEST_CASE("whatever points see, there is no bias, and no more error than with the best share of the gap alone") {
    for (const double apart : {0.0, 0.3, 2.0})
        for (const double noise : {0.0, 0.001, 0.01}) {
            CAPTURE(apart);
            CAPTURE(noise);
            const Points points = some_points(apart);
            const Luminances truth = noisy(points.with({1.2f, 0.6f}), noise);
            const Luminances found = points.with(fit_gaps(truth, points.tried()));
            CHECK(total(found) == doctest::Approx(total(truth)).epsilon(1e-6));
            const float alone = float((total(truth) - total(points.without)) / total(points.gap));
            // No scatter is two spreads from the usual: the sum of all squares may be more by 4 times the noise, which
            // is what a point is off by, or 0.5 % of a mean below 0.4.
            const double off = rms(points.with({alone, 0}), truth), least = std::max(off, 0.005 * 0.4);
            CHECK(rms(found, truth) <= std::sqrt(off * off + 4 * least * least / (kPoints - 2)));
        }
}

TEST_CASE("where points tell as much of scatter as is known beforehand, it lies half way") {
    // Light that the shares do not explain is +noise or -noise, two and two points; what scatter does, +effect or
    // -effect in turn, so that none of it looks like the other. Known: noise^2 / spread^2; told by points: points *
    // effect^2.
    const double noise = 0.01, effect = noise / (kScatterSpread * std::sqrt(double(kPoints)));
    Points points;
    Luminances rest;
    for (size_t i = 0; i < kPoints; ++i) {
        points.without.push_back(0.4);
        points.gap.push_back(0.05);
        points.scatter.push_back(i % 2 ? effect : -effect);
        rest.push_back(i % 4 < 2 ? noise : -noise);
    }
    Luminances truth = points.with({1, 1.5f});
    for (size_t i = 0; i < kPoints; ++i) truth[i] += rest[i];
    const double fitted = double(kPoints) / (double(kPoints) - 2);  // noise is of what two numbers leave
    const double half = (1.5 + fitted * double(kUsualGaps.scatter)) / (1 + fitted);
    CHECK(fit_gaps(truth, points.tried()).scatter == doctest::Approx(half).epsilon(1e-4));
}

TEST_CASE("where scatter cannot be told from the gap, or noise hides it, or points are few, it is about the usual") {
    const Points same = some_points(0), apart = some_points(0.3);
    CHECK(fit_gaps(same.with({1, 0}), same.tried()).scatter == doctest::Approx(double(kUsualGaps.scatter)));
    const Luminances hidden = noisy(apart.with({3, 1.5f}), 0.2);
    // One deviation of what points tell is some 20 spreads: what is known has 400 times their weight.
    CHECK(std::abs(fit_gaps(hidden, apart.tried()).scatter - kUsualGaps.scatter) < 0.1f);
    for (size_t few = 1; few < 4; ++few) {
        CAPTURE(few);
        const auto first = [&](Luminances light) {
            light.resize(few);
            return light;
        };
        const auto tried = apart.tried();
        const GapShares found = fit_gaps(first(noisy(apart.with({1.5f, 0.5f}), 0.0035)),
                                         {first(tried[0]), first(tried[1]), first(tried[2])});
        CHECK(std::abs(found.scatter - kUsualGaps.scatter) < kScatterSpread);
    }
}

TEST_CASE("shares stay in range, and are the usual ones where cells do not differ or nothing is seen") {
    const Points points = some_points(0.8);
    for (const GapShares& shares : {GapShares{40, 0}, GapShares{-40, 0}, GapShares{40, 20}, GapShares{0, -20}}) {
        const GapShares found = fit_gaps(points.with(shares), points.tried());
        CHECK((found.gap >= kLeastGap && found.gap <= kMostGap));
        CHECK((found.scatter >= 0 && found.scatter <= kMostScatter));
    }
    const Luminances even(kPoints, 0.5);
    for (const GapShares& found : {fit_gaps(even, {even, even, even}), fit_gaps({}, {})}) {
        CHECK(found.gap == kUsualGaps.gap);
        CHECK(found.scatter == kUsualGaps.scatter);
    }
}
