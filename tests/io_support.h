// SPDX-License-Identifier: MIT
// What tests of files share: messages of errors, real data, bytes.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "core/error.h"
#include "tests/folder.h"

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

/// A file of the real data that TRESS_DATA names the folder of; none where it is unset, which is said.
inline std::optional<std::string> real_file(const std::string& name) {
    const char* folder = std::getenv("TRESS_DATA");
    if (!folder || !*folder) {
        MESSAGE("TRESS_DATA is not set: skipped " << name);
        return std::nullopt;
    }
    return (std::filesystem::path(folder) / name).string();
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace tress::test
