// SPDX-License-Identifier: MIT
// A picture in memory: linear RGB, row by row from the top left.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/math.h"

namespace tress {

struct Image {
    int width = 0, height = 0;
    std::vector<Rgb> pixel;  // width x height

    bool empty() const { return pixel.empty(); }
    Rgb& at(int x, int y) { return pixel[size_t(y) * size_t(width) + size_t(x)]; }
    const Rgb& at(int x, int y) const { return pixel[size_t(y) * size_t(width) + size_t(x)]; }
};

inline Image make_image(int width, int height) {
    return {width, height, std::vector<Rgb>(size_t(width) * size_t(height), Rgb(0))};
}

/// A named set of channels of a film or an EXR file: "" is the beauty (R, G, B, A), "depth" has one channel (Z) …
struct Layer {
    std::string name;
    std::vector<std::string> channels;
    std::vector<float> data;  // interleaved: width x height x channels
};

/// What an EXR file holds: layers of one size, and its metadata as text.
struct LayeredImage {
    int width = 0, height = 0;
    std::vector<Layer> layers;
    std::vector<std::pair<std::string, std::string>> metadata;
};

}  // namespace tress
