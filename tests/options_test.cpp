// SPDX-License-Identifier: MIT
#include "core/options.h"

#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <set>

#include "core/error.h"

using namespace tress;

TEST_CASE("every option reads back the text it writes") {
    Options options;
    for (const OptionField& field : option_fields(options)) {
        CAPTURE(field.key);
        const std::string before = option_text(field);
        CHECK_NOTHROW(set_option(options, "test", field.key, before));
        CHECK(option_text(field) == before);
    }
}

TEST_CASE("both ends of a stated range are accepted") {
    Options options;
    for (const OptionField& field : option_fields(options)) {
        if (std::holds_alternative<bool*>(field.value) || std::holds_alternative<Choice>(field.value)) continue;
        for (const double end : {field.lowest, field.highest}) {
            if (end > 1e15) continue;  // of the seed: its text has an exponent
            char text[64];
            *std::to_chars(text, text + sizeof text, end, std::chars_format::general).ptr = 0;
            const bool whole = end == std::floor(end) && end < 1e15;
            CAPTURE(field.key);
            CHECK_NOTHROW(set_option(options, "test", field.key, whole ? std::to_string(int64_t(end)) : text));
        }
    }
}

TEST_CASE("option keys are unique and explained") {
    Options options;
    std::set<std::string> keys;
    for (const OptionField& field : option_fields(options)) {
        CAPTURE(field.key);
        CHECK(keys.insert(field.key).second);
        CHECK_FALSE(field.help.empty());
    }
}

TEST_CASE("a bad option is refused in one line that says what was expected") {
    Options options;
    const std::pair<const char*, const char*> bad[] = {
        {"spp", "0"},        {"spp", "-1"},   {"spp", "4x"},  {"spp", ""},          {"cutoff", "nan"},  {"isa", "mmx"},
        {"accel.clip", "2"}, {"time", "inf"}, {"seed", "-1"}, {"type1", "deepest"}, {"threads", "1e3"},
    };
    for (const auto& [key, text] : bad) {
        CAPTURE(key);
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(set_option(options, "--set", key, text), doctest::Contains("expected"), InputError);
    }
    CHECK_THROWS_WITH_AS(set_option(options, "--set", "acel.bins", "8"), doctest::Contains("accel.bins"), InputError);
}
