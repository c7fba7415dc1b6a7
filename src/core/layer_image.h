// SPDX-License-Identifier: MIT
// One layer of a file of many as a picture.
#pragma once

#include <string_view>

#include "core/image.h"

namespace tress {

/// Channels R, G, B of the layer `name` ("": the beauty); a layer without them must have one channel, shown as grey.
/// Throws InputError that says `where` and names the layers that there are.
Image layer_image(const LayeredImage& image, std::string_view name, const std::string& where);

}  // namespace tress
