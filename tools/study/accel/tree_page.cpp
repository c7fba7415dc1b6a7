// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_page.h"

#include "tools/number_text.h"
#include "tools/study/accel/tree_plots.h"
#include "tools/study/accel/tree_result.h"
#include "tools/study/study_scene.h"

namespace tress {
namespace {

const NumberFormat kPlain{}, kSeconds{1, 3, " s"}, kMegabytes{1e-6, 3, " MB"}, kTimes{1, 3, "×"}, kCorrelation{1, 2};
const char* const kRefused = "too large";

Table rays_table(const std::vector<Json>& rows) {
    const std::vector<std::string> sets = ray_sets(rows);
    Table t;
    t.id = "rays";
    t.heading = "Speed";
    t.caption =
        "Million rays a second of all threads together, the median over rounds; inner nodes stepped through and "
        "segments tested, a ray. Primary rays ask for the nearest hit; shadow rays, to the lights, and gather rays, up "
        "to the first polygon, for what the hair lets through. Over all: the geometric mean of the three, of how many "
        "times as many rays as in the first row's tree.";
    t.first_column = "accel";
    t.groups = {{"", 1}};
    t.columns = {{"over all", "times as fast as the first row"}};
    for (const std::string& set : sets) {
        t.groups.push_back({set, 4});
        t.columns.insert(t.columns.end(),
                         {{"million/s", ""}, {"times", "as the first row"}, {"steps", "a ray"}, {"tests", "a ray"}});
    }
    for (size_t i = 0; i < rows.size(); ++i) {
        const Json& row = rows[i];
        const auto cell = [&](const std::string& pointer, const NumberFormat& format) {
            return NumberCell{"row." + std::to_string(i), &row, pointer, format, kRefused};
        };
        std::vector<NumberCell> cells{cell("/times_as_fast", kTimes)};
        for (const std::string& set : sets)
            for (const auto& [figure, format] : {std::pair{"mrays_per_second", kPlain},
                                                 {"times_as_fast", kTimes},
                                                 {"steps", kPlain},
                                                 {"tests", kPlain}})
                cells.push_back(cell("/rays/" + set + "/" + figure, format));
        t.rows.push_back({row["row"], std::move(cells)});
    }
    mark_best(t, 0, false);
    for (size_t set = 0; set < sets.size(); ++set) mark_best(t, 1 + 4 * set, false);
    return t;
}

Table trees_table(const std::vector<Json>& rows) {
    struct Figure {
        const char *pointer, *name, *title;
        NumberFormat format;
    };
    const Figure figures[] = {
        {"/build_seconds", "build", "median over rounds", kSeconds},
        {"/statistics/bytes", "memory", "of nodes and leaves", kMegabytes},
        {"/statistics/bytes_per_segment", "bytes a segment", "", kPlain},
        {"/statistics/references_per_segment", "references a segment", "leaves that a segment is in", kPlain},
        {"/statistics/references_per_leaf", "references a leaf", "of leaves that are not empty", kPlain},
        {"/statistics/leaves", "leaves", "", kPlain},
        {"/statistics/depth", "depth", "", kPlain},
        {"/statistics/sah_steps", "expected steps", "of a ray that nothing stops", kPlain},
        {"/statistics/sah_tests", "expected tests", "of a ray that nothing stops", kPlain},
        {"/sah_cost", "predicted cost", "in tests, steps at the scene's own accel.traversal_cost", kPlain}};
    Table t;
    t.id = "trees";
    t.heading = "The trees";
    t.caption =
        "Expected figures are those of the surface area heuristic, for a ray through the hair's box that nothing "
        "stops. The predicted cost is steps × the scene's own accel.traversal_cost + tests, whatever cost a row "
        "builds its tree by.";
    t.first_column = "accel";
    for (const Figure& f : figures) t.columns.push_back({f.name, f.title});
    for (size_t i = 0; i < rows.size(); ++i) {
        std::vector<NumberCell> cells;
        for (const Figure& f : figures)
            cells.push_back({"row." + std::to_string(i), &rows[i], f.pointer, f.format, kRefused});
        t.rows.push_back({rows[i]["row"], std::move(cells)});
    }
    mark_best(t, 0, true);
    mark_best(t, 1, true);
    mark_best(t, std::size(figures) - 1, true);
    return t;
}

Table spread_table(const Json& spread) {
    Table t;
    t.id = "spread";
    t.heading = "Best against worst";
    t.caption =
        "Yuksel, Akleman and Keyser (2007, section 4.1) found that the parameters of the tree bring “more than two "
        "orders of magnitude”. Correlations are Spearman's, of ranks: 1 where a cost puts all trees in the order of "
        "their time a ray.";
    t.first_column = "rays";
    t.columns = {{"best", "million rays a second"},
                 {"worst", "million rays a second"},
                 {"times", "best over worst"},
                 {"orders of magnitude", ""},
                 {"times, depth alike", "of trees whose limit of depth is the first row's"},
                 {"correlation, predicted", "of the cost that is predicted with time a ray"},
                 {"correlation, counted", "of the cost of steps and tests as counted with time a ray"}};
    for (const auto& [set, unused] : spread["rays"].items()) {
        const std::string place = "/rays/" + set + "/";
        TableRow row{set, {}};
        for (const auto& [figure, format] : {std::pair{"most", kPlain},
                                             {"least", kPlain},
                                             {"ratio", kTimes},
                                             {"orders", kCorrelation},
                                             {"ratio_at_depth", kTimes},
                                             {"predicted_correlation", kCorrelation},
                                             {"counted_correlation", kCorrelation}})
            row.cells.push_back({"spread.0", &spread, place + figure, format});
        t.rows.push_back(std::move(row));
    }
    return t;
}

}  // namespace

Page make_tree_page(const Json& header, const std::vector<Json>& rows, const Json& spread) {
    Page page;
    page.title = "The tree of hair: options and speed";
    page.facts = facts(header);
    std::string rays;
    for (const auto& [set, count] : header["rays"].items())
        rays += (rays.empty() ? "" : ", ") + grouped(count.get<unsigned long long>()) + " " + set;
    const int rounds = header["rounds"];
    page.facts.push_back("rays of a render: " + (rays.empty() ? "none" : rays) + "; " +
                         duration(header["seconds_a_set"]) + " a set, " +
                         (rounds == 1 ? "one round" : std::to_string(rounds) + " rounds"));
    page.verdict = escape_html(spread["text"]);
    page.tables = {spread_table(spread), rays_table(rows), trees_table(rows)};
    page.plots = tree_plots(rows);
    return page;
}

}  // namespace tress
