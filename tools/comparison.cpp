// SPDX-License-Identifier: MIT
#include "tools/comparison.h"

#include <cmath>

#include "core/colormap.h"

namespace tress {

Comparison compare(const Image& reference, const Image& test, const std::string& reference_name,
                   const std::string& test_name) {
    check_comparable(reference, test, reference_name, test_name);
    return {image_error(reference, test), hdr_flip(reference, test)};
}

Image flip_picture(const Comparison& comparison, int width, int height) {
    Image image = make_image(width, height);
    for (size_t i = 0; i < image.pixel.size(); ++i) image.pixel[i] = heat_color(comparison.flip.flip.error[i]);
    return image;
}

nlohmann::ordered_json json_number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

}  // namespace tress
