// SPDX-License-Identifier: MIT
#include "core/sampler.h"

#include <array>
#include <cassert>

#include "core/rng.h"

namespace tress {
namespace {

constexpr int kBits = 32, kBytes = 4, kByteValues = 256;

/// A primitive polynomial x^s + a_1 x^(s-1) + ... + 1 and the first s direction integers m (Joe & Kuo 2008, their table
/// "new-joe-kuo-6", dimensions 2 to 4; dimension 1 is van der Corput's).
struct Polynomial {
    int degree;
    uint32_t coefficients;  // a_1 .. a_(s-1), a_1 in the highest place
    uint32_t initial[3];
};
constexpr Polynomial kPolynomials[kSobolGroup - 1] = {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}};

using Directions = std::array<uint32_t, kBits>;

constexpr Directions van_der_corput() {
    Directions v{};
    for (int i = 0; i < kBits; ++i) v[i] = 1u << (kBits - 1 - i);
    return v;
}

/// Bratley & Fox 1988, the recurrence of eq. 2, on numbers shifted to the top of 32 bits.
constexpr Directions directions(const Polynomial& p) {
    Directions v{};
    for (int i = 0; i < p.degree; ++i) v[i] = p.initial[i] << (kBits - 1 - i);
    for (int i = p.degree; i < kBits; ++i) {
        v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
        for (int k = 1; k < p.degree; ++k)
            if ((p.coefficients >> (p.degree - 1 - k)) & 1) v[i] ^= v[i - k];
    }
    return v;
}

/// Sum (exclusive or) of directions for every value of every byte of an index: 4 look-ups in place of 32 steps.
using ByteTable = std::array<std::array<uint32_t, kByteValues>, kBytes>;

constexpr ByteTable byte_table(const Directions& v) {
    ByteTable table{};
    for (int byte = 0; byte < kBytes; ++byte)
        for (int value = 1; value < kByteValues; ++value)
            for (int bit = 0; bit < 8; ++bit)
                if ((value >> bit) & 1) table[byte][value] ^= v[8 * byte + bit];
    return table;
}

constexpr ByteTable kTables[kSobolGroup] = {byte_table(van_der_corput()), byte_table(directions(kPolynomials[0])),
                                            byte_table(directions(kPolynomials[1])),
                                            byte_table(directions(kPolynomials[2]))};

uint32_t sobol(uint32_t index, uint32_t dimension) {
    const ByteTable& t = kTables[dimension];
    return t[0][index & 255] ^ t[1][(index >> 8) & 255] ^ t[2][(index >> 16) & 255] ^ t[3][index >> 24];
}

constexpr uint32_t reverse_bits(uint32_t v) {
    v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
    v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
    v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
    v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8);
    return (v >> 16) | (v << 16);
}

/// Nested uniform scramble: each bit is flipped by a hash of the bits above it. The hash is of the kind of Laine &
/// Karras 2011 with the operations and constants of Vegdahl 2021, "Building a Better LK Hash", which flips all bits
/// nearly independently; the original does not.
uint32_t scramble(uint32_t v, uint32_t seed) {
    v = reverse_bits(v);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reverse_bits(v);
}

/// What the dimensions of a group share.
struct Group {
    uint64_t key;
    uint32_t index;  // shuffled: aligned blocks of 2^k stay such blocks
};

Group group_of(uint64_t key, uint32_t index, uint32_t dimension) {
    const uint64_t group_key = hash(key, dimension / kSobolGroup);
    return {group_key, scramble(index, uint32_t(group_key >> 32))};
}

float value(const Group& group, uint32_t dimension) {
    const uint32_t place = dimension % kSobolGroup;
    const uint32_t seed = uint32_t(hash(group.key, place) >> 32);
    return float(scramble(sobol(group.index, place), seed) >> 8) * 0x1p-24f;
}

}  // namespace

float sobol_sample(uint64_t key, uint32_t index, uint32_t dimension) {
    return value(group_of(key, index, dimension), dimension);
}

Vec2 sobol_sample2(uint64_t key, uint32_t index, uint32_t first) {
    assert(first % kSobolGroup + 1 < kSobolGroup);
    const Group group = group_of(key, index, first);
    return {value(group, first), value(group, first + 1)};
}

glm::vec4 sobol_sample4(uint64_t key, uint32_t index, uint32_t first) {
    assert(first % kSobolGroup == 0);
    const Group group = group_of(key, index, first);
    return {value(group, first), value(group, first + 1), value(group, first + 2), value(group, first + 3)};
}

}  // namespace tress
