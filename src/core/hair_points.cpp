// SPDX-License-Identifier: MIT
#include "core/hair_points.h"

#include "core/rng.h"

namespace tress {
namespace {

double area_of(const SegmentView& segments, size_t s) {
    const double length = glm::length(DVec3(segments.end(s)) - DVec3(segments.start(s)));
    return length * (double(segments.start_radius(s)) + double(segments.end_radius(s)));
}

/// Where along an axis, in [0, 1], a share `u` of the area lies before: the inverse of the integral of a linear radius.
float place_of_share(float u, float start_radius, float end_radius) {
    const float sum = start_radius + end_radius;
    const float root = safe_sqrt(glm::mix(square(start_radius / sum), square(end_radius / sum), u));
    return u / (start_radius / sum + root);
}

}  // namespace

HairPoints spread_points(const SegmentView& segments, size_t n) {
    constexpr uint64_t kKey = hash(0, 0x68616972);
    double total = 0;
    for (size_t s = 0; s < segments.size(); ++s) total += area_of(segments, s);
    HairPoints points;
    if (!(total > 0) || !std::isfinite(total)) return points;

    points.position.reserve(n);
    points.area = float(total / double(n));
    const auto at = [&](size_t i) { return (double(i) + double(random(kKey, i))) * total / double(n); };
    double before = 0;
    for (size_t s = 0; s < segments.size(); ++s) {
        const double area = area_of(segments, s);
        for (; points.position.size() < n && at(points.position.size()) < before + area;) {
            const float share = float((at(points.position.size()) - before) / area);
            const float u =
                place_of_share(glm::clamp(share, 0.0f, 1.0f), segments.start_radius(s), segments.end_radius(s));
            points.position.push_back(glm::mix(segments.start(s), segments.end(s), u));
        }
        before += area;
    }
    return points;
}

}  // namespace tress
