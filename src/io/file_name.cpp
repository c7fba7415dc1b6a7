// SPDX-License-Identifier: MIT
#include "io/file_name.h"

#include <cstdlib>
#include <filesystem>

#include "core/error.h"

namespace tress {
namespace {

std::string with_variables(const std::string& where, const std::string& text) {
    std::string result;
    size_t done = 0;
    for (size_t open = text.find("${"); open != std::string::npos; open = text.find("${", done)) {
        const size_t close = text.find('}', open);
        if (close == std::string::npos) throw InputError(where, "${ without }, expected ${NAME}");
        const std::string name = text.substr(open + 2, close - open - 2);
        const char* value = std::getenv(name.c_str());
        if (!value) throw InputError(where, "${" + name + "} is not set, expected it in the environment");
        result.append(text, done, open - done).append(value);
        done = close + 1;
    }
    return result.append(text, done);
}

}  // namespace

std::string file_ending(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return ending;
}

std::string resolved_file_name(const std::string& where, const std::string& text, const std::string& folder) {
    if (text.find('\0') != std::string::npos) throw InputError(where, "a zero byte in a file's name, expected none");
    if (text.empty()) throw InputError(where, "no name, expected a file's");
    return (std::filesystem::path(folder) / with_variables(where, text)).string();
}

}  // namespace tress
