// SPDX-License-Identifier: MIT
#include "core/type_shares.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace tress;

namespace {

Plan plan_of(const TypeSet& types) {
    Plan plan;
    plan.types = types;
    return plan;
}

/// One sample of grey light a type.
FilmSample grey(const PerType<float>& light) {
    FilmSample sample;
    for (size_t t = 0; t < light.size(); ++t) sample.light[t] = Rgb(light[t]);
    return sample;
}

}  // namespace

TEST_CASE("every path is of one type: D or I, by the number of reflections") {
    for (int r = 0; r < 5; ++r) {
        CHECK(path_type(LightSource::lamp, r) == (r == 0   ? PathType::type1
                                                  : r == 1 ? PathType::type3
                                                           : PathType::type4));
        CHECK(path_type(LightSource::elsewhere, r) == (r == 0 ? PathType::type2 : PathType::type5));
    }
}

TEST_CASE("shares are the mean luminance of each type over all pixels and sum to 100 percent") {
    Film film = make_film(2, 1, plan_of({true, true, false, true, false}));
    add(film, 0, grey({3, 1, 0, 0, 0}));
    add(film, 1, grey({1, 1, 0, 2, 0}));
    const std::vector<TypeShare> shares = type_shares(film, ShareOf::picture);
    REQUIRE(shares.size() == 3);
    const double means[] = {2, 1, 1};
    for (size_t i = 0; i < 3; ++i) {
        CHECK(shares[i].mean == doctest::Approx(means[i]).epsilon(1e-6));  // weights of luminance sum to 1 in float
        CHECK(shares[i].percent == doctest::Approx(means[i] / 4 * 100).epsilon(1e-6));
        CHECK(shares[i].mean_error == 0);  // one sample says nothing of its spread
    }
    CHECK(shares[2].type == PathType::type4);
}

TEST_CASE("on hair, a pixel counts by how much of it hair covers") {
    Film film = make_film(2, 1, plan_of({true, true, false, false, false}));
    FilmSample on_hair = grey({1, 3, 0, 0, 0}), beside = grey({8, 0, 0, 0, 0});
    on_hair.hit = on_hair.on_hair = beside.hit = true;
    add(film, 0, on_hair);
    add(film, 1, beside);
    const std::vector<TypeShare> shares = type_shares(film, ShareOf::hair);
    CHECK(shares[0].percent == doctest::Approx(25));
    CHECK(shares[1].mean == doctest::Approx(3));
    for (const TypeShare& share : type_shares(make_film(1, 1, plan_of({true, true, true, true, true})), ShareOf::hair))
        CHECK(share.mean == 0);
}

TEST_CASE("the standard error of a mean is that of independent samples") {
    // 64 pixels x 256 samples, uniform in [0, 1): variance 1/12 each.
    const int pixels = 64, samples = 256;
    Film film = make_film(pixels, 1, plan_of({true, false, true, false, false}));
    for (int p = 0; p < pixels; ++p)
        for (int s = 0; s < samples; ++s) add(film, size_t(p), grey({random(uint64_t(p), uint64_t(s)), 0, 1, 0, 0}));
    const std::vector<TypeShare> shares = type_shares(film, ShareOf::picture);
    const double expected = std::sqrt(1.0 / 12 / (pixels * samples));
    // The estimate of a variance from n uniform samples is off by sqrt(0.8 / n) of itself: 0.7 %; half of it in the
    // root.
    CHECK(shares[0].mean_error == doctest::Approx(expected).epsilon(0.02));
    CHECK(shares[1].mean_error == 0);
    CHECK(std::abs(shares[0].mean - 0.5) < 4 * expected);
    // d(m / (m + 1)) = dm / (m + 1)^2
    CHECK(shares[0].percent_error == doctest::Approx(100 * expected / square(1.5)).epsilon(0.05));
}

TEST_CASE("black types have no share and no NaN") {
    Film film = make_film(1, 1, plan_of({true, true, true, true, true}));
    for (const TypeShare& share : type_shares(film, ShareOf::picture)) CHECK(share.percent == 0);
    add(film, 0, FilmSample{});
    for (const TypeShare& share : type_shares(film, ShareOf::picture)) CHECK(share.percent == 0);
}
