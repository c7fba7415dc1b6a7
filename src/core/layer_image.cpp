// SPDX-License-Identifier: MIT
#include "core/layer_image.h"

#include <algorithm>
#include <array>

#include "core/error.h"

namespace tress {
namespace {

std::string shown(std::string_view name) {
    if (name.empty()) return "the beauty";
    std::string text = "'";
    return text.append(name).append("'");
}

const Layer& find_layer(const LayeredImage& image, std::string_view name, const std::string& where) {
    std::string known;
    for (const Layer& layer : image.layers) {
        if (layer.name == name) return layer;
        known += (known.empty() ? "" : ", ") + shown(layer.name);
    }
    throw InputError(where, "found no layer " + shown(name) + ", expected one of: " + (known.empty() ? "none" : known));
}

/// Places of R, G, B among the channels; of the only channel, thrice, where there is one.
std::array<size_t, 3> rgb_channels(const Layer& layer, const std::string& where) {
    if (layer.channels.size() == 1) return {0, 0, 0};
    std::array<size_t, 3> place{};
    for (size_t c = 0; c < 3; ++c) {
        const std::string wanted(1, "RGB"[c]);
        const auto found = std::find(layer.channels.begin(), layer.channels.end(), wanted);
        if (found == layer.channels.end())
            throw InputError(where, "layer " + shown(layer.name) + " has no channel " + wanted +
                                        ", expected R, G and B, or a single channel");
        place[c] = size_t(found - layer.channels.begin());
    }
    return place;
}

}  // namespace

Image layer_image(const LayeredImage& image, std::string_view name, const std::string& where) {
    const Layer& layer = find_layer(image, name, where);
    const std::array<size_t, 3> place = rgb_channels(layer, where);
    Image out = make_image(image.width, image.height);
    for (size_t i = 0; i < out.pixel.size(); ++i) {
        const float* values = layer.data.data() + i * layer.channels.size();
        out.pixel[i] = {values[place[0]], values[place[1]], values[place[2]]};
    }
    return out;
}

}  // namespace tress
