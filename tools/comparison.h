// SPDX-License-Identifier: MIT
// Two pictures held against each other, by all measures at once.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/flip.h"
#include "core/image_error.h"

namespace tress {

struct Comparison {
    ImageError error;
    HdrFlipResult flip;
};

/// Throws InputError as check_comparable does; the names say which picture is meant.
Comparison compare(const Image& reference, const Image& test, const std::string& reference_name,
                   const std::string& test_name);

/// The FLIP error of every pixel: black 0, pale yellow 1.
Image flip_picture(const Comparison& comparison, int width, int height);

/// JSON has no infinity and no NaN: null.
nlohmann::ordered_json json_number(double value);

}  // namespace tress
