// SPDX-License-Identifier: MIT
#include "io/plot/plot_ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/plot/plot_lengths.h"
#include "io/plot/svg_text.h"

namespace tress::svg {
namespace {

constexpr double kFineDecades = 3;                      // below so many decades 2 and 5 are labelled too
constexpr int kPlainFrom = -3, kPlainTo = 4;            // powers of ten written out on logarithmic axes
constexpr double kPlainLeast = 1e-3, kPlainMost = 1e6;  // magnitudes written out on linear axes
constexpr int kMostTicksAcross = 8;
constexpr double kLabelGap = 10;

/// n * 10^exponent; exact where doubles are.
double scaled(double n, int exponent) {
    return exponent < 0 ? n / std::pow(10.0, -exponent) : n * std::pow(10.0, exponent);
}

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

}  // namespace

std::vector<Tick> ticks_of(const Axis& axis, int most) {
    return axis.log ? log_ticks(axis.range, most) : linear_ticks(axis.range, most);
}

std::vector<Tick> ticks_across(const Axis& axis) {
    int most = kMostTicksAcross;
    while (most > 2 && !fit_across(axis, ticks_of(axis, most))) --most;
    return ticks_of(axis, most);
}

}  // namespace tress::svg
