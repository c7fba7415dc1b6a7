// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/hair_window.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace tress {
namespace {

constexpr size_t kBlock = 8;              // segments, neighbours on a strand mostly, that are passed over together
constexpr size_t kGrain = 1024 * kBlock;  // segments a task: a few milliseconds at most

bool is_face(const HairWindow& window) { return !window.limits.contains(kEverywhere); }

/// Hair that sticks out of what is wanted. Returns whether some that is lit is left out.
bool add_outlying(const HairWindow& window, const ViewHair& hair, bool is_lit, HairFound& to) {
    const Projection projection = projection_of(window.view);
    if (const auto part = clip(hair, window.reach, projection)) to.nearest = glm::min(to.nearest, part->nearest());
    if (!is_lit) return false;
    if (const auto part = clip(hair, window.wanted, projection)) {
        const ViewRectangle rectangle = cut(rectangle_of(*part, projection), window.wanted);
        if (!rectangle.empty()) to.hair.add(rectangle);
    }
    const auto lit = clip(hair, window.lit, projection);
    if (!lit) return false;
    const ViewRectangle rectangle = cut(rectangle_of(*lit, projection), window.lit);
    return !rectangle.empty() && !window.wanted.contains(rectangle);
}

/// Returns whether some that is lit is left out.
bool add(const HairWindow& window, ViewHair hair, bool is_lit, HairFound& to) {
    const Projection projection = projection_of(window.view);
    // Behind one face of a cube lie others, and behind a spot it is dark, but behind a single pinhole hair is lost.
    const bool is_lost = !window.view.parallel && window.lit.contains(kEverywhere) && hair.nearest() <= 0;
    if (is_face(window)) {
        const auto part = clip(hair, window.limits, projection);
        if (!part) return false;
        hair = *part;
    }
    const ViewRectangle rectangle = cut(rectangle_of(hair, projection), window.limits);
    if (!window.wanted.contains(rectangle)) return add_outlying(window, hair, is_lit, to) || (is_lost && is_lit);
    to.nearest = glm::min(to.nearest, hair.nearest());
    if (is_lit) to.hair.add(rectangle);
    return false;
}

/// Whether hair within a ball, lit or not, tells nothing new about a window.
bool is_known(const HairWindow& window, const HairBall& ball, const HairFound& found, bool left_out) {
    const DVec3 center = to_local(window.view, ball.center);
    if (is_face(window) && center.z < -ball.radius) return true;
    if (!window.view.parallel && !(center.z > ball.radius)) return false;
    const ViewRectangle rectangle = rectangle_about_ball(center, ball.radius, projection_of(window.view));
    if (!rectangle.meets(window.limits)) return true;
    if (!rectangle.meets(window.reach)) return left_out;
    return found.hair.contains(rectangle) && center.z - ball.radius >= found.nearest;
}

/// Adds segment `s` where it tells something new.
void add_segment(std::span<const HairWindow> windows, const LitCone& cone, const SegmentView& segments, size_t s,
                 HairSearch& search) {
    const HairBall ball = ball_about(segments, s);
    for (size_t i = 0; i < windows.size(); ++i) {
        HairFound& found = search.found[i];
        if (is_known(windows[i], ball, found, search.left_out)) continue;
        const bool is_lit = cone.reaches(ball.center, ball.radius);
        if (add(windows[i], in_view(windows[i].view, segments, s), is_lit, found)) search.left_out = true;
    }
}

void add_block(std::span<const HairWindow> windows, const LitCone& cone, const SegmentView& segments, size_t first,
               size_t last, HairSearch& search) {
    const HairBall ball = ball_about(segments, first, last);
    bool is_all_known = true;
    for (size_t i = 0; i < windows.size(); ++i)
        is_all_known = is_all_known && is_known(windows[i], ball, search.found[i], search.left_out);
    if (is_all_known) return;
    for (size_t s = first; s < last; ++s) add_segment(windows, cone, segments, s, search);
}

void join(HairSearch& to, const HairSearch& from) {
    for (size_t i = 0; i < to.found.size(); ++i) {
        to.found[i].hair.add(from.found[i].hair);
        to.found[i].nearest = glm::min(to.found[i].nearest, from.found[i].nearest);
    }
    to.left_out = to.left_out || from.left_out;
}

}  // namespace

ViewHair in_view(const LightView& view, const SegmentView& segments, size_t segment) {
    return {{to_local(view, DVec3(segments.start(segment))), to_local(view, DVec3(segments.end(segment)))},
            {double(segments.start_radius(segment)), double(segments.end_radius(segment))}};
}

HairBall ball_about(const SegmentView& segments, size_t segment) {
    const DVec3 a(segments.start(segment)), b(segments.end(segment));
    const float radius = glm::max(segments.start_radius(segment), segments.end_radius(segment));
    return {0.5 * (a + b), 0.5 * distance(a, b) + double(radius)};
}

HairBall ball_about(const SegmentView& segments, size_t first, size_t last) {
    Bounds box;
    float radius = 0;
    for (size_t s = first; s < last; ++s) {
        box.add(segments.start(s));
        const bool is_linked = s + 1 < last && segments.point[s + 1] == segments.point[s] + 1;
        if (!is_linked) box.add(segments.end(s));
        radius = glm::max(radius, glm::max(segments.start_radius(s), segments.end_radius(s)));
    }
    const DVec3 low(box.lo), high(box.hi);
    return {0.5 * (low + high), 0.5 * distance(low, high) + double(radius)};
}

/// Minima and maxima alone are joined, so the order of tasks does not matter.
HairSearch find_hair(std::span<const HairWindow> windows, const LitCone& cone, const SegmentView& segments) {
    const HairSearch none{std::vector<HairFound>(windows.size()), false};
    return tbb::parallel_reduce(
        tbb::blocked_range<size_t>(0, segments.size(), kGrain), none,
        [&](const tbb::blocked_range<size_t>& range, HairSearch search) {
            for (size_t s = range.begin(); s < range.end(); s += kBlock)
                add_block(windows, cone, segments, s, std::min(s + kBlock, range.end()), search);
            return search;
        },
        [](HairSearch a, const HairSearch& b) {
            join(a, b);
            return a;
        });
}

}  // namespace tress
