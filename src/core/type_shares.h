// SPDX-License-Identifier: MIT
// What each type of light paths contributes to a picture.
#pragma once

#include <vector>

#include "core/film.h"

namespace tress {

/// Where light is counted: everywhere, or in each pixel in proportion to how much of it hair covers.
enum class ShareOf { picture, hair };

/// Of one type: the mean luminance over pixels, and its share of the sum of all types. Standard errors are from the
/// spread of the samples within pixels: for low-discrepancy samples an upper estimate; 0 at one sample a pixel.
struct TypeShare {
    PathType type;
    double mean = 0, mean_error = 0;
    double percent = 0, percent_error = 0;
};

/// One for each type that the film holds.
std::vector<TypeShare> type_shares(const Film& film, ShareOf where);

}  // namespace tress
