// SPDX-License-Identifier: MIT
#include "tools/study/sweep.h"

#include <sstream>

#include "core/error.h"
#include "tools/scene_arguments.h"

namespace tress {

constexpr size_t kMostPoints = 10000;

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);) parts.push_back(part);
    return parts;
}

Options with_settings(Options base, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) set_option(base, setting);
    return base;
}

std::vector<std::vector<std::string>> grid(const std::vector<std::string>& sweeps) {
    std::vector<std::vector<std::string>> points{{}};
    for (const std::string& sweep : sweeps) {
        const size_t equals = sweep.find('=');
        const std::vector<std::string> values =
            equals == std::string::npos ? std::vector<std::string>{} : split(sweep.substr(equals + 1), ',');
        if (values.empty()) throw InputError("--sweep", "'" + sweep + "', expected key=value,value,...");
        if (points.size() * values.size() > kMostPoints)
            throw InputError("--sweep", "more than " + std::to_string(kMostPoints) + " combinations, expected fewer");
        std::vector<std::vector<std::string>> finer;
        for (const std::vector<std::string>& point : points)
            for (const std::string& value : values) {
                finer.push_back(point);
                finer.back().push_back(sweep.substr(0, equals + 1) + value);
                Options checked;
                set_option(checked, finer.back().back());
            }
        points = std::move(finer);
    }
    return points;
}

}  // namespace tress
