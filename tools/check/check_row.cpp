// SPDX-License-Identifier: MIT
#include "tools/check/check_row.h"

#include <algorithm>

namespace tress {

Figure at_most(std::string what, double measured, double highest, std::string unit) {
    Figure figure{std::move(what), measured};
    figure.highest = highest;
    figure.unit = std::move(unit);
    return figure;
}

Figure at_least(std::string what, double measured, double lowest, std::string unit) {
    Figure figure{std::move(what), measured};
    figure.lowest = lowest;
    figure.unit = std::move(unit);
    return figure;
}

Figure exactly(std::string what, double measured, double value, std::string unit) {
    return within(std::move(what), measured, value, 0, std::move(unit));
}

Figure within(std::string what, double measured, double value, double tolerance, std::string unit) {
    return {std::move(what), measured, value - tolerance, value + tolerance, std::move(unit)};
}

Figure holds(std::string what, bool true_here) { return exactly(std::move(what), true_here ? 1 : 0, 1); }

Figure told(std::string what, double measured, std::string unit) {
    Figure figure{std::move(what), measured};
    figure.unit = std::move(unit);
    return figure;
}

bool Outcome::passes() const {
    return !figures.empty() && std::all_of(figures.begin(), figures.end(), [](const Figure& f) { return f.passes(); });
}

}  // namespace tress
