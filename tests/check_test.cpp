// SPDX-License-Identifier: MIT
// tress check itself: its rows are all there, and what a row measures decides what is said. The rows are tests of their
// own (check_D1 ...).
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/run_command.h"
#include "tools/check/check_report.h"
#include "tools/check/check_rows.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr int kRows = 47;

CheckedRow row_with(std::vector<Figure> figures) { return {{"D1", "case", "expected", nullptr}, {figures, {}}, {}, 0}; }

}  // namespace

TEST_CASE("there is a row of every number, in order, with a case and what it must give") {
    const std::vector<CheckRow> rows = check_rows();
    REQUIRE(rows.size() == kRows);
    for (size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i].id == "D" + std::to_string(i + 1));
        CHECK(std::string(rows[i].name).size() > 5);
        CHECK(std::string(rows[i].expected).size() > 5);
    }
}

TEST_CASE("a figure passes within its bound, ends included, and never where it is not a number") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(at_most("x", 1, 1).passes());
    CHECK_FALSE(at_most("x", 1.001, 1).passes());
    CHECK(at_least("x", 1, 1).passes());
    CHECK_FALSE(at_least("x", 0.999, 1).passes());
    CHECK(within("x", 1.5, 1, 0.5).passes());
    CHECK_FALSE(within("x", 1.6, 1, 0.5).passes());
    CHECK_FALSE(exactly("x", 1e-300, 0).passes());
    CHECK_FALSE(holds("x", false).passes());
    CHECK(told("x", 1e300).passes());
    for (const Figure& figure : {at_most("x", nan, 1), at_least("x", nan, 1), within("x", nan, 0, 1), told("x", nan)})
        CHECK_FALSE(figure.passes());
}

TEST_CASE("a row passes where it has figures and all of them pass; what throws or measures nothing fails") {
    CHECK(verdict(row_with({at_most("x", 1, 2)})) == Verdict::passed);
    CHECK(verdict(row_with({at_most("x", 1, 2), at_most("y", 3, 2)})) == Verdict::failed);
    CHECK(verdict(row_with({})) == Verdict::failed);
    CheckedRow thrown = row_with({at_most("x", 1, 2)});
    thrown.thrown = "no";
    CHECK(verdict(thrown) == Verdict::failed);
    CheckedRow beside = row_with({});
    beside.outcome.does_not_apply = "there is none";
    CHECK(verdict(beside) == Verdict::does_not_apply);
    CHECK(to_text(beside).find("there is none") != std::string::npos);
    CHECK(passes({"", "", "", 1, {row_with({at_most("x", 1, 2)}), beside}}));
    CHECK_FALSE(passes({"", "", "", 1, {thrown}}));
}

TEST_CASE("the table has a line a row, with each figure and its bound") {
    const std::string table =
        to_markdown({"cpu", "g++", "avx2", 2, {row_with({at_most("a", 1, 2, "%"), told("b", 3)})}});
    CHECK(table.find("| D1 | **case** expected | a: 1.00 %<br>b: 3.00 | at most 2.00 %<br>none | pass |") !=
          std::string::npos);
    CHECK(table.find("1 passed, 0 failed, 0 do not apply") != std::string::npos);
}

TEST_CASE("the command measures the rows asked for, as text or JSON, and refuses others") {
    const CommandResult text = run_tress({"check", "--only", "D17", "--only", "D39"});
    CHECK(text.exit_code == 0);
    CHECK(text.output.find("D17  pass") != std::string::npos);
    CHECK(text.output.find("2 passed, 0 failed") != std::string::npos);
    const CommandResult json = run_tress({"check", "--only", "D17", "--json", "--isa", "scalar", "--threads", "1"});
    const auto report = nlohmann::json::parse(json.output);
    CHECK(report["isa"] == "scalar");
    CHECK(report["pass"] == true);
    CHECK(report["rows"][0]["figures"][0]["pass"] == true);
    const CommandResult bad = run_tress({"check", "--only", "D99"});
    CHECK(bad.exit_code == 2);
    CHECK(bad.error.find("no row 'D99', expected one of D1 to D47") != std::string::npos);
}
