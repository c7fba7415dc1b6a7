// SPDX-License-Identifier: MIT
// Bytes of files, damaged as disks, cables and people do it.
#pragma once

#include <cstring>
#include <string>

#include "core/rng.h"

namespace tress::test {

/// `bytes` with one to three bytes changed, and sometimes cut, grown or with a part copied to elsewhere.
inline std::string damaged(std::string bytes, uint64_t key) {
    uint64_t draw = 0;
    const auto below = [&](size_t n) { return size_t(hash(key, draw++) % n); };
    const size_t changes = 1 + below(3);
    for (size_t c = 0; c < changes; ++c) {
        const size_t at = below(bytes.size());
        const size_t kind = below(4);
        if (kind == 0) bytes[at] = char(below(256));
        if (kind == 1) bytes[at] = char(bytes[at] ^ (1 << below(8)));
        if (kind == 2) bytes[at] = below(2) ? '\xff' : '\0';
        if (kind == 3) bytes[at] = "0123456789-.eE+{}[]\",: \n"[below(24)];
    }
    const size_t kind = below(8), at = below(bytes.size());
    if (kind == 0) bytes.resize(at);
    if (kind == 1) bytes += bytes.substr(at);
    if (kind == 2) bytes.insert(below(bytes.size()), bytes.substr(at, 40));
    if (kind == 3 && bytes.size() > 8) std::memset(&bytes[below(bytes.size() - 4)], 0xff, 4);
    return bytes;
}

}  // namespace tress::test
