// SPDX-License-Identifier: MIT
#include "tools/signature.h"

#include <cstdio>

#include "core/rng.h"

namespace tress {

std::string hexadecimal(uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

std::string key_of(const std::vector<std::string>& parts) {
    uint64_t key = 0;
    for (const std::string& part : parts) {
        key = hash(key, part.size());
        for (const char c : part) key = hash(key, static_cast<unsigned char>(c));
    }
    return hexadecimal(key);
}

}  // namespace tress
