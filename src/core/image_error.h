// SPDX-License-Identifier: MIT
// Measures of the difference between a picture and a reference, summed in double, pixel after pixel. A value that is
// not finite has no error that means anything: it is refused, naming its pixel.
#pragma once

#include "core/image.h"

namespace tress {

struct ImageError {
    double relmse = 0;          // mean of (x - r)^2 / (r^2 + 0.01) over pixels and channels
    double relmse_trimmed = 0;  // the same without the worst 0.01 % of pixels (rounded down: none of fewer than 10,000)
    double rmse = 0;
    double peak = 0;        // of psnr: the largest channel of the reference, or 1 where that is not positive
    double psnr = 0;        // 20 log10(peak / rmse), dB; infinite where the pictures are equal
    double mean_ratio = 1;  // mean of the test / mean of the reference, over pixels and channels; 0 / 0 is 1
};

/// Throws as check_comparable does.
ImageError image_error(const Image& reference, const Image& test);

/// Throws InputError where the sizes differ, or naming the first pixel that is not finite.
/// The names say which picture is meant ("ref.exr").
void check_comparable(const Image& reference, const Image& test, const std::string& reference_name = "reference",
                      const std::string& test_name = "test");

}  // namespace tress
