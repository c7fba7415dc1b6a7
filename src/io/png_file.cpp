// SPDX-License-Identifier: MIT
#include "io/png_file.h"

#include <png.h>

#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/rng.h"
#include "io/whole_file.h"

namespace tress {
namespace {

constexpr double kLargestCode = 255;
constexpr uint64_t kDitherKey = 0x706e67;
constexpr uint64_t kDitherLevels = 256;  // within a code value; even ends keep exact codes exact

double srgb_from_linear(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

/// In (0, 1), never nearer to its ends than half a dither level.
double dither(uint64_t pixel) {
    return (double(hash(kDitherKey, pixel) % kDitherLevels) + 0.5) / double(kDitherLevels);
}

unsigned char code(float linear, double noise) {
    const double v = linear > 0 ? std::min(double(linear), 1.0) : 0;  // NaN: 0
    return static_cast<unsigned char>(std::min(kLargestCode * srgb_from_linear(v) + noise, kLargestCode));
}

}  // namespace

std::vector<unsigned char> png_bytes(const Image& image) {
    if (image.empty()) throw InputError("picture", "an empty one, expected pixels");
    std::vector<unsigned char> codes;
    codes.reserve(image.pixel.size() * 3);
    for (size_t p = 0; p < image.pixel.size(); ++p) {
        const double noise = dither(p);
        for (int c = 0; c < 3; ++c) codes.push_back(code(image.pixel[p][c], noise));
    }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> file(PNG_IMAGE_PNG_SIZE_MAX(png));
    png_alloc_size_t bytes = file.size();
    if (!png_image_write_to_memory(&png, file.data(), &bytes, 0, codes.data(), 0, nullptr))
        throw InputError("picture", std::string("cannot be made a PNG: ") + png.message);
    file.resize(bytes);
    return file;
}

void write_png(const std::string& path, const Image& image) {
    const std::vector<unsigned char> file = png_bytes(image);
    WholeFile out(path);
    out.write(file.data(), file.size());
    out.commit();
}

}  // namespace tress
