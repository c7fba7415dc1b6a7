// SPDX-License-Identifier: MIT
// Pictures of many layers as OpenEXR files.
#pragma once

#include <string>

#include "core/image.h"

namespace tress {

/// One part, 32-bit floats, ZIP; the layer "" as R, G, B, A, others as NAME.CHANNEL; metadata as text attributes. The
/// same picture gives the same bytes. Written whole or not at all.
void write_exr(const std::string& path, const LayeredImage& image);

/// Layers in the order of their names, "" first; channels as R, G, B, A, then others by name; text attributes only.
LayeredImage read_exr(const std::string& path);

/// The colours of the layer "" (R, G, B, or Y alone) of any flat OpenEXR picture. Light has no other values: what is
/// negative or NaN becomes 0, what is infinite the largest half, 65504.
Image read_environment(const std::string& path);

}  // namespace tress
