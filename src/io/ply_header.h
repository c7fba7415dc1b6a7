// SPDX-License-Identifier: MIT
// The header of a .ply file: which elements follow, and what each is made of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/byte_reader.h"

namespace tress {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

uint64_t bytes(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;                        // of the value, or of the items of a list
    std::optional<PlyType> list_length;  // of a list: the type of its length
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Place of the property `name`, or -1.
    int find(const std::string& name) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    size_t lines = 0;
};

/// Reads up to and with the line "end_header". Throws InputError that names the line.
PlyHeader read_ply_header(ByteReader& in);

}  // namespace tress
