// SPDX-License-Identifier: MIT
// 1 - a_k(theta) of every kind of fiber in a scene, as rows that projection looks up with one number: kind and
// inclination together. Strands with colours of their own are sorted into kinds of nearly equal absorption.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/attenuation.h"

namespace tress {

/// A colour as four floats: one aligned load.
struct alignas(16) Rgbx {
    float c[4] = {0, 0, 0, 0};

    Rgbx& operator+=(const Rgbx& o) {
        for (int i = 0; i < 4; ++i) c[i] += o.c[i];
        return *this;
    }
};

inline constexpr int kOpacityRows = 128;  // a kind; even in cos(theta), row 0 is grazing

/// Row of a kind, for cos_theta in [0, 1].
inline int32_t opacity_row(float cos_theta) { return int32_t(std::nearbyint(cos_theta * float(kOpacityRows - 1))); }

struct HairOpacity {
    std::vector<Rgbx> row;       // kinds x kOpacityRows
    std::vector<uint16_t> kind;  // one a segment, or empty: all of kind 0
    bool gray = true;            // every kind is: one channel says all

    size_t kinds() const { return row.size() / kOpacityRows; }
    uint32_t kind_of(uint32_t segment) const { return kind.empty() ? 0 : kind[segment]; }
};

/// `attenuation` with its tables. At most 65536 kinds, absorptions told apart to 1/128 of
/// sigma_a / (1 + sigma_a), coarser where there would be more.
HairOpacity make_hair_opacity(const Attenuation& attenuation);

size_t bytes(const HairOpacity& opacity);

}  // namespace tress
