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
void StepCompressor::merge(const StepFunction& steps, double bound) {
    depth_.clear(), behind_.clear();
    for (size_t i = 0; i < steps.depth.size(); ++i) {
        assert(i == 0 || steps.depth[i] >= steps.depth[i - 1]);
        bool falls = i == 0;
        for (size_t c = 0; c < channels_; ++c) falls |= double(steps.value[c][i]) != rest_[c];
        if (!falls) continue;
        if (i > 0 && double(steps.depth[i]) == depth_.back())
            behind_.resize(behind_.size() - channels_);
        else
            depth_.push_back(steps.depth[i]);
        for (size_t c = 0; c < channels_; ++c) {
            rest_[c] = steps.value[c][i];
            behind_.push_back({std::max(rest_[c] - bound, 0.0), std::min(rest_[c] + bound, 1.0)});
        }
    }
}

/// Of those allowed, what lines through all that lies between can reach.
StepCompressor::Range StepCompressor::reached(const Range& allowed, int c, double x) const {
    return {std::max(allowed.low, -steepest_[c].at(x)), std::min(allowed.high, flattest_[c].at(x))};
}

bool StepCompressor::joins(uint32_t step, double x, Ranges& ranges) const {
    for (int c = 0; c < int(channels_); ++c) {
        const Range gap = through(step, c);
        ranges[c] = reached(gap, c, x);
        if (!gap.holds_some() || !ranges[c].holds_some()) return false;
    }
    return true;
}

/// Whether a step that is too high to go through can be reached.
bool StepCompressor::drops(uint32_t step, double x, Ranges& ranges) const {
    bool high = false, reaches = true;
    for (int c = 0; c < int(channels_); ++c) {
        high |= !through(step, c).holds_some();
        ranges[c] = reached(before(step, c), c, x);
        reaches &= ranges[c].holds_some();
    }
    return high && reaches;
}

void StepCompressor::drop_from(Stop& stop) const {
    stop.drop = true;
    for (int c = 0; c < int(channels_); ++c) {
        stop.after[c] = behind(stop.step, c);
        stop.after[c].high = std::min(stop.after[c].high, stop.before[c].high);
    }
}

StepCompressor::Stop StepCompressor::first_stop() const {
    Stop stop{0, false, {}, {}};
    stop.before.fill({1, 1});
    stop.after = stop.before;
    for (int c = 0; c < int(channels_); ++c)
        if (behind(0, c).high < 1) drop_from(stop);
    return stop;
}

/// The farthest stop that one line reaches.
StepCompressor::Stop StepCompressor::next_stop(const Stop& from) {
    for (int c = 0; c < int(channels_); ++c) {
        flattest_[c].start(from.after[c].low, from.after[c].high, 0);
        steepest_[c].start(-from.after[c].high, -from.after[c].low, SlopeLimit::kNoCap);
    }
    Stop to{from.step, false, {}, {}};
    Ranges ranges{};
    while (++to.step < depth_.size()) {
        const double x = depth_[to.step] - depth_[from.step];
        if (!joins(to.step, x, ranges)) {
            // The next step can always be reached, level.
            if (drops(to.step, x, ranges) || to.step == from.step + 1) {
                to.before = ranges;
                drop_from(to);
                return to;
            }
            break;
        }
        for (int c = 0; c < int(channels_); ++c) {
            const Range gap = through(to.step, c);
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
bool StepCompressor::can_rest(const Stop& stop) const {
    for (int c = 0; c < int(channels_); ++c)
        if (behind(uint32_t(depth_.size()) - 1, c).high < stop.after[c].low) return false;
    return true;
}

/// Value to go on from after `from`, given the value `end` to arrive with: the middle of what every gap between them
/// lets through.
double StepCompressor::settle(const Stop& from, const Stop& to, int c, double end) const {
    Range start = from.after[c];
    start.low = std::max(start.low, end);
    const double last = depth_[to.step], length = last - depth_[from.step];
    for (uint32_t i = from.step + 1; i < to.step; ++i) {
        const Range gap = through(i, c);
        const double stretch = length / (last - depth_[i]);
        start.low = std::max(start.low, end + (gap.low - slack_ - end) * stretch);
        start.high = std::min(start.high, end + (gap.high + slack_ - end) * stretch);
    }
    return std::max(end, from.after[c].nearest(start.middle()));
}

void StepCompressor::write(StepNodes& nodes) const {
    size_t count = 0;
    for (const Stop& stop : stops_) count += stop.drop ? 2 : 1;
    nodes.depth.resize(count);
    size_t node = count;
    for (size_t s = stops_.size(); s-- > 0;)
        for (int copies = stops_[s].drop ? 2 : 1; copies > 0; --copies)
            nodes.depth[--node] = float(depth_[stops_[s].step]);
    for (int c = 0; c < 3; ++c) {
        nodes.value[c].resize(c < int(channels_) ? count : 0);
        if (nodes.value[c].empty()) continue;
        // What remains behind the last step is kept as exactly as can be.
        const Range& end = stops_.back().after[c];
        double v = Range{end.low, std::min(end.high, behind(uint32_t(depth_.size()) - 1, c).high)}.nearest(rest_[c]);
        node = count;
        for (size_t s = stops_.size(); s-- > 0;) {
            const Stop& stop = stops_[s];
            if (s + 1 < stops_.size()) v = settle(stop, stops_[s + 1], c, v);
            nodes.value[c][--node] = float(v);
            if (!stop.drop) continue;
            v = Range{std::max(stop.before[c].low, v), stop.before[c].high}.middle();
            nodes.value[c][--node] = float(v);
        }
    }
}

void StepCompressor::operator()(const StepFunction& steps, float bound, StepNodes& nodes) {
    channels_ = size_t(steps.channels());
    const bool exact = !(bound > kLeastBound);
    slack_ = exact ? 0 : kAllowance;
    merge(steps, exact ? 0 : double(bound) - 2 * kAllowance);
    stops_.clear();
    if (depth_.empty()) {
        nodes.depth.clear();
        for (std::vector<float>& value : nodes.value) value.clear();
        return;
    }
    stops_.push_back(first_stop());
    while (stops_.back().step + 1 < depth_.size() && !can_rest(stops_.back()))
        stops_.push_back(next_stop(stops_.back()));
    write(nodes);
}

}  // namespace tress
