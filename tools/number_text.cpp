// SPDX-License-Identifier: MIT
#include "tools/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tress {
namespace {

constexpr double kSmallestPlain = 1e-4, kLargestPlain = 1e7;

}  // namespace

std::string significant(double value, int digits) {
    char text[64];
    if (value == 0) return "0";
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    const int exponent = std::atoi(std::string(text).substr(std::string(text).find('e') + 1).c_str());
    const double size = std::abs(value);
    if (!std::isfinite(value)) return "none";
    if (size < kSmallestPlain || size >= kLargestPlain) {
        const std::string all(text);
        return all.substr(0, all.find('e')) + "e" + std::to_string(exponent);
    }
    std::snprintf(text, sizeof text, "%.*f", std::max(digits - 1 - exponent, 0), value);
    return text;
}

std::string duration(double seconds) {
    if (seconds < 60) return significant(seconds, seconds < 10 ? 2 : 3) + " s";
    const long whole = std::lround(seconds);
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string grouped(unsigned long long value) {
    std::string text = std::to_string(value);
    for (size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
    return text;
}

}  // namespace tress
