// SPDX-License-Identifier: MIT
// Lays a plot out (legend, ranges, ticks), then writes it from back to front.
#include "io/svg_plot.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tress {
namespace {

// Lengths are in units of the viewBox.
constexpr double kWidth = 720, kLeastHeight = 440, kTallestPlot = 560;
constexpr double kRight = 536, kBelowPlot = 50, kEdge = 10;
constexpr double kFont = 11, kTitleFont = 15, kTitleLine = 19, kBold = 1.2;  // bold letters are wider
constexpr double kLegendLeft = 556, kSample = 26, kLegendText = kLegendLeft + kSample + 7;
constexpr double kLegendLine = 13, kLegendGap = 7;
constexpr size_t kLegendLines = 3, kTitleLines = 2;
constexpr double kMajorTick = 5, kMinorTick = 3, kCap = 3;

constexpr double kMargin = 0.05;                        // of the span, on either side
constexpr double kHuge = 1e300, kTiny = 1e-280;         // bounds of magnitudes on linear axes
constexpr double kLeastLogSpan = 1e-6;                  // decades
constexpr double kLeastLinearSpan = 1e-9;               // of the largest magnitude
constexpr double kFineDecades = 3;                      // below so many decades 2 and 5 are labelled too
constexpr int kPlainFrom = -3, kPlainTo = 4;            // powers of ten written out on logarithmic axes
constexpr double kPlainLeast = 1e-3, kPlainMost = 1e6;  // magnitudes written out on linear axes
constexpr double kFloorReach = 0.1;                     // of the lowest point
constexpr int kMostTicksAcross = 8, kMostTicksUp = 8;
constexpr double kLabelGap = 10;

constexpr size_t kColors = 8;
struct Palette {
    const char *ground, *ink, *quiet, *grid;
    std::array<const char*, kColors> series;
};
// After Okabe and Ito, spread in lightness so that colour-blind people can tell them apart; at least 3:1 with the
// ground.
constexpr Palette kLight = {"#ffffff",
                            "#22262b",
                            "#5b636d",
                            "#e3e6ea",
                            {"#352fca", "#fa2f00", "#009178", "#805e96", "#739b30", "#286ccd", "#3a3a3a", "#4a1169"}};
constexpr Palette kDark = {"#16191e",
                           "#e6e9ed",
                           "#a3abb5",
                           "#2c323a",
                           {"#7c66ff", "#e05e07", "#20f58b", "#bf5894", "#f7d903", "#6fa3fa", "#f2f2f2", "#a3835c"}};

// Circle, square, triangle, diamond, triangle on its tip, plus, cross, star; all about their origin.
constexpr std::array<const char*, kColors> kMarks = {
    "M-3.8 0a3.8 3.8 0 1 0 7.6 0a3.8 3.8 0 1 0-7.6 0z",
    "M-3.4-3.4h6.8v6.8h-6.8z",
    "M0-4.6L4.4 3.2H-4.4z",
    "M0-5L5 0L0 5L-5 0z",
    "M0 4.6L4.4-3.2H-4.4z",
    "M-1.5-4.6h3v3.1h3.1v3h-3.1v3.1h-3v-3.1h-3.1v-3h3.1z",
    "M-4.3-2.2L-2.2-4.3L0-2.1L2.2-4.3L4.3-2.2L2.1 0L4.3 2.2L2.2 4.3L0 2.1L-2.2 4.3L-4.3 2.2L-2.1 0z",
    "M0-5.4L1.4-1.9L5.1-1.7L2.3 .8L3.2 4.4L0 2.4L-3.2 4.4L-2.3 .8L-5.1-1.7L-1.4-1.9z"};

// ---- Numbers

std::string fixed(double v, int decimals) {
    char digits[400];
    const auto end = std::to_chars(digits, digits + sizeof digits, v, std::chars_format::fixed, decimals);
    return {digits, end.ptr};
}

/// A coordinate: at most two decimals, none of them an idle zero.
std::string coord(double v) {
    std::string text = fixed(v, 2);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string point(double x, double y) { return coord(x) + ' ' + coord(y); }

/// n * 10^exponent; exact where doubles are.
double scaled(double n, int exponent) {
    return exponent < 0 ? n / std::pow(10.0, -exponent) : n * std::pow(10.0, exponent);
}

// ---- Text

constexpr char32_t kEllipsis = 0x2026;

/// Of the UTF-8 sequence that starts at `from`: its code point and length; a broken one gives 0 and skips one byte.
std::pair<char32_t, size_t> decode(const std::string& text, size_t from) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned lead = byte(from);
    if (lead < 0x80) return {lead, 1};
    const size_t length = lead >= 0xf8 ? 0 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 0;
    if (length == 0) return {0, 1};
    char32_t c = lead & (0x7fu >> length);
    for (size_t i = 1; i < length; ++i) {
        if ((byte(from + i) & 0xc0) != 0x80) return {0, 1};
        c = c << 6 | (byte(from + i) & 0x3f);
    }
    constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    return {c >= kLeast[length] ? c : 0, length};
}

bool is_printable(char32_t c) {
    const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
    const bool surrogate = c >= 0xd800 && c < 0xe000;
    return !control && !surrogate && (c & 0xfffe) != 0xfffe && c < 0x110000;
}

/// The characters that XML and readers can take.
std::u32string printable(const std::string& text) {
    std::u32string kept;
    for (size_t i = 0; i < text.size();) {
        const auto [c, length] = decode(text, i);
        if (is_printable(c)) kept += c;
        i += length;
    }
    return kept;
}

/// As XML; what is not ASCII becomes a reference, so that no page's encoding can spoil it.
std::string escaped(const std::u32string& text) {
    std::string xml;
    for (char32_t c : text) {
        const bool special = c == '&' || c == '<' || c == '>' || c == '"' || c == '\'';
        if (special || c >= 0x7f)
            xml += "&#" + std::to_string(uint32_t(c)) + ';';
        else
            xml += char(c);
    }
    return xml;
}

std::string escaped(const std::string& text) { return escaped(printable(text)); }

/// A generous guess, in ems, for the usual sans-serif fonts.
double width_of(char32_t c) {
    constexpr std::u32string_view kNarrow = U"iljtfrI.,:;'|!()[] -/";
    constexpr std::u32string_view kWide = U"mwM+=<>~", kWidest = U"W%@";
    if (c >= 0x2e80) return 1.05;
    if (kNarrow.find(c) != std::u32string_view::npos) return 0.38;
    if (kWide.find(c) != std::u32string_view::npos) return 0.95;
    if (kWidest.find(c) != std::u32string_view::npos) return 1.05;
    return c >= 'A' && c <= 'Z' ? 0.72 : c < 0x80 ? 0.59 : 0.75;
}

double width_of(const std::u32string& text) {
    double width = 0;
    for (char32_t c : text) width += width_of(c);
    return width;
}

/// How many characters of `text` from `from` on make a line of `width` ems: up to a good place to break, if any.
size_t line_length(const std::u32string& text, size_t from, double width) {
    constexpr std::u32string_view kBreakAfter = U" -_/,;:";
    size_t fit = 0, good = 0;
    for (double used = 0; from + fit < text.size(); ++fit) {
        used += width_of(text[from + fit]);
        if (used > width && text[from + fit] != U' ') break;
        if (kBreakAfter.find(text[from + fit]) != std::u32string_view::npos) good = fit + 1;
    }
    if (from + fit == text.size()) return fit;
    return good > 0 ? good : std::max<size_t>(fit, 1);
}

/// `line` with an ellipsis, shortened to `width` ems.
std::u32string cut(std::u32string line, double width) {
    while (!line.empty() && width_of(line) + 1 > width) line.pop_back();
    return line + kEllipsis;
}

/// In at most `most` lines of `width` units; what does not fit is cut off.
std::vector<std::u32string> wrapped(const std::string& text, double width, double font, size_t most) {
    const std::u32string whole = printable(text);
    std::vector<std::u32string> lines;
    for (size_t from = 0; from < whole.size() && lines.size() < most;) {
        const size_t length = line_length(whole, from, width / font);
        const bool is_cut = lines.size() + 1 == most && from + length < whole.size();
        lines.push_back(is_cut ? cut(whole.substr(from), width / font) : whole.substr(from, length));
        from += length;
    }
    return lines;
}

std::string one_line(const std::string& text, double width) {
    const auto lines = wrapped(text, width, kFont, 1);
    return lines.empty() ? std::string() : escaped(lines.front());
}

/// `content` is XML already; `more`: further attributes.
std::string text_at(double x, double y, const char* kind, const std::string& content, const std::string& more = {}) {
    return "<text class=\"" + std::string(kind) + "\" x=\"" + coord(x) + "\" y=\"" + coord(y) + '"' + more + '>' +
           content + "</text>\n";
}

std::string path(const char* kind, const std::string& d) {
    return "<path class=\"" + std::string(kind) + "\" d=\"" + d + "\"/>\n";
}

// ---- Ranges. An axis measures in "units": values, or decades if it is logarithmic.

std::optional<double> units(bool log, double v) {
    if (!std::isfinite(v) || (log && v <= 0)) return {};
    if (log) return std::log10(v);
    return std::abs(v) < kTiny ? 0 : std::clamp(v, -kHuge, kHuge);
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    bool empty() const { return low > high; }
    double span() const { return high - low; }
    bool contains(double v) const { return v >= low && v <= high; }
    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};

/// With a margin; never without a span.
Range widened(const Range& data, bool log) {
    const double largest = std::max(std::abs(data.low), std::abs(data.high));
    const bool level = data.span() <= (log ? kLeastLogSpan : kLeastLinearSpan * largest);
    const double level_margin = log || largest == 0 ? 0.5 : 0.5 * largest;
    const double margin = level ? level_margin : kMargin * data.span();
    return {data.low - margin, data.high + margin};
}

struct Axis {
    bool log = true;
    Range range;
    double from = 0, to = 0;  // where the range begins and ends

    double at(double v) const { return from + (v - range.low) / range.span() * (to - from); }
};

// ---- Ticks

struct Tick {
    double at;  // in units
    std::string label;
    double width;  // of the label; 0: a minor tick

    bool major() const { return width > 0; }
};

/// With a true minus sign for a hyphen.
std::string with_minus(const std::string& digits) {
    return digits.front() == '-' ? "&#8722;" + digits.substr(1) : digits;
}

/// n * 10^power, `digits` being n; "": 1.
Tick power_tick(double at, const std::string& digits, int power) {
    const std::string factor = digits.empty() ? "" : with_minus(digits) + "&#215;";
    const std::string sign = power < 0 ? "&#8722;" : "", raised = std::to_string(std::abs(power));
    const double width = 0.6 * double(digits.size() + (digits.empty() ? 2 : 3)) + 0.5 * double(raised.size() + 1);
    return {at, factor + "10<tspan class=\"sup\" dy=\"-4\">" + sign + raised + "</tspan>", width * kFont};
}

Tick plain_tick(double at, const std::string& digits) {
    return {at, with_minus(digits), 0.6 * double(digits.size()) * kFont};
}

/// m * 10^power, m one of 1, 2 and 5.
struct Step {
    int m, power;
};

Step nice_step(double raw) {
    constexpr double kSlack = 1 - 1e-9;
    const int power = int(std::floor(std::log10(raw)));
    for (int m : {1, 2, 5})
        if (scaled(m, power) >= raw * kSlack) return {m, power};
    return {1, power + 1};
}

/// `at` is in values of the range; labels show them times 10^shift (other than 0 for a range above 1 alone).
std::vector<Tick> linear_ticks(const Range& range, int most, int shift = 0) {
    const Step step = nice_step(range.span() / most);
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    const bool plain = shift == 0 && largest >= kPlainLeast && largest < kPlainMost;
    const int power = plain || shift != 0 ? 0 : int(std::floor(std::log10(largest)));
    const int decimals = std::max(0, power - step.power), parts = step.m == 2 ? 4 : 5;
    const double part = scaled(step.m, step.power) / parts;
    constexpr double kSlack = 1e-9;
    std::vector<Tick> ticks;
    const auto last = int64_t(std::floor(range.high / part + kSlack));
    for (auto i = int64_t(std::ceil(range.low / part - kSlack)); i <= last; ++i) {
        const double n = double(i) * step.m / parts, at = scaled(n, step.power);
        if (i % parts != 0)
            ticks.push_back({at, "", 0});
        else if (plain || i == 0)
            ticks.push_back(plain_tick(at, i == 0 ? "0" : fixed(at, decimals)));
        else
            ticks.push_back(power_tick(at, fixed(scaled(n, step.power - power), decimals), power + shift));
    }
    return ticks;
}

/// Of a logarithmic axis too short for 1, 2 and 5.
std::vector<Tick> short_log_ticks(const Range& range, int most) {
    const bool plain = range.low >= kPlainFrom && range.high < std::log10(kPlainMost);
    const int shift = plain ? 0 : int(std::floor(range.low));
    std::vector<Tick> ticks =
        linear_ticks({std::pow(10.0, range.low - shift), std::pow(10.0, range.high - shift)}, most, shift);
    for (Tick& tick : ticks) tick.at = std::log10(tick.at) + shift;
    return ticks;
}

Tick log_tick(double at, int m, int decade) {
    if (decade >= kPlainFrom && decade < kPlainTo)
        return plain_tick(at, fixed(scaled(m, decade), std::max(0, -decade)));
    return power_tick(at, m == 1 ? "" : std::to_string(m), decade);
}

/// Decades between labels.
int decade_step(double span, int most) {
    constexpr int kSteps[] = {1, 2, 5, 10, 20, 50, 100};
    for (int step : kSteps)
        if (span / step <= most) return step;
    return 200;
}

std::vector<Tick> log_ticks(const Range& range, int most) {
    const bool fine = range.span() < kFineDecades;
    const int step = decade_step(range.span(), most), minor_step = std::max(1, step / 10);
    std::vector<Tick> ticks;
    for (int decade = int(std::floor(range.low)); decade <= range.high; ++decade) {
        for (int m = 1; m < 10; ++m) {
            const double at = decade + std::log10(double(m));
            if (!range.contains(at)) continue;
            if ((m == 1 && decade % step == 0) || (fine && (m == 2 || m == 5)))
                ticks.push_back(log_tick(at, m, decade));
            else if (step == 1 || (m == 1 && decade % minor_step == 0))
                ticks.push_back({at, "", 0});
        }
    }
    constexpr int kEnough = 3;
    const auto labelled = std::count_if(ticks.begin(), ticks.end(), [](const Tick& t) { return t.major(); });
    return labelled < kEnough && fine ? short_log_ticks(range, most) : ticks;
}

std::vector<Tick> ticks_of(const Axis& axis, int most) {
    return axis.log ? log_ticks(axis.range, most) : linear_ticks(axis.range, most);
}

/// Whether the labels keep clear of each other side by side.
bool fit_across(const Axis& axis, const std::vector<Tick>& ticks) {
    double taken = -kWidth;
    for (const Tick& tick : ticks) {
        if (!tick.major()) continue;
        const double middle = axis.at(tick.at);
        if (middle - tick.width / 2 < taken) return false;
        taken = middle + tick.width / 2 + kLabelGap;
    }
    return true;
}

std::vector<Tick> ticks_across(const Axis& axis) {
    int most = kMostTicksAcross;
    while (most > 2 && !fit_across(axis, ticks_of(axis, most))) --most;
    return ticks_of(axis, most);
}

// ---- What of the data is drawn

struct DrawnPoint {
    double x, y, low, high;  // in units; low <= high
    bool is_open;            // the low end is below all of a logarithmic axis
    const std::string* label;
};

std::optional<DrawnPoint> drawn(const Plot& plot, const PlotPoint& p) {
    const auto x = units(plot.log_x, p.x), y = units(plot.log_y, p.y);
    if (!x || !y) return {};
    DrawnPoint point{*x, *y, *y, *y, false, &p.label};
    if (p.low == p.high) return point;
    const auto low = units(plot.log_y, p.low), high = units(plot.log_y, p.high);
    point.low = std::min(low.value_or(*y), high.value_or(*y));
    point.high = std::max(low.value_or(*y), high.value_or(*y));
    point.is_open = plot.log_y && std::isfinite(p.low) && p.low <= 0;
    return point;
}

struct DrawnSeries {
    const PlotSeries* source;
    std::vector<DrawnPoint> points;
    std::optional<double> floor;  // in units
};

/// `data`: heights of all points with their ranges, in units.
void keep_near_floors(const Plot& plot, const Range& data, std::vector<DrawnSeries>& all) {
    for (DrawnSeries& series : all) {
        if (!series.source->floor || data.empty()) continue;
        const auto floor = units(plot.log_y, *series.source->floor);
        constexpr double kSlack = 1e-9;
        if (floor && (!plot.log_y || *floor >= data.low + std::log10(kFloorReach) - kSlack)) series.floor = floor;
    }
}

struct Layout {
    Axis x, y;
    bool has_data = false;
    double height = kLeastHeight;
    std::vector<std::u32string> title;
    std::vector<std::vector<std::u32string>> legend;
    std::vector<DrawnSeries> series;
    std::vector<Tick> x_ticks, y_ticks;
};

void gather_data(const Plot& plot, Layout& layout) {
    Range across, up;
    for (const PlotSeries& source : plot.series) {
        DrawnSeries series{&source, {}, {}};
        for (const PlotPoint& p : source.points) {
            const auto point = drawn(plot, p);
            if (!point) continue;
            across.add(point->x);
            up.add(point->y);
            up.add(point->low);
            up.add(point->high);
            series.points.push_back(*point);
        }
        layout.series.push_back(std::move(series));
    }
    layout.has_data = !up.empty();
    if (!layout.has_data) return;
    keep_near_floors(plot, up, layout.series);
    for (const DrawnSeries& series : layout.series)
        if (series.floor) up.add(*series.floor);
    layout.x.range = widened(across, plot.log_x);
    layout.y.range = widened(up, plot.log_y);
}

double legend_height(const std::vector<std::u32string>& lines) {
    return double(std::max<size_t>(lines.size(), 1)) * kLegendLine + kLegendGap;
}

/// Places the plot's four sides, once the legend's height and the ranges are known.
void place_axes(Layout& layout) {
    const double top = 22 + kTitleLine * double(std::max<size_t>(layout.title.size(), 1));
    double legend = 0;
    for (const auto& lines : layout.legend) legend += legend_height(lines);
    layout.height = std::ceil(std::max(kLeastHeight, top + legend + kEdge));
    layout.y.to = top;
    layout.y.from = std::min(layout.height - kBelowPlot, top + kTallestPlot);
    if (layout.has_data) layout.y_ticks = ticks_of(layout.y, kMostTicksUp);
    double widest = 0;
    for (const Tick& tick : layout.y_ticks) widest = std::max(widest, tick.width);
    layout.x.from = std::ceil(std::max(58.0, 34 + widest + kMajorTick));
    layout.x.to = kRight;
    if (layout.has_data) layout.x_ticks = ticks_across(layout.x);
}

Layout lay_out(const Plot& plot) {
    Layout layout;
    layout.x.log = plot.log_x;
    layout.y.log = plot.log_y;
    layout.title = wrapped(plot.title, kWidth - 2 * kEdge, kTitleFont * kBold, kTitleLines);
    for (const PlotSeries& series : plot.series)
        layout.legend.push_back(wrapped(series.name, kWidth - 4 - kLegendText, kFont, kLegendLines));
    gather_data(plot, layout);
    place_axes(layout);
    return layout;
}

// ---- Style

/// Rules of one theme. No character here means anything to HTML or XML.
std::string theme(const Palette& colors) {
    const std::string ground = colors.ground, ink = colors.ink, quiet = colors.quiet, grid = colors.grid;
    std::string css = ".plot .ground{fill:" + ground + "}.plot text{fill:" + ink + "}.plot .tick{fill:" + quiet +
                      "}.plot .grid{stroke:" + grid + "}.plot .axis{stroke:" + quiet + "}.plot .mark{stroke:" + ground +
                      "}.plot .hollow{fill:" + ground + ";stroke:currentColor}\n";
    for (size_t c = 0; c < kColors; ++c) css += ".plot .s" + std::to_string(c) + "{color:" + colors.series[c] + '}';
    return css + '\n';
}

std::string style() {
    return "<style>\n"
           ".plot text{font:11px system-ui,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,sans-serif}"
           ".plot .title{font-size:15px;font-weight:600}.plot .sup{font-size:8px}.plot .empty{font-size:15px}\n"
           ".plot .grid,.plot .axis{fill:none;stroke-width:1}"
           ".plot .line,.plot .curve,.plot .bar,.plot .floor{fill:none;stroke:currentColor;stroke-linejoin:round}\n"
           ".plot .line{stroke-width:2}.plot .curve{stroke-width:1.1}.plot .bar{stroke-width:1.2}"
           ".plot .floor{stroke-width:1.1;stroke-dasharray:5 4}"
           ".plot .d1{stroke-dasharray:7 3}.plot .d2{stroke-dasharray:2 2.5}.plot .d3{stroke-dasharray:8 2 2 2}\n"
           ".plot .mark{fill:currentColor;stroke-width:.8}.plot .hollow{stroke-width:1.5}"
           ".plot .hit{fill:none;pointer-events:all}\n"
           ".plot .legend{cursor:pointer}.plot .series.off{display:none}.plot .legend.off{opacity:.35}\n" +
           theme(kLight) + "@media (prefers-color-scheme:dark){\n" + theme(kDark) + "}\n@media print{\n" +
           theme(kLight) + "}\n</style>\n";
}

// ---- Drawing

std::string series_class(size_t k) { return 's' + std::to_string(k % kColors); }

/// Past the first eight series lines are dashed ...
std::string line_class(size_t k) {
    constexpr size_t kDashes = 4;
    const size_t dash = k / kColors % kDashes;
    return dash == 0 ? "line" : "line d" + std::to_string(dash);
}

/// ... and every other eight have hollow markers.
std::string mark(size_t k, double x, double y, const std::string& title) {
    const bool hollow = k / kColors % 2 == 1;
    const std::string start = "<path class=\"" + std::string(hollow ? "mark hollow" : "mark") +
                              "\" transform=\"translate(" + point(x, y) + ")\" d=\"" + kMarks[k % kColors] + '"';
    return start + (title.empty() ? "/>\n" : "><title>" + title + "</title></path>\n");
}

std::string axis_lines(const Layout& layout) {
    const Axis &x = layout.x, &y = layout.y;
    std::string grid, lines = 'M' + point(x.from, y.to) + 'V' + coord(y.from) + 'H' + coord(x.to);
    for (const Tick& tick : layout.x_ticks) {
        const double at = x.at(tick.at);
        if (tick.major()) grid += 'M' + point(at, y.to) + 'V' + coord(y.from);
        lines += 'M' + point(at, y.from) + 'v' + coord(tick.major() ? kMajorTick : kMinorTick);
    }
    for (const Tick& tick : layout.y_ticks) {
        const double at = y.at(tick.at);
        if (tick.major()) grid += 'M' + point(x.from, at) + 'H' + coord(x.to);
        lines += 'M' + point(x.from, at) + 'h' + coord(tick.major() ? -kMajorTick : -kMinorTick);
    }
    return path("grid", grid) + path("axis", lines);
}

std::string tick_labels(const Layout& layout) {
    std::string out;
    for (const Tick& tick : layout.x_ticks)
        if (tick.major())
            out += text_at(layout.x.at(tick.at), layout.y.from + 18, "tick", tick.label, " text-anchor=\"middle\"");
    for (const Tick& tick : layout.y_ticks)
        if (tick.major())
            out += text_at(layout.x.from - 8, layout.y.at(tick.at) + 4, "tick", tick.label, " text-anchor=\"end\"");
    return out;
}

std::string titles(const Plot& plot, const Layout& layout) {
    std::string out;
    for (size_t i = 0; i < layout.title.size(); ++i)
        out += text_at(kEdge, 24 + kTitleLine * double(i), "title", escaped(layout.title[i]));
    const double across = layout.x.to - layout.x.from, up = layout.y.from - layout.y.to;
    out += text_at(layout.x.from + across / 2, layout.y.from + 38, "name", one_line(plot.x_label, across),
                   " text-anchor=\"middle\"");
    const double x = 17, y = layout.y.to + up / 2;
    out += text_at(x, y, "name", one_line(plot.y_label, up),
                   " text-anchor=\"middle\" transform=\"rotate(-90 " + point(x, y) + ")\"");
    return out;
}

struct Position {
    double x, y;
};

/// The part of the straight line a-b inside the plot: between which fractions of its length (Liang and Barsky).
std::optional<std::pair<double, double>> inside(const Layout& layout, const Position& a, const Position& b) {
    double from = 0, to = 1;
    const auto keep = [&](double start, double change, double least, double most) {
        if (change == 0) return start >= least && start <= most;
        const double t = (least - start) / change, u = (most - start) / change;
        from = std::max(from, std::min(t, u));
        to = std::min(to, std::max(t, u));
        return from <= to;
    };
    if (!keep(a.x, b.x - a.x, layout.x.from, layout.x.to)) return {};
    if (!keep(a.y, b.y - a.y, layout.y.to, layout.y.from)) return {};
    return std::pair(from, to);
}

/// Far positions are brought nearer, still out of sight.
Position position(const Layout& layout, double x, double y) {
    constexpr double kFar = 1e9;
    return {std::clamp(layout.x.at(x), -kFar, kFar), std::clamp(layout.y.at(y), -kFar, kFar)};
}

std::string curve_path(const Plot& plot, const Layout& layout, const PlotSeries& series) {
    std::string d;
    std::optional<Position> last;
    bool joined = false;  // `last` is the end of the path
    for (const auto& [x_value, y_value] : series.curve) {
        const auto x = units(plot.log_x, x_value), y = units(plot.log_y, y_value);
        const auto here = x && y ? std::optional(position(layout, *x, *y)) : std::nullopt;
        const auto part = last && here ? inside(layout, *last, *here) : std::nullopt;
        const auto along = [&](double t) {
            return point(last->x + t * (here->x - last->x), last->y + t * (here->y - last->y));
        };
        if (part) d += (joined ? "L" : 'M' + along(part->first) + 'L') + along(part->second);
        joined = part.has_value() && part->second == 1;
        last = here;
    }
    return d.empty() ? d : path("curve", d);
}

std::string bar_path(const Layout& layout, const DrawnSeries& series) {
    std::string d;
    const auto cap = [&](double x, double y) { return 'M' + point(x - kCap, y) + 'h' + coord(2 * kCap); };
    for (const DrawnPoint& p : series.points) {
        if (p.low == p.high && !p.is_open) continue;
        const double x = layout.x.at(p.x), high = layout.y.at(p.high);
        const double low = p.is_open ? layout.y.from : layout.y.at(p.low);
        d += 'M' + point(x, low) + 'V' + coord(high);
        if (!p.is_open) d += cap(x, low);
        if (p.high > p.y || p.low > p.y) d += cap(x, high);
    }
    return d.empty() ? d : path("bar", d);
}

std::string line_path(const Layout& layout, const DrawnSeries& series, size_t k) {
    if (!series.source->line || series.points.size() < 2) return {};
    std::string d;
    for (const DrawnPoint& p : series.points) d += (d.empty() ? 'M' : 'L') + point(layout.x.at(p.x), layout.y.at(p.y));
    return path(line_class(k).c_str(), d);
}

std::string draw_series(const Plot& plot, const Layout& layout, size_t k) {
    const DrawnSeries& series = layout.series[k];
    std::string out = "<g class=\"series " + series_class(k) + "\" data-series=\"" + std::to_string(k) + "\">\n";
    if (series.floor)
        out += path("floor", 'M' + point(layout.x.from, layout.y.at(*series.floor)) + 'H' + coord(layout.x.to));
    if (layout.has_data) out += curve_path(plot, layout, *series.source);
    out += bar_path(layout, series) + line_path(layout, series, k);
    for (const DrawnPoint& p : series.points) out += mark(k, layout.x.at(p.x), layout.y.at(p.y), escaped(*p.label));
    return out + "</g>\n";
}

std::string sample(const PlotSeries& series, size_t k, double y) {
    const std::string d = 'M' + point(kLegendLeft, y) + 'h' + coord(kSample);
    const bool is_model = !series.line && series.points.empty() && !series.curve.empty();
    const std::string stroke = is_model ? path("curve", d) : series.line ? path(line_class(k).c_str(), d) : "";
    return is_model ? stroke : stroke + mark(k, kLegendLeft + kSample / 2, y, "");
}

std::string legend_entry(const Plot& plot, const Layout& layout, size_t k, double top) {
    const PlotSeries& series = plot.series[k];
    const double height = legend_height(layout.legend[k]);
    std::string out = "<g class=\"legend " + series_class(k) + "\" data-series=\"" + std::to_string(k) +
                      "\" tabindex=\"0\" role=\"button\">\n<title>" + escaped(series.name) +
                      "</title>\n<rect class=\"hit\" x=\"" + coord(kLegendLeft - 4) + "\" y=\"" + coord(top) +
                      "\" width=\"" + coord(kWidth - kLegendLeft + 2) + "\" height=\"" + coord(height) + "\"/>\n";
    out += sample(series, k, top + (kLegendGap + kLegendLine) / 2);
    for (size_t i = 0; i < layout.legend[k].size(); ++i)
        out += text_at(kLegendText, top + kLegendGap / 2 + 10 + kLegendLine * double(i), "name",
                       escaped(layout.legend[k][i]));
    return out + "</g>\n";
}

std::string legend(const Plot& plot, const Layout& layout) {
    std::string out;
    double top = layout.y.to - kLegendGap / 2;
    for (size_t k = 0; k < plot.series.size(); ++k) {
        out += legend_entry(plot, layout, k, top);
        top += legend_height(layout.legend[k]);
    }
    return out;
}

}  // namespace

std::string svg_plot(const Plot& plot) {
    const Layout layout = lay_out(plot);
    const std::string width = coord(kWidth), height = coord(layout.height);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + ' ' + height +
                      "\" class=\"plot\" role=\"img\" aria-label=\"" + escaped(plot.title) + "\">\n" + style() +
                      "<rect class=\"ground\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
    out += axis_lines(layout) + tick_labels(layout) + titles(plot, layout);
    for (size_t k = 0; k < plot.series.size(); ++k) out += draw_series(plot, layout, k);
    if (!layout.has_data)
        out += text_at((layout.x.from + layout.x.to) / 2, (layout.y.from + layout.y.to) / 2, "empty", "no data",
                       " text-anchor=\"middle\"");
    return out + legend(plot, layout) + "</svg>\n";
}

}  // namespace tress
