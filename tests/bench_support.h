// SPDX-License-Identifier: MIT
// What programs that measure share.
#pragma once

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>

#include "core/error.h"
#include "core/options.h"

namespace tress::test {

/// Wall time since some fixed moment.
inline double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Reads "[SCENE] [--flag value]...": calls `set(flag, value)` for each flag; returns the scene or nothing.
template <class Set>
std::string read_flags(int count, char** values, const Set& set) {
    std::string scene;
    for (int i = 1; i < count; ++i) {
        const std::string name = values[i];
        if (!name.starts_with("--")) {
            scene = name;
            continue;
        }
        if (i + 1 == count) throw InputError(name, "nothing follows, expected a value");
        set(name, std::string(values[++i]));
    }
    return scene;
}

/// Sets "key=value key=value ...".
inline void set_options(Options& options, const std::string& settings) {
    std::istringstream words(settings);
    for (std::string word; words >> word;) {
        const size_t equals = word.find('=');
        set_option(options, "--set", word.substr(0, equals), word.substr(std::min(equals, word.size() - 1) + 1));
    }
}

}  // namespace tress::test
