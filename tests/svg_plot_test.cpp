// SPDX-License-Identifier: MIT
#include "io/plot/svg_plot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

using namespace tress;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// No < or >, and each & begins a reference by number.
bool is_plain(const std::string& text) {
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '<' || text[i] == '>') return false;
        if (text[i] != '&') continue;
        const size_t end = text.find_first_not_of("0123456789", std::min(i + 2, text.size()));
        if (text.compare(i, 2, "&#") != 0 || end == std::string::npos || text[end] != ';' || end == i + 2) return false;
    }
    return true;
}

/// ` name="value"`s, each name once.
bool are_attributes(std::string text) {
    constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-";
    std::vector<std::string> names;
    while (!text.empty()) {
        const size_t equals = text.find_first_not_of(kLetters, 1);
        if (text[0] != ' ' || equals == std::string::npos || text.compare(equals, 2, "=\"") != 0) return false;
        const size_t quote = text.find('"', equals + 2);
        if (quote == std::string::npos || !is_plain(text.substr(equals, quote - equals))) return false;
        const std::string name = text.substr(1, equals - 1);
        if (std::find(names.begin(), names.end(), name) != names.end()) return false;
        names.push_back(name);
        text.erase(0, quote + 1);
    }
    return true;
}

/// One root; every tag is closed in its turn, attributes are quoted and named once, and no stray & or < is left.
bool is_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    size_t roots = 0;
    for (size_t at = 0; at < svg.size();) {
        const size_t start = std::min(svg.find('<', at), svg.size());
        if (!is_plain(svg.substr(at, start - at))) return false;
        if (start == svg.size()) break;
        const size_t end = svg.find('>', start);
        if (end == std::string::npos) return false;
        std::string tag = svg.substr(start + 1, end - start - 1);
        at = end + 1;
        if (tag[0] == '/') {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
            continue;
        }
        const bool is_empty = !tag.empty() && tag.back() == '/';
        if (is_empty) tag.pop_back();
        const std::string name = tag.substr(0, tag.find(' '));
        if (name.empty() || !are_attributes(tag.substr(name.size()))) return false;
        if (open.empty()) ++roots;
        if (!is_empty) open.push_back(name);
    }
    return open.empty() && roots == 1;
}

/// No number is "nan" or "inf", and none has more than two decimals outside the style.
bool has_sane_numbers(const std::string& svg) {
    if (svg.find("nan") != std::string::npos || svg.find("inf") != std::string::npos) return false;
    static const std::regex kAttribute(R"re( (?:x|y|d|width|height|transform)="([^"]*)")re");
    static const std::regex kThreeDecimals(R"(\.[0-9]{3}|e[+-]?[0-9])");
    for (std::sregex_iterator i(svg.begin(), svg.end(), kAttribute), end; i != end; ++i)
        if (std::regex_search((*i)[1].str(), kThreeDecimals)) return false;
    return true;
}

struct Place {
    double x, y;
};

std::vector<Place> marker_places(const std::string& svg) {
    static const std::regex kMark(R"re(translate\(([-0-9.]+) ([-0-9.]+)\))re");
    std::vector<Place> places;
    const std::string plotted = svg.substr(0, svg.find("<g class=\"legend"));
    for (std::sregex_iterator i(plotted.begin(), plotted.end(), kMark), end; i != end; ++i)
        places.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
    return places;
}

double view_height(const std::string& svg) {
    std::smatch match;
    REQUIRE(std::regex_search(svg, match, std::regex(R"re(viewBox="0 0 720 ([0-9]+)")re")));
    return std::stod(match[1]);
}

/// The heights of what starts with `pattern`'s match, whose first group is a y.
std::vector<double> heights(const std::string& svg, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<double> found;
    for (std::sregex_iterator i(svg.begin(), svg.end(), regex), end; i != end; ++i) found.push_back(std::stod((*i)[1]));
    return found;
}

Plot plot_of(std::vector<PlotPoint> points, bool log = true) {
    Plot plot{"Title", "across", "up", log, log, {}};
    plot.series.push_back({"a series", std::move(points), true, {}, {}});
    return plot;
}

Plot many_series(size_t n) {
    Plot plot{"Many", "x", "y", true, true, {}};
    for (size_t k = 0; k < n; ++k) {
        const double y = double(k + 1);
        plot.series.push_back({"a rather long name of a series, the one " + std::to_string(k),
                               {{1, y}, {10, y / 2, y / 3, y}, {100, y / 4}},
                               k % 2 == 0,
                               y / 5,
                               {{1, y}, {100, y / 4}}});
    }
    return plot;
}

void check_sound(const Plot& plot) {
    const std::string svg = svg_plot(plot);
    CHECK(is_well_formed(svg));
    CHECK(has_sane_numbers(svg));
    CHECK(svg == svg_plot(plot));
    for (size_t k = 0; k < plot.series.size(); ++k) CHECK(count(svg, "data-series=\"" + std::to_string(k) + '"') == 2);
    for (const Place& place : marker_places(svg)) {
        CHECK(place.x >= 0);
        CHECK(place.x <= 720);
        CHECK(place.y >= 0);
        CHECK(place.y <= view_height(svg));
    }
}

}  // namespace

TEST_CASE("the checker of well-formedness tells good from bad") {
    CHECK(is_well_formed("<a b=\"1\"><c/>x &#38; y</a>"));
    for (const char* bad : {"<a>", "<a></b>", "</a>", "<a/><a/>", "<a b=1/>", "<a>&</a>", "<a>&x;</a>", "<a>a>b</a>",
                            "<a b=\"1\" b=\"2\"/>", "<a b=\"x<y\"/>", "<a b=\"&\"/>", "<a <b/>"})
        CHECK_FALSE(is_well_formed(bad));
}

TEST_CASE("a plot is one well-formed document with all its series and legend entries, and the same each time") {
    for (size_t n : {0, 1, 6, 8, 9, 20, 40}) {
        const Plot plot = many_series(n);
        check_sound(plot);
        const std::string svg = svg_plot(plot);
        CHECK(count(svg, "<svg ") == 1);
        CHECK(count(svg, "<style>") == 1);
        CHECK(count(svg, "<g class=\"series s") == n);
        CHECK(count(svg, "<g class=\"legend s") == n);
        CHECK(count(svg, " id=") == 0);
    }
}

TEST_CASE("names and labels are escaped, and what XML cannot hold is dropped") {
    Plot plot = plot_of({{1, 1, 1, 1, "it's <1> & \"so\"\x01"}});
    plot.title = "<&\">";
    plot.x_label = plot.y_label = plot.series[0].name = "<&\"\n\x02 \xc3\xa9\xff\xed\xa0\x80";
    check_sound(plot);
    const std::string svg = svg_plot(plot);
    CHECK(svg.find("aria-label=\"&#60;&#38;&#34;&#62;\"") != std::string::npos);
    CHECK(svg.find("<title>it&#39;s &#60;1&#62; &#38; &#34;so&#34;</title>") != std::string::npos);
    CHECK(svg.find(">&#60;&#38;&#34; &#233;</text>") != std::string::npos);
    for (char c : svg) CHECK((c == '\n' || (c >= ' ' && c <= '~')));
}

TEST_CASE("hostile data leave no trace but sane numbers") {
    const std::vector<double> hostile = {kNan, kInf, -kInf, 0, -1, 1, 1e-300, 1e300, 5e-324, 1.7e308, -1.7e308};
    for (bool log : {false, true}) {
        Plot all = plot_of({}, log);
        for (double a : hostile) {
            for (double b : hostile) {
                Plot plot = plot_of({{a, b, b, a}, {1, 2, a, b}, {b, a}}, log);
                plot.series[0].floor = a;
                plot.series[0].curve = {{1, 1}, {a, b}, {b, a}, {2, 2}};
                check_sound(plot);
                check_sound(plot_of({{a, b}}, log));
                check_sound(plot_of({{1, a}, {2, b}}, log));
                all.series[0].points.push_back({a, b, b, a});
            }
        }
        check_sound(all);
        check_sound(plot_of({}, log));
    }
}

TEST_CASE("a plot says that there is no data when no point can be drawn, and only then") {
    const auto says_so = [](const Plot& plot) { return count(svg_plot(plot), ">no data<") == 1; };
    CHECK(says_so(Plot{}));
    CHECK(says_so(plot_of({})));
    CHECK(says_so(plot_of({{0, 1}, {1, -1}, {kNan, 1}})));
    CHECK_FALSE(says_so(plot_of({{0, 1}, {1, -1}}, false)));
    CHECK_FALSE(says_so(plot_of({{1, 1}})));
}

TEST_CASE("decades are equally long on logarithmic axes, equal steps on linear ones") {
    const auto logs = marker_places(svg_plot(plot_of({{1, 1000}, {10, 100}, {100, 10}})));
    const auto steps = marker_places(svg_plot(plot_of({{-5, -2}, {5, 3}, {15, 8}}, false)));
    constexpr double kRounding = 0.011;
    for (const auto& places : {logs, steps}) {
        REQUIRE(places.size() == 3);
        CHECK(std::abs((places[1].x - places[0].x) - (places[2].x - places[1].x)) < kRounding);
        CHECK(std::abs((places[1].y - places[0].y) - (places[2].y - places[1].y)) < kRounding);
        CHECK(places[1].x > places[0].x + 100);
    }
    CHECK(logs[1].y > logs[0].y + 100);
    CHECK(steps[1].y < steps[0].y - 100);
}

TEST_CASE("the data keep a margin of a twentieth of their span") {
    const std::string svg = svg_plot(plot_of({{1, 1}, {100, 1000}}));
    const auto places = marker_places(svg);
    std::smatch frame;
    REQUIRE(
        std::regex_search(svg, frame, std::regex(R"re(class="axis" d="M([0-9.]+) ([0-9.]+)V([0-9.]+)H([0-9.]+))re")));
    const double left = std::stod(frame[1]), top = std::stod(frame[2]), bottom = std::stod(frame[3]);
    const double right = std::stod(frame[4]), margin = 0.05 / 1.1;
    CHECK(places[0].x == doctest::Approx(left + margin * (right - left)).epsilon(1e-4));
    CHECK(places[1].x == doctest::Approx(right - margin * (right - left)).epsilon(1e-4));
    CHECK(places[0].y == doctest::Approx(bottom - margin * (bottom - top)).epsilon(1e-4));
    CHECK(places[1].y == doctest::Approx(top + margin * (bottom - top)).epsilon(1e-4));
}

TEST_CASE("a floor is drawn at its height unless it is below a tenth of all points of a logarithmic axis") {
    const auto floors = [](double floor, bool log) {
        Plot plot = plot_of({{1, 1}, {10, 0.1}}, log);
        plot.series[0].floor = floor;
        return heights(svg_plot(plot), R"re(class="floor" d="M[0-9.]+ ([0-9.]+)H)re");
    };
    CHECK(floors(0.01, true).size() == 1);
    CHECK(floors(0.0099, true).empty());
    CHECK(floors(0, true).empty());
    CHECK(floors(kNan, true).empty());
    CHECK(floors(-1, false).size() == 1);
    CHECK(floors(kInf, false).empty());
    Plot level = plot_of({{1, 1}, {10, 0.1}});
    const std::string without = svg_plot(level);
    level.series[0].floor = 1e-5;
    CHECK(svg_plot(level) == without);
    level.series[0].floor = 0.1;
    const auto at = heights(svg_plot(level), R"re(class="floor" d="M[0-9.]+ ([0-9.]+)H)re");
    REQUIRE(at.size() == 1);
    CHECK(at[0] == marker_places(svg_plot(level))[1].y);
}

TEST_CASE("a range is drawn as a bar, clipped at the bottom where it has no logarithm") {
    CHECK(count(svg_plot(plot_of({{1, 1}, {2, 2}})), "class=\"bar\"") == 0);
    const auto caps = [](double low, double high) {
        const std::string svg = svg_plot(plot_of({{1, 1, low, high}, {2, 10}}));
        std::smatch bar;
        return std::regex_search(svg, bar, std::regex(R"re(class="bar" d="([^"]*)")re")) ? count(bar[1], "h6") : 0;
    };
    CHECK(caps(0.5, 2) == 2);
    CHECK(caps(0, 2) == 1);
    CHECK(caps(-3, 2) == 1);
    CHECK(caps(kNan, kNan) == 0);
}

TEST_CASE("a curve is clipped to the plot") {
    Plot plot = plot_of({{1, 1}, {2, 2}}, false);
    plot.series[0].curve = {{-100, 1.5}, {100, 1.5}, {100, 50}, {1.5, 50}, {1.5, -50}};
    const std::string svg = svg_plot(plot);
    std::smatch curve;
    REQUIRE(std::regex_search(svg, curve, std::regex(R"re(class="curve" d="([^"]*)")re")));
    const std::string d = curve[1];
    CHECK(count(d, "M") == 2);
    CHECK(count(d, "L") == 2);
    static const std::regex kPair(R"re(([-0-9.]+) ([-0-9.]+))re");
    for (std::sregex_iterator i(d.begin(), d.end(), kPair), end; i != end; ++i) {
        CHECK(std::stod((*i)[1]) >= 40);
        CHECK(std::stod((*i)[1]) <= 550);
        CHECK(std::stod((*i)[2]) >= 30);
        CHECK(std::stod((*i)[2]) <= 400);
    }
}

TEST_CASE("every axis has at least three labels, whatever its range") {
    for (bool log : {false, true}) {
        for (double from : {1e-250, 3e-7, 0.07, 1.0, 3.3, 700.0, 9990.0, 2e12, 1e250}) {
            for (double ratio : {1.0, 1.0001, 1.3, 2.0, 7.0, 80.0, 1e4, 1e30}) {
                const std::string svg = svg_plot(plot_of({{from, from}, {from * ratio, from * ratio}}, log));
                CHECK(count(svg, "class=\"tick\"") >= 6);
                CHECK(count(svg, "class=\"tick\"") <= 25);
                CHECK(is_well_formed(svg));
            }
        }
    }
}

TEST_CASE("labels are plain from a thousandth to below ten thousand and powers of ten beyond") {
    const std::string svg = svg_plot(plot_of({{0.001, 1e-5}, {4000, 1e5}}));
    for (const char* plain : {">0.001<", ">0.1<", ">1<", ">1000<"}) CHECK(count(svg, plain) >= 1);
    CHECK(count(svg, ">10<tspan class=\"sup\" dy=\"-4\">4</tspan>") == 1);
    CHECK(count(svg, ">10<tspan class=\"sup\" dy=\"-4\">&#8722;4</tspan>") == 1);
    CHECK(count(svg, ">10000<") == 0);
}

TEST_CASE("all of twenty series' legend is in the picture, no entry over another") {
    for (const Plot& plot : {many_series(20), many_series(3)}) {
        const std::string svg = svg_plot(plot);
        const std::string legend = svg.substr(svg.find("<g class=\"legend"));
        const auto lines = heights(legend, R"re(<text class="name" x="[0-9.]+" y="([0-9.]+)")re");
        CHECK(lines.size() > plot.series.size());  // wrapped
        CHECK(lines.size() <= 3 * plot.series.size());
        for (size_t i = 1; i < lines.size(); ++i) CHECK(lines[i] >= lines[i - 1] + 11);
        CHECK(lines.back() < view_height(svg));
        CHECK(view_height(svg) >= 440);
    }
}
