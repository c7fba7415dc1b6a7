// SPDX-License-Identifier: MIT
#include "gather/projection/hair_opacity.h"

#include <cmath>
#include <unordered_map>

namespace tress {
namespace {

constexpr size_t kMostKinds = 65536;
constexpr uint32_t kFinest = 128, kCoarsest = 4;  // steps of sigma_a / (1 + sigma_a)

struct KindKey {
    uint16_t fiber;
    uint8_t step[3];

    uint64_t number() const { return uint64_t(fiber) << 24 | uint64_t(step[0]) << 16 | step[1] << 8 | step[2]; }
};

float absorbed(float sigma_a) { return std::isinf(sigma_a) ? 1.0f : sigma_a / (1 + sigma_a); }
Rgb absorbed(const Rgb& sigma_a) { return {absorbed(sigma_a.x), absorbed(sigma_a.y), absorbed(sigma_a.z)}; }

float sigma_of(float absorbed) { return absorbed < 1 ? absorbed / (1 - absorbed) : kInfinity; }

uint16_t fiber_of(const Attenuation& a, size_t segment) {
    return a.fiber_of_segment.empty() ? uint16_t(0) : a.fiber_of_segment[segment];
}

/// Adds the rows of a kind whose depth at an inclination is depth(abs_sin_theta).
template <class Depth>
void add_kind(HairOpacity& o, const Depth& depth) {
    for (int row = 0; row < kOpacityRows; ++row) {
        const float cos_theta = float(row) / float(kOpacityRows - 1);
        const Rgb d = depth(safe_sqrt(1 - cos_theta * cos_theta));
        Rgbx opacity;
        for (int c = 0; c < 3; ++c) opacity.c[c] = -std::expm1(-d[c]);
        o.gray = o.gray && opacity.c[0] == opacity.c[1] && opacity.c[1] == opacity.c[2];
        o.row.push_back(opacity);
    }
}

/// Kinds by fiber and absorption in steps of 1 / steps; false: there are too many.
bool sort_by_color(const Attenuation& a, uint32_t steps, HairOpacity& o) {
    o = {};
    std::unordered_map<uint64_t, uint16_t> known;
    for (size_t segment = 0; segment < a.sigma_a.size(); ++segment) {
        const Rgb color = absorbed(a.sigma_a[segment]);
        KindKey key{fiber_of(a, segment), {}};
        for (int c = 0; c < 3; ++c) key.step[c] = uint8_t(std::lround(color[c] * float(steps)));
        const auto [kind, added] = known.try_emplace(key.number(), uint16_t(known.size()));
        if (known.size() > kMostKinds) return false;
        o.kind.push_back(kind->second);
        if (!added) continue;
        const Rgb middle = Rgb(key.step[0], key.step[1], key.step[2]) / float(steps);
        const AbsorptionTable& table = a.varying[key.fiber];
        add_kind(o, [&](float sine) {
            return Rgb(table.at(sine, sigma_of(middle.x)), table.at(sine, sigma_of(middle.y)),
                       table.at(sine, sigma_of(middle.z)));
        });
    }
    return true;
}

}  // namespace

HairOpacity make_hair_opacity(const Attenuation& a) {
    HairOpacity o;
    if (!a.sigma_a.empty()) {
        uint32_t steps = kFinest;
        while (!sort_by_color(a, steps, o) && steps > kCoarsest) steps /= 2;
        return o;
    }
    for (size_t fiber = 0; fiber < a.table.size(); ++fiber)
        add_kind(o, [&](float sine) { return a.table[fiber].at(sine); });
    if (a.table.size() > 1) o.kind = a.fiber_of_segment;
    return o;
}

size_t bytes(const HairOpacity& o) { return o.row.capacity() * sizeof(Rgbx) + o.kind.capacity() * sizeof(uint16_t); }

}  // namespace tress
