// SPDX-License-Identifier: MIT
#include "gather/projection/simplified_hair.h"

#include "core/rng.h"

namespace tress {
namespace {

constexpr uint64_t kKey = hash(0, 0x73696d706c65);

/// Loose segments: two points each.
struct LooseSegments {
    std::vector<float> x, y, z, radius;
    std::vector<uint32_t> point;

    void add(const Vec3& a, const Vec3& b, float radius_a, float radius_b) {
        point.push_back(uint32_t(x.size()));
        for (const Vec3& p : {a, b}) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
        radius.push_back(radius_a), radius.push_back(radius_b);
    }
    SegmentView view() const { return {x, y, z, radius, point, 0, false}; }
};

}  // namespace

ProjectedSegments simplify_hair(const SegmentView& s, const ProjectionOptions& options) {
    LooseSegments loose;
    std::vector<uint32_t> original;
    const float weight = options.weighted ? 1 / options.share : 1;
    const uint32_t stride = uint32_t(options.stride);
    for (uint32_t first = 0; first < s.size();) {
        uint32_t end = first + 1;
        while (end < s.size() && joined(s, end - 1, end)) ++end;
        const bool kept = random(kKey, first) < options.share;
        for (uint32_t i = first; kept && i < end; i += stride) {
            const uint32_t last = std::min(i + stride, end) - 1;
            if (s.start(i) == s.end(last)) continue;  // a loop: no direction
            loose.add(s.start(i), s.end(last), weight * s.start_radius(i), weight * s.end_radius(last));
            original.push_back(i);
        }
        first = end;
    }
    ProjectedSegments simplified = make_projected_segments(loose.view());
    for (size_t segment = 0; segment < original.size(); ++segment)
        simplified.set_original(simplified.row_of(segment), original[segment]);
    simplified.stands_for = stride;
    return simplified;
}

}  // namespace tress
