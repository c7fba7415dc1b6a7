// SPDX-License-Identifier: MIT
#include "gather/paths/path_goals.h"

#include <doctest/doctest.h>

using namespace tress;

namespace {

PathGoals goals_for(std::initializer_list<PathType> types) {
    PathGoals goals;
    for (const PathType type : types) goals.wanted[size_t(index_of(type))] = true;
    goals.sky = goals.polygons = goals.reflections = true;
    return goals;
}

Throughput after(int reflections) {
    Throughput t;
    for (int k = 0; k < reflections; ++k) t = reflected(t);
    return t;
}

}  // namespace

TEST_CASE("a path is booked by its source and its events R up to the first surface, and by neither after it") {
    const PathGoals all =
        goals_for({PathType::type1, PathType::type2, PathType::type3, PathType::type4, PathType::type5});
    const auto type_of = [&](const Throughput& t, LightSource source) {
        LightByType light{};
        book(all, t, source, Rgb(1), light);
        int found = 0;
        for (int type = 0; type < kPathTypes; ++type) found += light[size_t(type)] == Rgb(1) ? type + 1 : 0;
        return found;
    };
    const int of_lamps[] = {1, 3, 4, 4};
    for (int k = 0; k < 4; ++k) {
        CAPTURE(k);
        const int elsewhere = k == 0 ? 2 : 5;
        CHECK(type_of(after(k), LightSource::lamp) == of_lamps[k]);
        CHECK(type_of(after(k), LightSource::elsewhere) == elsewhere);
        for (const Throughput& past : {settled(after(k)), reflected(settled(after(k))), settled(settled(after(k)))})
            for (const LightSource source : {LightSource::lamp, LightSource::elsewhere})
                CHECK(type_of(past, source) == elsewhere);
    }
}

TEST_CASE("an event of both kinds keeps all light, and counts what is reflected") {
    const Throughput once = scattered(after(0), Rgb(0.5f), Rgb(0.25f)), twice = scattered(once, Rgb(0.5f), Rgb(0.25f));
    CHECK(once.by == std::array{Rgb(0.5f), Rgb(0.25f), Rgb(0)});
    CHECK(twice.by == std::array{Rgb(0.25f), Rgb(0.25f), Rgb(0.0625f)});
    CHECK(scattered(settled(once), Rgb(0.5f), Rgb(0.25f)).by == std::array{Rgb(0.375f), Rgb(0.1875f), Rgb(0)});
}

TEST_CASE("paths end where no wanted type can follow") {
    PathGoals first = goals_for({PathType::type1});
    CHECK_FALSE(goes_on(first, after(0)));
    CHECK_FALSE(takes(first, after(0), LightSource::elsewhere));
    first.areas = true;  // one direction is followed, to meet the lamp
    CHECK(goes_on(first, after(0)));
    CHECK(still_wanted(first, after(1)).sum() == Rgb(0));
    CHECK(still_wanted(first, settled(after(0))).sum() == Rgb(0));

    const PathGoals third = goals_for({PathType::type3});
    CHECK_FALSE(takes(third, after(0), LightSource::lamp));
    CHECK(goes_on(third, after(0)));
    CHECK(takes(third, after(1), LightSource::lamp));
    CHECK_FALSE(goes_on(third, after(1)));
    CHECK(still_wanted(third, settled(after(1))).sum() == Rgb(0));

    const PathGoals second = goals_for({PathType::type2});
    CHECK(goes_on(second, after(0)));
    CHECK(goes_on(second, settled(after(0))));
    CHECK(still_wanted(second, after(1)).sum() == Rgb(0));
}

TEST_CASE("in the full model light of type 1 may come by any number of events F") {
    PathGoals first = goals_for({PathType::type1});
    first.forward = true;
    CHECK(goes_on(first, after(0)));
    CHECK_FALSE(goes_on(first, after(1)));
}
