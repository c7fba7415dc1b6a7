// SPDX-License-Identifier: MIT
#include "tools/study/methods/study_row.h"

#include <doctest/doctest.h>

#include <set>

#include "core/error.h"
#include "tools/study/sweep.h"

using namespace tress;

TEST_CASE("the paper's six rows are there, in its order, by its names and with its times") {
    const std::vector<StudyRow> rows = paper_rows();
    REQUIRE(rows.size() == 6);
    const char* names[] = {"RT / RT / RT", "DSM / RT / RT+DSM", "RT / RT / –",
                           "DSM / RT / –", "RT / P / –",        "DSM / P / –"};
    const double seconds[] = {29631, 2145, 1586, 1545, 673, 765};  // 8:13:51, 35:45, 26:26, 25:45, 11:13, 12:45
    for (size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].name == names[i]);
        CHECK(rows[i].paper_seconds == seconds[i]);
    }
    const Options options = options_of(rows[1], {});
    CHECK(options.type1 == LampMethod::deep);
    CHECK(options.type2 == GatherMethod::ray);
    CHECK(options.type3 == CrossingMethod::ray_deep);
    CHECK(options_of(rows[4], {}).type3 == CrossingMethod::off);
}

TEST_CASE("all rows are all combinations but those of no type, each once") {
    std::set<std::string> names;
    for (const StudyRow& row : all_rows()) names.insert(row.name);
    CHECK(names.size() == all_rows().size());
    CHECK(names.size() == 5 * 3 * 5 - 1);  // methods of types 1, 2 and 3, off among them
    for (const StudyRow& row : paper_rows()) CHECK(names.count(row.name) == 1);
}

TEST_CASE("a row in words sets what it says and is named by it") {
    const StudyRow row = parse_row("OSM/P/- projection.cells=64  gather.rays=2");
    CHECK(row.name == "OSM / P / –, projection.cells=64, gather.rays=2");
    const Options options = options_of(row, {});
    CHECK(options.type1 == LampMethod::opacity);
    CHECK(options.projection.cells == 64);
    CHECK(options.gather.rays == 2);
    CHECK(parse_row("type1=deep type2=off").name == "DSM / – / RT");  // type 3: as it is by default
    CHECK(parse_row("gather.crossings=0").name == "gather.crossings=0");
    CHECK(parse_row("RT/RT/RT/PM/PT").name == "RT / RT / RT / PM / PT");
}

TEST_CASE("a row that is none is refused with what was expected") {
    CHECK_THROWS_WITH_AS(parse_row("RT/DSM/-"), doctest::Contains("'DSM' for type2, expected one of: –, RT, P"),
                         InputError);
    CHECK_THROWS_WITH_AS(parse_row(" "), doctest::Contains("empty row"), InputError);
    CHECK_THROWS_WITH_AS(parse_row("projection.cels=3"), doctest::Contains("projection.cells"), InputError);
    CHECK_THROWS_AS(parse_row("projection.cells=none"), InputError);
    CHECK_THROWS_AS(parse_row("RT/RT/-/-/-/-"), InputError);
}

TEST_CASE("a sweep is the grid of its values, over every row") {
    const auto points = grid({"accel.bins=8,32", "accel.clip=true,false"});
    REQUIRE(points.size() == 4);
    CHECK(points[1] == std::vector<std::string>{"accel.bins=8", "accel.clip=false"});
    CHECK(grid({}).size() == 1);
    const std::vector<StudyRow> rows = across(paper_rows(), points);
    CHECK(rows.size() == 24);
    CHECK(rows[1].name == "RT / RT / RT, accel.bins=8, accel.clip=false");
    CHECK(rows[1].paper_seconds == 0);  // the paper has no such row
    CHECK(across(paper_rows(), grid({}))[0].paper_seconds > 0);
    CHECK_THROWS_WITH_AS(grid({"accel.bins"}), doctest::Contains("expected key=value,value"), InputError);
    CHECK_THROWS_WITH_AS(grid({"accel.bins=8,many"}), doctest::Contains("many"), InputError);
}
