// SPDX-License-Identifier: MIT
// One of many candidates, kept with probability in proportion to its weight (Chao 1982), with one number for all of
// them: what remains of the number after a decision is uniform again. With the sum of weights for its own weight the
// one kept is an unbiased estimate of all (resampled importance sampling: Talbot et al. 2005).
#pragma once

namespace tress {

class Reservoir {
public:
    /// `u` is uniform in [0, 1).
    explicit Reservoir(float u) : u_(u) {}

    /// Whether the candidate takes the place of the one kept before. `weight` is positive.
    bool offer(float weight) {
        sum_ += weight;
        const float chance = weight / sum_;
        const bool taken = u_ < chance;
        u_ = taken ? u_ / chance : (u_ - chance) / (1 - chance);
        return taken;
    }
    float sum() const { return sum_; }

private:
    float u_, sum_ = 0;
};

}  // namespace tress
