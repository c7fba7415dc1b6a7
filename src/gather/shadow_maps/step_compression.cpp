// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/step_compression.h"

#include <algorithm>
#include <cassert>

namespace tress {

namespace {

/// Allowance for rounding. The way forth takes two of the bound, so that the way back, which takes one, finds a range
/// of values wherever the way forth found a line: depths that are floats of one sign amplify the rounding of doubles by
/// up to 2^25, to 2^-27. The last is for nodes rounded to floats, by 2^-25, and for whoever interpolates them.
constexpr double kAllowance = 0x1p-23;

/// Bounds down to which there is something to give away.
constexpr double kLeastBound = 4 * kAllowance;

}  // namespace

/// Steps at one depth become one, and those of no height but the first none.
template <size_t N>
void StepCompressor::merge(const StepFunction& steps, double bound) {
    depth_.resize(steps.depth.size());
    behind_.resize(N * steps.depth.size());
    size_t count = 0;
    for (size_t i = 0; i < steps.depth.size(); ++i) {
        assert(i == 0 || steps.depth[i] >= steps.depth[i - 1]);
        bool falls = i == 0;
        for (size_t c = 0; c < N; ++c) falls |= double(steps.value[c][i]) != rest_[c];
        if (!falls) continue;
        const double depth = steps.depth[i];
        if (count == 0 || depth != depth_[count - 1]) depth_[count++] = depth;
        for (size_t c = 0; c < N; ++c) {
            rest_[c] = steps.value[c][i];
            behind_[(count - 1) * N + c] = {std::max(rest_[c] - bound, 0.0), std::min(rest_[c] + bound, 1.0)};
        }
    }
    depth_.resize(count);
}

/// Of those allowed, what lines through all that lies between can reach.
inline StepCompressor::Range StepCompressor::reached(const Range& allowed, size_t c, double x) const {
    return {std::max(allowed.low, -steepest_[c].at(x)), std::min(allowed.high, flattest_[c].at(x))};
}

template <size_t N>
bool StepCompressor::joins(uint32_t step, double x, Ranges& ranges) const {
    bool all = true;
    for (size_t c = 0; c < N; ++c) {
        const Range gap = through<N>(step, c);
        ranges[c] = reached(gap, c, x);
        all &= gap.holds_some() & ranges[c].holds_some();
    }
    return all;
}

/// Whether a step that is too high to go through can be reached.
template <size_t N>
bool StepCompressor::drops(uint32_t step, double x, Ranges& ranges) const {
    bool high = false, reaches = true;
    for (size_t c = 0; c < N; ++c) {
        high |= !through<N>(step, c).holds_some();
        ranges[c] = reached(before<N>(step, c), c, x);
        reaches &= ranges[c].holds_some();
    }
    return high && reaches;
}

template <size_t N>
void StepCompressor::drop_from(Stop& stop) const {
    stop.drop = true;
    for (size_t c = 0; c < N; ++c) {
        stop.after[c] = behind<N>(stop.step, c);
        stop.after[c].high = std::min(stop.after[c].high, stop.before[c].high);
    }
}

template <size_t N>
StepCompressor::Stop StepCompressor::first_stop() const {
    Stop stop{0, false, {}, {}};
    stop.before.fill({1, 1});
    stop.after = stop.before;
    for (size_t c = 0; c < N; ++c)
        if (behind<N>(0, c).high < 1) drop_from<N>(stop);
    return stop;
}

/// The farthest stop that one line reaches.
template <size_t N>
StepCompressor::Stop StepCompressor::next_stop(const Stop& from) {
    for (size_t c = 0; c < N; ++c) {
        flattest_[c].start(from.after[c].low, from.after[c].high, 0);
        steepest_[c].start(-from.after[c].high, -from.after[c].low, SlopeLimit::kNoCap);
    }
    Stop to{from.step, false, {}, {}};
    Ranges ranges{};
    const double start = depth_[from.step];
    const uint32_t steps = uint32_t(depth_.size());
    while (++to.step < steps) {
        const double x = depth_[to.step] - start;
        if (!joins<N>(to.step, x, ranges)) {
            // The next step can always be reached, level.
            if (drops<N>(to.step, x, ranges) || to.step == from.step + 1) {
                to.before = ranges;
                drop_from<N>(to);
                return to;
            }
            break;
        }
        for (size_t c = 0; c < N; ++c) {
            const Range gap = through<N>(to.step, c);
            flattest_[c].add(x, gap.low, gap.high);
            steepest_[c].add(x, -gap.high, -gap.low);
        }
        to.before = ranges;
    }
    --to.step;
    to.after = to.before;
    return to;
}

/// Whether V' may stay constant from a stop on.
template <size_t N>
bool StepCompressor::can_rest(const Stop& stop) const {
    for (size_t c = 0; c < N; ++c)
        if (behind<N>(uint32_t(depth_.size()) - 1, c).high < stop.after[c].low) return false;
    return true;
}

/// Values to go on from after `from`, given those to arrive with: the middle of what every gap between them lets
/// through.
template <size_t N>
void StepCompressor::settle(const Stop& from, const Stop& to, Values& values) const {
    Ranges start = from.after;
    for (size_t c = 0; c < N; ++c) start[c].low = std::max(start[c].low, values[c]);
    const double last = depth_[to.step], length = last - depth_[from.step];
    for (uint32_t i = from.step + 1; i < to.step; ++i) {
        const double stretch = length / (last - depth_[i]);
        for (size_t c = 0; c < N; ++c) {
            const Range gap = through<N>(i, c);
            start[c].low = std::max(start[c].low, values[c] + (gap.low - slack_ - values[c]) * stretch);
            start[c].high = std::min(start[c].high, values[c] + (gap.high + slack_ - values[c]) * stretch);
        }
    }
    for (size_t c = 0; c < N; ++c) values[c] = std::max(values[c], from.after[c].nearest(start[c].middle()));
}

template <size_t N>
void StepCompressor::write(StepNodes& nodes) const {
    size_t node = 0;
    for (const Stop& stop : stops_) node += stop.drop ? 2 : 1;
    nodes.depth.resize(node);
    for (size_t c = 0; c < 3; ++c) nodes.value[c].resize(c < N ? node : 0);
    const auto add = [&](const Stop& stop, const Values& values) {
        nodes.depth[--node] = float(depth_[stop.step]);
        for (size_t c = 0; c < N; ++c) nodes.value[c][node] = float(values[c]);
    };
    // What remains behind the last step is kept as exactly as can be.
    Values v{};
    for (size_t c = 0; c < N; ++c) {
        const Range& end = stops_.back().after[c];
        v[c] = Range{end.low, std::min(end.high, behind<N>(uint32_t(depth_.size()) - 1, c).high)}.nearest(rest_[c]);
    }
    for (size_t s = stops_.size(); s-- > 0;) {
        const Stop& stop = stops_[s];
        if (s + 1 < stops_.size()) settle<N>(stop, stops_[s + 1], v);
        add(stop, v);
        if (!stop.drop) continue;
        for (size_t c = 0; c < N; ++c) v[c] = Range{std::max(stop.before[c].low, v[c]), stop.before[c].high}.middle();
        add(stop, v);
    }
}

template <size_t N>
void StepCompressor::compress(const StepFunction& steps, double bound, StepNodes& nodes) {
    merge<N>(steps, bound);
    for (size_t c = 0; c < N; ++c) flattest_[c].reserve(depth_.size()), steepest_[c].reserve(depth_.size());
    stops_.assign(1, first_stop<N>());
    while (stops_.back().step + 1 < depth_.size() && !can_rest<N>(stops_.back()))
        stops_.push_back(next_stop<N>(stops_.back()));
    write<N>(nodes);
}

void StepCompressor::operator()(const StepFunction& steps, float bound, StepNodes& nodes) {
    if (steps.depth.empty()) {
        nodes.depth.clear();
        for (std::vector<float>& value : nodes.value) value.clear();
        return;
    }
    const bool exact = !(bound > kLeastBound);
    slack_ = exact ? 0 : kAllowance;
    const double forth = exact ? 0 : double(bound) - 2 * kAllowance;
    steps.channels() == 1 ? compress<1>(steps, forth, nodes) : compress<3>(steps, forth, nodes);
}

}  // namespace tress
