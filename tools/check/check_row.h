// SPDX-License-Identifier: MIT
// A row of the table of stiff and extreme cases: what is tried, what must come of it, and what is measured here.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/options.h"

namespace tress {

/// A figure and its bound: it passes from `lowest` to `highest`, both included. NaN never passes.
struct Figure {
    std::string what;  // "wrong hits at D/r = 3e4"
    double measured = 0;
    double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
    std::string unit = {};  // "%"

    bool passes() const { return measured >= lowest && measured <= highest; }
};

Figure at_most(std::string what, double measured, double highest, std::string unit = {});
Figure at_least(std::string what, double measured, double lowest, std::string unit = {});
Figure exactly(std::string what, double measured, double value, std::string unit = {});
Figure within(std::string what, double measured, double value, double tolerance, std::string unit = {});
/// 1 where it holds, 0 where not; must be 1.
Figure holds(std::string what, bool true_here);
/// Without a bound: told, and never wrong unless it is NaN.
Figure told(std::string what, double measured, std::string unit = {});

struct Outcome {
    std::vector<Figure> figures;  // what went without any figure has not passed
    std::string does_not_apply;   // why; empty: it does

    bool passes() const;
};

/// With what rows are measured; threads are those that TBB has.
struct CheckSettings {
    Isa isa = Isa::automatic;
};

struct CheckRow {
    const char* id;        // "D6"
    const char* name;      // the case
    const char* expected;  // in words
    Outcome (*measure)(const CheckSettings&);
};

}  // namespace tress
