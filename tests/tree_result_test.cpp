// SPDX-License-Identifier: MIT
// Results of made-up trees, and what is said of them.
#include "tools/study/accel/tree_result.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/error.h"
#include "tools/study/accel/tree_plots.h"
#include "tools/study/accel/tree_spread.h"

using namespace tress;

namespace {

constexpr double kStepCost = 20;  // the default accel.traversal_cost

/// A tree whose rays take `steps` and `tests`, so many million a second in each round.
MeasuredTree made(const TreeRow& row, double steps, double tests, const std::vector<double>& rates) {
    MeasuredTree tree{row, {}};
    for (const double rate : rates) {
        const Json rays{{"mrays_per_second", rate}, {"steps", steps}, {"leaves", 2}, {"tests", tests}};
        tree.runs.push_back({{"build_seconds", rate},
                             {"statistics", {{"bytes", 1000}, {"sah_steps", steps}, {"sah_tests", tests}}},
                             {"rates", {{"primary", rays}, {"gather", rays}}}});
    }
    return tree;
}

MeasuredTree refused(const TreeRow& row) { return {row, {{{"refused", "kd-tree: would take more"}}}}; }

std::vector<Json> results(const std::vector<MeasuredTree>& trees) { return tree_results(trees, {Options{}, 10}, 2); }

}  // namespace

TEST_CASE("a row has the middle of its rounds, costs at the scene's step, and times of the first row") {
    const std::vector<TreeRow> rows = tree_rows({"accel.traversal_cost=5"}, {}, false);
    REQUIRE(rows.size() == 2);
    const std::vector<Json> r = results({made(rows[0], 10, 50, {4, 1, 2}), made(rows[1], 20, 30, {0.5})});
    CHECK(r[0]["row"] == "the scene's own");
    CHECK(r[1]["row"] == "traversal_cost=5");
    CHECK(r[1]["accel"]["accel.traversal_cost"] == "5");
    CHECK(r[0]["rays"]["primary"]["mrays_per_second"] == 2);
    CHECK(r[0]["rays"]["primary"]["lowest"] == 1);
    CHECK(r[0]["rays"]["primary"]["highest"] == 4);
    CHECK(r[0]["rays"]["primary"]["microseconds"] == 1);  // two threads, two million a second
    CHECK(r[0]["build_seconds"] == 2);
    CHECK(r[0]["statistics"]["bytes_per_segment"] == 100);
    CHECK(r[0]["times_as_fast"] == 1);
    CHECK(r[1]["sah_cost"] == 20 * kStepCost + 30);  // not at 5: rows are told by one measure
    CHECK(r[1]["rays"]["gather"]["cost"] == 20 * kStepCost + 30);
    CHECK(r[1]["rays"]["gather"]["times_as_fast"] == 0.25);
    CHECK(r[1]["times_as_fast"].get<double>() == doctest::Approx(0.25));
}

TEST_CASE("the spread names best and worst, at any depth and at the usual one, and how costs order them") {
    const std::vector<TreeRow> rows =
        tree_rows({"accel.bins=4", "accel.clip=false", "accel.depth_base=3 accel.depth_factor=0"}, {}, false);
    REQUIRE(rows.size() == 4);
    const std::vector<Json> r = results({made(rows[0], 10, 10, {1}), made(rows[1], 5, 10, {2}),
                                         made(rows[2], 20, 10, {0.5}), made(rows[3], 1, 1e6, {0.001})});
    const Json s = tree_spread(r);
    CHECK(s["trees"] == 4);
    CHECK(s["best"] == "bins=4");
    CHECK(s["worst"] == "depth_base=3, depth_factor=0");
    const Json& primary = s["rays"]["primary"];
    CHECK(primary["ratio"].get<double>() == doctest::Approx(2000));
    CHECK(primary["orders"].get<double>() == doctest::Approx(std::log10(2000)));
    CHECK(primary["ratio_at_depth"].get<double>() == doctest::Approx(4));
    CHECK(primary["predicted_correlation"].get<double>() == doctest::Approx(1));
    const std::string text = s["text"];
    CHECK(text.find("2000 (primary) and 2000 (gather)") != std::string::npos);
    CHECK(text.find("so do these") != std::string::npos);
    CHECK(text.find("it is 4.00 (primary)") != std::string::npos);
    CHECK(text.find("Fastest over all is bins=4: 2.00 times") != std::string::npos);
}

TEST_CASE("trees that are too large are counted and left out") {
    const std::vector<TreeRow> rows = tree_rows({"accel.bins=4", "accel.bins=8"}, {}, false);
    const Json s = tree_spread(results({made(rows[0], 10, 10, {1}), refused(rows[1]), made(rows[2], 9, 9, {2})}));
    CHECK(s["trees"] == 2);
    CHECK(s["refused"] == 1);
    CHECK(s["rays"]["primary"]["ratio"] == 2);
    CHECK(s["rays"]["primary"]["predicted_correlation"].is_null());  // of two trees
    CHECK(tree_spread(results({refused(rows[0])}))["text"].get<std::string>().starts_with("No tree"));
}

TEST_CASE("where the scene's own tree is too large, others are still told apart") {
    const std::vector<TreeRow> rows = tree_rows({"accel.bins=4", "accel.bins=8"}, {}, false);
    const Json s = tree_spread(results({refused(rows[0]), made(rows[1], 10, 10, {1}), made(rows[2], 9, 9, {2})}));
    CHECK(s["rays"]["gather"]["ratio"] == 2);
}

TEST_CASE("the list goes through every option of accel") {
    for (Options options; const OptionField& field : option_fields(options)) {
        if (!field.key.starts_with("accel.") || field.key == "accel.exact_below") continue;
        CAPTURE(field.key);
        bool found = false;
        for (const TreeRow& row : tree_rows({}, {}, false))
            for (const std::string& setting : row.settings) found |= setting.starts_with(field.key + "=");
        CHECK(found);
    }
}

TEST_CASE("rows are crossed with the grid, each once, and nothing but accel is taken") {
    CHECK(tree_rows({}, {"accel.bins=4,8", "accel.clip=true,false"}, false).size() == 5);
    CHECK(tree_rows({"accel.bins=4", "accel.bins=4"}, {"accel.clip=true,false"}, true).size() == 3);
    CHECK_THROWS_AS(tree_rows({"type1=ray"}, {}, false), InputError);
    CHECK_THROWS_AS(tree_rows({""}, {}, false), InputError);
    CHECK_THROWS_AS(tree_rows({"accel.bins"}, {}, false), InputError);
    CHECK_THROWS_AS(tree_rows({"accel.bins=1"}, {}, false), InputError);
    CHECK_THROWS_AS(tree_rows({}, {"gather.rays=1,2"}, false), InputError);
}

TEST_CASE("an option with three numbers has a plot, along which nothing else changes") {
    const std::vector<TreeRow> rows = tree_rows({}, {"accel.bins=4,8", "accel.clip=true,false"}, false);
    std::vector<MeasuredTree> trees;
    for (const TreeRow& row : rows) trees.push_back(made(row, 1, 1, {1}));
    const std::vector<PagePlot> plots = tree_plots(results(trees));
    REQUIRE(plots.size() == 3);
    CHECK(plots[2].file == "accel.bins.svg");
    const std::vector<PlotSeries>& series = plots[2].plot.series;  // bins 4, 8, 32 with clip; without it only two
    REQUIRE(series.size() == 2);
    REQUIRE(series[0].points.size() == 3);
    CHECK(series[0].points[2].x == 32);
}
