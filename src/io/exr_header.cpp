// SPDX-License-Identifier: MIT
// Layout after "OpenEXR File Layout" (openexr.com): magic, version, attributes up to an empty name, offsets, pixels.
#include "io/exr_header.h"

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

void check_preview(ByteReader& in, uint32_t bytes) {
    const uint64_t width = in.read<uint32_t>("preview"), height = in.read<uint32_t>("preview");
    if (width * height != (uint64_t(bytes) - 8) / 4) in.fail("a preview that is not as long as it says");
}

}  // namespace

void check_exr_header(const std::string& path) {
    ByteReader in(path);
    if (in.size() < 8 || in.read<uint32_t>("magic") != kMagic)
        throw InputError(path + ": byte 0", "no OpenEXR file, expected the bytes 76 2f 31 01");
    const uint32_t version = in.read<uint32_t>("version");
    if ((version & kVersionMask) != kVersion || (version & ~kVersionMask & ~kKnownFlags))
        in.fail("a file of version or kind " + std::to_string(version) + ", expected one flat picture of version 2");

    Window window;
    uint64_t channels = 0;
    for (std::string name = read_name(in); !name.empty(); name = read_name(in)) {
        const std::string type = read_name(in);
        const uint32_t bytes = in.read<uint32_t>("length of an attribute");
        in.need(bytes, 1, "an attribute");
        const uint64_t end = in.offset() + bytes;
        if (name == "dataWindow") window = read_window(in);
        if (name == "channels") channels = read_channels(in);
        if (name == "tiles") check_tiles(in);
        if (type == "preview" && bytes >= 8) check_preview(in, bytes);
        in.seek(end, "the next attribute");
    }
    if (window.width() < 1 || channels == 0) throw InputError(path, "a header without dataWindow or channels");
    const uint64_t pixel_bytes = uint64_t(window.width()) * uint64_t(window.height()) * channels * sizeof(float);
    if (pixel_bytes > kAlwaysAllowed && pixel_bytes / kMostCompression > in.size())
        throw InputError(path, std::to_string(window.width()) + " x " + std::to_string(window.height()) +
                                   " pixels of " + std::to_string(channels) + " channels, expected no more than " +
                                   std::to_string(in.size()) + " bytes can hold");
}

}  // namespace tress
