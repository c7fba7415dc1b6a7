// SPDX-License-Identifier: MIT
// What a reader or writer says where it refuses.
#pragma once

#include <string>

#include "core/error.h"

namespace tress::test {

/// The message of the InputError that `use` throws; empty where it throws none.
template <class Use>
std::string message_of(Use&& use) {
    try {
        use();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
inline bool is_one_line(const std::string& text) { return !text.empty() && !contains(text, "\n") && text.size() < 500; }

}  // namespace tress::test
