// SPDX-License-Identifier: MIT
// Writes pictures that are ready to be seen: 8 bits a channel, sRGB.
#pragma once

#include <string>
#include <vector>

#include "core/image.h"

namespace tress {

/// `image` holds linear values in [0, 1] after any tone curve; what is outside is clamped, NaN is black. The sRGB curve
/// (IEC 61966-2-1) is applied here. A noise of half a code value, the same for a pixel's channels and keyed by its
/// place alone, keeps smooth shades from banding; values that 8 bits hold exactly are not changed by it.
std::vector<unsigned char> png_bytes(const Image& image);

/// The same as a file, whole or not at all.
void write_png(const std::string& path, const Image& image);

}  // namespace tress
