// SPDX-License-Identifier: MIT
#include "io/json_fields.h"

#include <algorithm>

#include "core/nearest_name.h"

namespace tress {

void get(const JsonValue& object, const char* key, float& target, double lowest, double highest) {
    if (const auto value = object.find(key)) target = float(value->number(lowest, highest));
}
void get(const JsonValue& object, const char* key, double& target, double lowest, double highest) {
    if (const auto value = object.find(key)) target = value->number(lowest, highest);
}
void get(const JsonValue& object, const char* key, Rgb& target, double highest) {
    if (const auto value = object.find(key)) target = value->rgb(0, highest);
}
void get(const JsonValue& object, const char* key, DVec3& target) {
    if (const auto value = object.find(key)) target = value->vector();
}

size_t choice(const JsonValue& value, const std::vector<std::string>& names) {
    const auto found = std::find(names.begin(), names.end(), value.text());
    if (found == names.end())
        value.fail("unknown '" + value.text().substr(0, 40) + "', " + did_you_mean(value.text(), names));
    return size_t(found - names.begin());
}

}  // namespace tress
