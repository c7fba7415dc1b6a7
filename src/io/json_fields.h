// SPDX-License-Identifier: MIT
// Keys that may be absent, and texts that name one of a few things.
#pragma once

#include "io/json_value.h"

namespace tress {

/// Sets `target` where the object has `key`.
void get(const JsonValue& object, const char* key, float& target, double lowest, double highest);
void get(const JsonValue& object, const char* key, double& target, double lowest, double highest);
void get(const JsonValue& object, const char* key, Rgb& target, double highest = kLargestNumber);
void get(const JsonValue& object, const char* key, DVec3& target);

/// Which of `names` a text is.
size_t choice(const JsonValue& value, const std::vector<std::string>& names);

}  // namespace tress
