// SPDX-License-Identifier: MIT
// What a node's index can name is a limit that input can pass: it is reported, never wrapped.
#pragma once

#include <cstdint>
#include <string>

#include "core/error.h"

namespace tress {

inline void check_index_limit(const char* what, uint64_t needed, uint64_t limit) {
    if (needed > limit)
        throw InputError("kd-tree", "needs " + std::to_string(needed) + " " + what + ", at most " +
                                        std::to_string(limit) + " can be indexed: use less geometry");
}

}  // namespace tress
