// SPDX-License-Identifier: MIT
// Numbers as the shortest text that reads back as the same, in every locale.
#pragma once

#include <charconv>
#include <string>

namespace tress {

template <class T>
std::string shortest_text(T value) {
    char text[64];
    const auto result = std::to_chars(text, text + sizeof text, value);
    return {text, result.ptr};
}

}  // namespace tress
