// SPDX-License-Identifier: MIT
#include <png.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/rng.h"
#include "io/exr_file.h"
#include "io/png_file.h"
#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

LayeredImage sample_picture() {
    LayeredImage image;
    image.width = 37;
    image.height = 21;
    const std::pair<std::string, std::vector<std::string>> layers[] = {
        {"", {"R", "G", "B", "A"}}, {"albedo", {"R", "G", "B"}}, {"depth", {"Z"}}, {"type1", {"R", "G", "B"}}};
    for (const auto& [name, channels] : layers) {
        Layer layer{name, channels, {}};
        const size_t values = size_t(image.width * image.height) * channels.size();
        for (size_t i = 0; i < values; ++i) layer.data.push_back(1000 * random(name.size(), i) - 10);
        image.layers.push_back(layer);
    }
    image.layers[2].data[5] = kInfinity;
    image.layers[0].data[0] = 1e30f;  // over a half's range
    image.metadata = {{"accel.bins", "32"}, {"seed", "0"}, {"version", "a name with \xc3\xa4"}};
    return image;
}

/// An .exr file whose data window is replaced.
std::string with_window(std::string bytes, const int32_t (&window)[4]) {
    const std::string name("dataWindow\0box2i\0", 17);
    const size_t at = bytes.find(name) + name.size() + 4;
    std::memcpy(&bytes[at], window, sizeof window);
    return bytes;
}

std::vector<unsigned char> read_png(const std::string& path, int& width, int& height) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&png, path.c_str()));
    png.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> codes(PNG_IMAGE_SIZE(png));
    REQUIRE(png_image_finish_read(&png, nullptr, codes.data(), 0, nullptr));
    width = int(png.width);
    height = int(png.height);
    return codes;
}

double linear_from_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

}  // namespace

TEST_CASE("layers and metadata of an .exr file are read as they were written") {
    const Folder folder;
    const LayeredImage image = sample_picture();
    write_exr(folder.file("a.exr"), image);
    const LayeredImage read = read_exr(folder.file("a.exr"));
    CHECK(read.width == image.width);
    CHECK(read.height == image.height);
    CHECK(read.metadata == image.metadata);
    REQUIRE(read.layers.size() == image.layers.size());
    for (size_t l = 0; l < read.layers.size(); ++l) {
        CHECK(read.layers[l].name == image.layers[l].name);
        CHECK(read.layers[l].channels == image.layers[l].channels);
        CHECK(read.layers[l].data == image.layers[l].data);
    }
    write_exr(folder.file("b.exr"), image);
    CHECK(read_bytes(folder.file("a.exr")) == read_bytes(folder.file("b.exr")));
    CHECK(folder.entries() == 2);
}

TEST_CASE("an .exr file that cannot be written leaves nothing behind") {
    const Folder folder;
    CHECK(is_one_line(message_of([&] { write_exr(folder.file("none/a.exr"), sample_picture()); })));
    LayeredImage bad = sample_picture();
    bad.metadata.emplace_back("compression", "zip");  // not a text in the format
    CHECK(is_one_line(message_of([&] { write_exr(folder.file("a.exr"), bad); })));
    CHECK(folder.entries() == 0);
}

TEST_CASE("an environment is the colours of the plain layer, cleaned of what is no light") {
    const Folder folder;
    LayeredImage image = sample_picture();
    for (size_t c = 0; c < 3; ++c)
        image.layers[0].data[4 + c] = c == 0 ? -1 : c == 1 ? kInfinity : std::numeric_limits<float>::quiet_NaN();
    write_exr(folder.file("a.exr"), image);
    const Image sky = read_environment(folder.file("a.exr"));
    CHECK(sky.at(1, 0) == Rgb(0, 65504, 0));
    const float* pixel = &image.layers[0].data[4 * (3 * 37 + 2)];
    CHECK(sky.at(2, 3) == max(Rgb(pixel[0], pixel[1], pixel[2]), Rgb(0)));
    image.layers.erase(image.layers.begin());
    write_exr(folder.file("a.exr"), image);
    CHECK(contains(message_of([&] { read_environment(folder.file("a.exr")); }), "no channels R, G and B"));
}

TEST_CASE("an .exr file that is text, cut or absurd is refused in one line") {
    const Folder folder;
    write_exr(folder.file("a.exr"), sample_picture());
    const std::string good = read_bytes(folder.file("a.exr"));
    const int32_t huge[4] = {0, 0, 999999999, 999999999}, turned[4] = {5, 5, 0, 0}, wide[4] = {0, 0, 100000, 100000};
    const int32_t extreme[4] = {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
    for (const std::string& bytes :
         {std::string("a text that is no picture"), std::string(), good.substr(0, 4), good.substr(0, 100),
          good.substr(0, good.size() / 2), good.substr(0, good.size() - 1), with_window(good, huge),
          with_window(good, turned), with_window(good, wide), with_window(good, extreme)}) {
        write_bytes(folder.file("bad.exr"), bytes);
        const std::string message = message_of([&] { read_exr(folder.file("bad.exr")); });
        CAPTURE(message);
        CHECK(is_one_line(message));
        CHECK(contains(message, "bad.exr"));
    }
    CHECK(contains(message_of([&] { read_exr(folder.path()); }), "a directory"));
}

TEST_CASE("an .exr file that says its channels twice is refused: the library would make room for both") {
    const Folder folder;
    write_exr(folder.file("a.exr"), sample_picture());
    std::string bytes = read_bytes(folder.file("a.exr"));
    const size_t at = bytes.find(std::string("channels\0chlist\0", 16));
    REQUIRE(at != std::string::npos);
    uint32_t length = 0;
    std::memcpy(&length, &bytes[at + 16], sizeof length);
    bytes.insert(at, bytes.substr(at, 20 + length));
    write_bytes(folder.file("bad.exr"), bytes);
    const std::string message = message_of([&] { read_exr(folder.file("bad.exr")); });
    CAPTURE(message);
    CHECK(is_one_line(message));
    CHECK(contains(message, "expected each once"));
}

TEST_CASE("real environment maps decode") {
    for (const char* name : {"env/studio.exr", "env/venice.exr", "env/sky.exr"}) {
        const auto path = real_file(name);
        if (!path) continue;
        const Image image = read_environment(*path);
        CHECK(image.width == 512);
        CHECK(image.height == 256);
        double sum = 0;
        for (const Rgb& pixel : image.pixel) sum += mean(pixel);
        CHECK(sum / double(image.pixel.size()) > 0.01);
        CHECK(sum / double(image.pixel.size()) < 1000);
    }
}

TEST_CASE("a .png file holds exactly the codes of values that 8 bits hold") {
    const Folder folder;
    Image image = make_image(256, 40);  // every code at 40 places of the noise
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = {float(linear_from_srgb(x / 255.0)), float(linear_from_srgb((255 - x) / 255.0)), 0};
    write_png(folder.file("a.png"), image);
    int width = 0, height = 0;
    const std::vector<unsigned char> codes = read_png(folder.file("a.png"), width, height);
    REQUIRE(width == 256);
    REQUIRE(height == 40);
    size_t wrong = 0;
    for (size_t p = 0; p < image.pixel.size(); ++p) {
        const size_t x = p % 256;
        wrong += codes[3 * p] != x || codes[3 * p + 1] != 255 - x || codes[3 * p + 2] != 0;
    }
    CHECK(wrong == 0);
}

TEST_CASE("between two codes a .png file is right on average, and grey stays grey") {
    const Folder folder;
    const double shade = 100.3;
    Image image = make_image(200, 200);
    for (Rgb& pixel : image.pixel) pixel = Rgb(float(linear_from_srgb(shade / 255)));
    write_png(folder.file("a.png"), image);
    int width = 0, height = 0;
    const std::vector<unsigned char> codes = read_png(folder.file("a.png"), width, height);
    double sum = 0;
    for (size_t p = 0; p < image.pixel.size(); ++p) {
        sum += codes[3 * p];
        REQUIRE(codes[3 * p] == codes[3 * p + 1]);
        REQUIRE(codes[3 * p] == codes[3 * p + 2]);
    }
    // A coin of odds 0.3 thrown 40,000 times: five standard deviations.
    CHECK(std::abs(sum / 40000 - shade) < 5 * std::sqrt(0.3 * 0.7 / 40000));
}

TEST_CASE("values outside what a .png file holds are clamped") {
    const Folder folder;
    Image image = make_image(3, 1);
    image.at(0, 0) = Rgb(-1);
    image.at(1, 0) = Rgb(kInfinity);
    image.at(2, 0) = Rgb(std::numeric_limits<float>::quiet_NaN());
    write_png(folder.file("a.png"), image);
    int width = 0, height = 0;
    CHECK(read_png(folder.file("a.png"), width, height) == std::vector<unsigned char>{0, 0, 0, 255, 255, 255, 0, 0, 0});
    CHECK(is_one_line(message_of([&] { write_png(folder.file("none/a.png"), image); })));
    CHECK(folder.entries() == 1);
}
