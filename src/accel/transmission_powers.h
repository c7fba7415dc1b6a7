// SPDX-License-Identifier: MIT
// transmission^k, and the first k at which it falls below a cutoff.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/math.h"

namespace tress {

/// First k with transmission^k < cutoff, for transmission in [0, 1]; the largest number where there is none.
inline uint32_t first_below(double transmission, double cutoff) {
    constexpr uint32_t kNever = 0xffffffffu;
    if (cutoff > 1) return 0;
    if (!(transmission < 1) || !(cutoff > 0)) return kNever;
    if (transmission == 0) return 1;
    const double estimate = std::log(cutoff) / std::log(transmission);
    if (!(estimate < double(kNever) - 2)) return kNever;
    uint32_t k = uint32_t(estimate);
    while (k > 0 && std::pow(transmission, double(k - 1)) < cutoff) --k;
    while (!(std::pow(transmission, double(k)) < cutoff)) ++k;
    return k;
}

/// Small powers are worked out once each: a batch asks for the same few again and again.
class TransmissionPowers {
public:
    explicit TransmissionPowers(double transmission) : transmission_(transmission) {}

    float operator()(uint32_t k) {
        if (k >= kKept) return float(std::pow(transmission_, double(k)));
        for (; known_ <= k; ++known_) kept_[known_] = float(std::pow(transmission_, double(known_)));
        return kept_[k];
    }

private:
    static constexpr uint32_t kKept = 64;
    double transmission_;
    uint32_t known_ = 0;
    std::array<float, kKept> kept_;
};

}  // namespace tress
