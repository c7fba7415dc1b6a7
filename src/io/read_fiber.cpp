// SPDX-License-Identifier: MIT
#include "io/read_fiber.h"

#include <charconv>

#include "core/error.h"
#include "io/json_fields.h"

namespace tress {
namespace {

JsonNode number_or_text(const std::string& text) {
    double value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size();
    return {number ? JsonNode::Kind::number : JsonNode::Kind::text, text, {}, {}};
}

JsonNode value_node(const std::string& text) {
    if (text.find(',') == std::string::npos) return number_or_text(text);
    JsonNode array{JsonNode::Kind::array, {}, {}, {}};
    for (size_t start = 0; start <= text.size();) {
        const size_t end = std::min(text.find(',', start), text.size());
        array.items.push_back(number_or_text(text.substr(start, end - start)));
        start = end + 1;
    }
    return array;
}

}  // namespace

FiberDescription read_fiber(const JsonValue& object, FiberDescription fiber) {
    object.check_keys({"model", "eumelanin", "pheomelanin", "sigma_a", "color", "beta_m", "beta_n", "alpha", "eta"});
    FiberParameters& p = fiber.parameters;
    if (const auto model = object.find("model")) p.model = FiberModel(choice(*model, {"chiang", "marschner"}));
    // Ranges are make_fiber's to know; here only what a float holds.
    get(object, "beta_m", p.beta_m, -kLargestNumber, kLargestNumber);
    get(object, "beta_n", p.beta_n, -kLargestNumber, kLargestNumber);
    get(object, "alpha", p.alpha_degrees, -kLargestNumber, kLargestNumber);
    get(object, "eta", p.eta, -kLargestNumber, kLargestNumber);

    const bool has_melanin = object.has("eumelanin") || object.has("pheomelanin");
    if (has_melanin + object.has("sigma_a") + object.has("color") > 1)
        object.fail("more than one of eumelanin (with pheomelanin), sigma_a and color, expected one");
    if (has_melanin) {
        const Melanin* before = std::get_if<Melanin>(&fiber.absorption);
        Melanin melanin = before ? *before : Melanin{0, 0};
        get(object, "eumelanin", melanin.eumelanin, 0, kLargestNumber);
        get(object, "pheomelanin", melanin.pheomelanin, 0, kLargestNumber);
        fiber.absorption = melanin;
    }
    if (const auto value = object.find("sigma_a")) fiber.absorption = SigmaA{value->rgb()};
    if (const auto value = object.find("color")) fiber.absorption = FiberColor{value->rgb(0, 1)};
    return fiber;
}

FiberDescription read_fiber(std::span<const std::string> assignments, const std::string& where,
                            FiberDescription fiber) {
    JsonNode object{JsonNode::Kind::object, {}, {}, {}};
    for (const std::string& assignment : assignments) {
        const size_t equals = assignment.find('=');
        if (equals == std::string::npos) throw InputError(where, "'" + assignment + "', expected key=value");
        const std::string key = assignment.substr(0, equals);
        if (object.find(key)) throw InputError(where, key + " given twice, expected it once");
        object.keys.push_back(key);
        object.items.push_back(value_node(assignment.substr(equals + 1)));
    }
    return read_fiber(JsonValue(object, where), std::move(fiber));
}

}  // namespace tress
