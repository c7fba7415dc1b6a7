// SPDX-License-Identifier: MIT
// What tests of files share: a folder of their own, bytes to and from files, real data.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "core/error.h"

namespace tress::test {

/// A new folder, gone with all that is in it at the end.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "tress-test-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string path() const { return path_.string(); }
    size_t entries() const {
        size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
        return count;
    }

private:
    std::filesystem::path path_;
};

inline std::string read_bytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline std::string write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

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
