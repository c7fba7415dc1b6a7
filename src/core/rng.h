// SPDX-License-Identifier: MIT
// Counter-based random numbers: the value is a function of its key, so no thread or order can change it.
#pragma once

#include <cstdint>

namespace tress {

/// Bijective 64-bit mixer (Steele, Lea, Flood 2014, as constants by Stafford, "Mix13").
constexpr uint64_t mix(uint64_t v) {
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
    return v ^ (v >> 31);
}

/// Key made of an older key and one more number: hash(hash(seed, pixel), sample) …
constexpr uint64_t hash(uint64_t key, uint64_t value) { return mix(key + 0x9e3779b97f4a7c15ull * (value + 1)); }

/// Uniform in [0, 1), 24 bits.
constexpr float unit_float(uint64_t bits) { return float(bits >> 40) * 0x1p-24f; }

/// The `index`-th number of the stream `key`, uniform in [0, 1).
constexpr float random(uint64_t key, uint64_t index) { return unit_float(hash(key, index)); }

}  // namespace tress
