// SPDX-License-Identifier: MIT
// What programs that measure share.
#pragma once

#include <chrono>
#include <string>

#include "core/error.h"

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

}  // namespace tress::test
