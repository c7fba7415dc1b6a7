// SPDX-License-Identifier: MIT
#include "tools/machine.h"

#include <fstream>
#include <iterator>

#include "tools/signature.h"

namespace tress {

std::string processor_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name"))
            if (const size_t colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

std::string program_signature() {
    std::ifstream in("/proc/self/exe", std::ios::binary);
    return key_of({std::string(std::istreambuf_iterator<char>(in), {})});
}

}  // namespace tress
