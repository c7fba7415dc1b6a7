// SPDX-License-Identifier: MIT
// Compression of Lokovic & Veach 2000: a falling step function becomes piecewise linear, with few nodes,
// and errs nowhere by more than a bound. The paper fixes each node before it looks for the next; here a node keeps its
// whole range of values until the end is reached, and values are settled on the way back, which takes fewer nodes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gather/shadow_maps/slope_limit.h"

namespace tress {

/// V is 1 up to depth[0] inclusive, and value[c][i] behind depth[i] up to depth[i + 1] inclusive, or for ever. Depths
/// are finite and do not fall; values do not rise and lie in [0, 1]. One channel or three; the others are empty.
struct StepFunction {
    std::span<const float> depth;
    std::span<const float> value[3];

    int channels() const { return value[1].empty() ? 1 : 3; }
};

/// V' is 1 up to the first node, linear between nodes, and constant behind the last. Two nodes at one depth are a step,
/// and at that depth the former holds.
struct StepNodes {
    std::vector<float> depth;
    std::vector<float> value[3];  // one channel, the others empty, or three
};

/// Keeps its memory from one function to the next.
class StepCompressor {
public:
    /// |V - V'| <= bound everywhere, on both sides of every step and in every channel. V' does not rise and stays in
    /// [0, 1]; the first node is (depth[0], 1) to the bit. Nodes replace what `nodes` held. With a bound below 5e-7
    /// nothing is lost: every step stays one. Linear time. On steps like hair's, 1 to 8 % more nodes than the fewest
    /// that can stand at depths of steps.
    void operator()(const StepFunction& steps, float bound, StepNodes& nodes);

private:
    struct Range {
        double low, high;
        bool holds_some() const { return low <= high; }
        double middle() const { return 0.5 * (low + high); }
        double nearest(double v) const { return v < low ? low : (v > high ? high : v); }
    };
    // One a channel. What goes through steps has the number of channels, N, as a template argument: the loops over
    // channels are short and innermost.
    using Ranges = std::array<Range, 3>;
    using Values = std::array<double, 3>;

    /// One node, or two where V' drops: all values that can be reached before, and those to go on from.
    struct Stop {
        uint32_t step;
        bool drop;
        Ranges before, after;
    };

    template <size_t N>
    void compress(const StepFunction& steps, double bound, StepNodes& nodes);
    template <size_t N>
    void merge(const StepFunction& steps, double bound);

    /// Allowed behind a step, up to the next; before one; and through one without a drop, which is none where the step
    /// is higher than twice the bound.
    template <size_t N>
    const Range& behind(uint32_t step, size_t c) const {
        return behind_[step * N + c];
    }
    template <size_t N>
    const Range& before(uint32_t step, size_t c) const {
        return behind<N>(step - 1, c);
    }
    template <size_t N>
    Range through(uint32_t step, size_t c) const {
        return {before<N>(step, c).low, behind<N>(step, c).high};
    }

    Range reached(const Range& allowed, size_t c, double x) const;
    template <size_t N>
    bool joins(uint32_t step, double x, Ranges& ranges) const;
    template <size_t N>
    bool drops(uint32_t step, double x, Ranges& ranges) const;
    template <size_t N>
    void drop_from(Stop& stop) const;
    template <size_t N>
    Stop first_stop() const;
    template <size_t N>
    Stop next_stop(const Stop& from);
    template <size_t N>
    bool can_rest(const Stop& stop) const;
    template <size_t N>
    void settle(const Stop& from, const Stop& to, Values& values) const;
    template <size_t N>
    void write(StepNodes& nodes) const;

    double slack_ = 0;           // that the way back has more than the way forth
    std::vector<double> depth_;  // one a step of some height
    std::vector<Range> behind_;  // on the way forth; channels side by side
    Values rest_{};              // V behind all steps
    SlopeLimit flattest_[3], steepest_[3];
    std::vector<Stop> stops_;
};

}  // namespace tress
