// SPDX-License-Identifier: MIT
// .hair files field by field, whatever their headers claim.
#pragma once

#include <cstdint>
#include <string>

#include "tools/check/support/folder.h"

namespace tress::test {

/// A .hair file of raw fields: header, then `arrays` bytes.
inline std::string raw_hair(uint32_t strands, uint32_t points, uint32_t flags, uint32_t segments,
                            const std::string& arrays) {
    std::string bytes = "HAIR";
    for (const uint32_t field : {strands, points, flags, segments}) append(bytes, field);
    for (const float field : {0.1f, 0.0f, 1.0f, 1.0f, 1.0f}) append(bytes, field);
    return bytes + std::string(88, '\0') + arrays;
}

inline std::string point_bytes(size_t count, float value = 1) {
    std::string bytes;
    for (size_t i = 0; i < 3 * count; ++i) append(bytes, value + float(i));
    return bytes;
}

}  // namespace tress::test
