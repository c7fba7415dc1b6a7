// SPDX-License-Identifier: MIT
// How the light that enters a fiber is shared among its lobes.
#pragma once

#include "core/fiber.h"

namespace tress {

/// A_p of one channel: F, (1 - F)^2 T, (1 - F)^2 T^2 F, and the geometric series of all the rest (Chiang et al. 2016).
/// F: reflectance; T: what one crossing of the inside transmits.
struct LobeEnergy {
    double of[Fiber::kLobes];
};

inline LobeEnergy lobe_energy(double reflectance, double transmitted) {
    const double forward = square(1 - reflectance) * transmitted;
    const double kept = reflectance * transmitted;
    const double lost = 1 - kept;  // 0 only where nothing enters
    const double rest = lost > 0 ? forward * kept * kept / lost : 0;
    return {{reflectance, forward, forward * kept, rest}};
}

/// Probabilities in proportion to the mean energy of each lobe; all 0 where there is none.
inline void share_lobes(const Rgb (&energy)[Fiber::kLobes], float (&share)[Fiber::kLobes]) {
    float sum = 0;
    for (int p = 0; p < Fiber::kLobes; ++p) sum += share[p] = mean(energy[p]);
    for (float& s : share) s = sum > 0 ? s / sum : 0;
}

/// The lobe that u in [0, 1) falls on.
inline int choose_lobe(const float (&share)[Fiber::kLobes], float u) {
    int p = 0;
    for (; p < Fiber::kLobes - 1 && u >= share[p]; ++p) u -= share[p];
    return p;
}

}  // namespace tress
