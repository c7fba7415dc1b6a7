// SPDX-License-Identifier: MIT
// Layout after "OpenEXR File Layout" (openexr.com): magic, version, attributes up to an empty name, offsets, pixels.
#include "io/exr_header.h"

#include <set>

#include "core/error.h"
#include "io/byte_reader.h"

namespace tress {
namespace {

constexpr uint32_t kMagic = 20000630, kVersion = 2, kVersionMask = 0xff;
constexpr uint32_t kTiled = 0x200, kLongNames = 0x400, kKnownFlags = kTiled | kLongNames;
constexpr size_t kLongestName = 255;
constexpr int64_t kLargestSide = 1 << 17;
constexpr int64_t kLargestTile = 1 << 12;  // pixels a side
/// Bytes of pixels a byte of the file may stand for: zlib reaches 1032, DWA's runs of zeros a few times that.
constexpr uint64_t kMostCompression = 4096;
constexpr uint64_t kAlwaysAllowed = uint64_t(64) << 20;  // bytes of pixels, however short the file

std::string read_name(ByteReader& in) {
    std::string name;
    for (char c = in.read<char>("a name"); c != 0; c = in.read<char>("a name")) {
        name += c;
        if (name.size() > kLongestName) in.fail("a name of more than 255 letters, expected an attribute's");
    }
    return name;
}

struct Window {
    int32_t corner[4] = {0, 0, -1, -1};  // x and y of the first pixel, of the last
    int64_t width() const { return int64_t(corner[2]) - corner[0] + 1; }
    int64_t height() const { return int64_t(corner[3]) - corner[1] + 1; }
};

Window read_window(ByteReader& in) {
    Window window;
    in.read(std::span(window.corner), "data window");
    for (const int64_t side : {window.width(), window.height()})
        if (side < 1 || side > kLargestSide)
            in.fail("a picture of " + std::to_string(window.width()) + " x " + std::to_string(window.height()) +
                    " pixels, expected sides from 1 to " + std::to_string(kLargestSide));
    return window;
}

/// The number of channels.
uint64_t read_channels(ByteReader& in) {
    uint64_t count = 0;
    while (!read_name(in).empty()) {
        int32_t field[4];  // pixel type, linearity flag, sampling along x, along y
        in.read(std::span(field), "channel");
        if (field[0] < 0 || field[0] > 2) in.fail("a pixel type of " + std::to_string(field[0]) + ", expected 0 to 2");
        if (field[2] != 1 || field[3] != 1) in.fail("a channel of fewer samples than pixels, expected one a pixel");
        ++count;
    }
    if (count == 0) in.fail("no channels, expected some");
    return count;
}

void check_tiles(ByteReader& in) {
    for (int axis = 0; axis < 2; ++axis) {
        const uint32_t side = in.read<uint32_t>("tile size");
        if (side < 1 || side > kLargestTile)
            in.fail("tiles of " + std::to_string(side) + " pixels, expected 1 to " + std::to_string(kLargestTile));
    }
}

void check_preview(ByteReader& in) {
    const uint64_t width = in.read<uint32_t>("preview"), height = in.read<uint32_t>("preview");
    in.skip(width * height, 4, "preview");
}

void check_texts(ByteReader& in, uint64_t end) {
    while (in.offset() < end) in.skip(in.read<uint32_t>("length of a text"), 1, "text");
}

/// Types of attributes whose length the library knows and does not look up: it must be what the file says.
struct FixedType {
    const char* name;
    uint32_t bytes;
};
constexpr FixedType kFixedTypes[] = {
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33f", 36},
    {"m33d", 72},
    {"m44f", 64},
    {"m44d", 128},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2i", 8},
    {"v2f", 8},
    {"v2d", 16},
    {"v3i", 12},
    {"v3f", 12},
    {"v3d", 24},
};

/// What the header says of the pixels.
struct Pixels {
    Window window;
    uint64_t channels = 0;
};

/// An attribute of `bytes` at the reader's place, which is left at its end.
void read_attribute(ByteReader& in, const std::string& name, const std::string& type, uint32_t bytes, Pixels& pixels) {
    in.need(bytes, 1, "an attribute");
    const uint64_t end = in.offset() + bytes;
    for (const FixedType& fixed : kFixedTypes)
        if (type == fixed.name && bytes != fixed.bytes)
            in.fail(std::to_string(bytes) + " bytes of " + type + ", expected " + std::to_string(fixed.bytes));
    if (type == "idmanifest") in.fail("a manifest of ids, expected a picture without");
    if (type == "preview") check_preview(in);
    if (type == "stringvector") check_texts(in, end);
    if (type == "chlist") {
        const uint64_t count = read_channels(in);
        if (name == "channels") pixels.channels = count;
    }
    const bool has_inner_lengths = type == "preview" || type == "stringvector" || type == "chlist";
    if (has_inner_lengths && in.offset() != end) in.fail("an attribute that does not end where it says");
    if (name == "dataWindow" && type == "box2i") pixels.window = read_window(in);
    if (type == "tiledesc") check_tiles(in);
    in.seek(end, "the next attribute");
}

}  // namespace

void check_exr_header(const std::string& path) {
    ByteReader in(path);
    if (in.size() < 8 || in.read<uint32_t>("magic") != kMagic)
        throw InputError(path + ": byte 0", "no OpenEXR file, expected the bytes 76 2f 31 01");
    const uint32_t version = in.read<uint32_t>("version");
    if ((version & kVersionMask) != kVersion || (version & ~kVersionMask & ~kKnownFlags))
        in.fail("a file of version or kind " + std::to_string(version) + ", expected one flat picture of version 2");

    Pixels pixels;
    std::set<std::string> names;
    for (std::string name = read_name(in); !name.empty(); name = read_name(in)) {
        // The library adds up what is said of channels more than once.
        if (!names.insert(name).second) in.fail("an attribute that there has been already, expected each once");
        const std::string type = read_name(in);
        const uint32_t bytes = in.read<uint32_t>("length of an attribute");
        read_attribute(in, name, type, bytes, pixels);
    }
    const auto& [window, channels] = pixels;
    if (window.width() < 1 || channels == 0) throw InputError(path, "a header without dataWindow or channels");
    const uint64_t pixel_bytes = uint64_t(window.width()) * uint64_t(window.height()) * channels * sizeof(float);
    if (pixel_bytes > kAlwaysAllowed && pixel_bytes / kMostCompression > in.size())
        throw InputError(path, std::to_string(window.width()) + " x " + std::to_string(window.height()) +
                                   " pixels of " + std::to_string(channels) + " channels, expected no more than " +
                                   std::to_string(in.size()) + " bytes can hold");
}

}  // namespace tress
