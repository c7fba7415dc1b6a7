// SPDX-License-Identifier: MIT
// What tests of files share: folders, messages of errors, real data.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tools/check/support/folder.h"
#include "tools/check/support/refusal.h"

namespace tress::test {

/// A file of the real data that TRESS_DATA names the folder of; none where it is unset, which is said.
inline std::optional<std::string> real_file(const std::string& name) {
    const char* folder = std::getenv("TRESS_DATA");
    if (!folder || !*folder) {
        MESSAGE("TRESS_DATA is not set: skipped " << name);
        return std::nullopt;
    }
    return (std::filesystem::path(folder) / name).string();
}

}  // namespace tress::test
