// SPDX-License-Identifier: MIT
// Errors of a picture's layers against a reference's, as lines of a study have them. The beauty is called "whole".
#pragma once

#include <string>
#include <vector>

#include "core/image.h"
#include "tools/study/study_log.h"

namespace tress {

inline constexpr const char* kWhole = "whole";

/// "whole", then type1 to type5 as far as the picture has them.
std::vector<std::string> study_layers(const LayeredImage& picture);
bool has_layer(const LayeredImage& picture, const std::string& name);
/// The layer as a picture; `where` is for the message.
Image study_layer(const LayeredImage& picture, const std::string& name, const std::string& where);

/// {"whole": {"relmse", "relmse_trimmed", "mean_ratio", "flip"}, "type1": ...}: layers of the reference that the
/// picture has too.
Json picture_errors(const LayeredImage& reference, const LayeredImage& picture, const std::string& where);

/// The mean of two halves of equal size, and its error: relMSE of what the two differ by, a quarter of it (the
/// variance of a mean of two).
LayeredImage mean_of(const LayeredImage& a, const LayeredImage& b);
Json error_of_mean(const LayeredImage& a, const LayeredImage& b);  // {"whole": relMSE, ...}

}  // namespace tress
