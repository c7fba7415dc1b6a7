// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <string>

#include "core/carried_frame.h"
#include "core/error.h"
#include "core/groom.h"
#include "core/hair_noise.h"

namespace tress {
namespace {

constexpr float kTipSpread = 0.3f;  // of a child's distance to its guide, relative to the root's
constexpr float kStray = 0.25f;     // of a child at its tip, relative to the spread
constexpr float kStrayPeriods = 3;  // along the strand
constexpr float kShortest = 0.88f;  // of a child, relative to its guide

/// Unit tangents of the points of strand [begin, end): where the points say nothing, the last one known.
std::vector<Vec3> tangents(const StrandSet& guides, uint32_t begin, uint32_t end) {
    std::vector<Vec3> tangent(end - begin, Vec3(0, -1, 0));
    bool known = false;
    for (uint32_t i = begin; i < end; ++i) {
        const Vec3 a = guides.point(i > begin ? i - 1 : i), b = guides.point(i + 1 < end ? i + 1 : i);
        const Vec3 along = b - a;
        const float size = max_component(abs(along));
        const bool usable = is_finite(along) && size > 0;
        if (usable) {
            const Vec3 scaled = along / size;
            tangent[i - begin] = scaled / length(scaled);
            if (!known) std::fill(tangent.begin(), tangent.begin() + (i - begin), tangent[i - begin]);
            known = true;
        } else if (i > begin) {
            tangent[i - begin] = tangent[i - begin - 1];
        }
    }
    return tangent;
}

std::vector<Vec3> sides(std::span<const Vec3> tangent) {
    std::vector<Vec3> side(tangent.size());
    side[0] = frame_about(tangent[0]).x;
    for (size_t i = 1; i < side.size(); ++i) side[i] = carry_side(side[i - 1], tangent[i - 1], tangent[i]);
    return side;
}

/// Strand [begin, end) at `t`, counted in points from its root: cubic through the points (Catmull-Rom).
Vec3 along(const StrandSet& guides, uint32_t begin, uint32_t end, float t) {
    const uint32_t last = end - begin - 1;
    const uint32_t i = std::min(uint32_t(t), last - 1);
    const float f = t - float(i);
    const Vec3 b = guides.point(begin + i);
    if (f == 0) return b;
    const Vec3 c = guides.point(begin + i + 1);
    const Vec3 a = i > 0 ? guides.point(begin + i - 1) : b + (b - c);
    const Vec3 d = i + 2 <= last ? guides.point(begin + i + 2) : c + (c - b);
    const Vec3 m0 = 0.5f * (c - a), m1 = 0.5f * (d - b);
    const float f2 = f * f, f3 = f2 * f;
    return (2 * f3 - 3 * f2 + 1) * b + (f3 - 2 * f2 + f) * m0 + (3 * f2 - 2 * f3) * c + (f3 - f2) * m1;
}

struct Child {
    uint64_t key;
    float shortened;  // length relative to the guide's
    Vec2 offset;      // from the guide at the root, in the plane across it
    float stray;
};

Child make_child(uint64_t key, float spread) {
    const float radius = spread * std::sqrt(random(key, 0)), angle = 2 * kPi * random(key, 1);
    const float shortened = 1 - (1 - kShortest) * square(random(key, 2));
    return {key, shortened, radius * Vec2(std::cos(angle), std::sin(angle)), kStray * spread};
}

/// The child's place beside its guide, `t` from 0 at the root to 1 at the tip.
Vec2 beside(const Child& child, float t) {
    const Vec2 noise(line_noise(hash(child.key, 3), kStrayPeriods * t),
                     line_noise(hash(child.key, 4), kStrayPeriods * t));
    return child.offset * (1 - (1 - kTipSpread) * glm::smoothstep(0.0f, 1.0f, t)) + child.stray * t * noise;
}

void put(StrandSet& set, size_t at, const Vec3& p, const StrandSet& guides, uint32_t from) {
    set.x[at] = p.x, set.y[at] = p.y, set.z[at] = p.z;
    if (!set.radius.empty()) set.radius[at] = guides.radius[from];
    if (!set.color.empty()) set.color[at] = guides.color[from];
}

}  // namespace

StrandSet grow_children(const StrandSet& guides, int count, double spread, uint64_t seed) {
    if (count <= 1) return guides;
    const size_t points = guides.points() * size_t(count);
    if (points > std::numeric_limits<uint32_t>::max())
        throw InputError("children", std::to_string(count) + " a guide make " + std::to_string(points) +
                                         " points; expected fewer than 2^32");
    StrandSet set;
    set.constant_radius = guides.constant_radius;
    set.x.resize(points), set.y.resize(points), set.z.resize(points);
    set.radius.resize(guides.radius.empty() ? 0 : points);
    set.color.resize(guides.color.empty() ? 0 : points);
    set.first.resize(guides.first.empty() ? 0 : guides.strands() * size_t(count) + 1);
    if (!set.first.empty()) set.first.back() = uint32_t(points);
    tbb::parallel_for(size_t(0), guides.strands(), [&](size_t strand) {
        const uint32_t begin = guides.first[strand], end = guides.first[strand + 1];
        const uint32_t size = end - begin;
        const std::vector<Vec3> tangent = tangents(guides, begin, end), side = sides(tangent);
        for (size_t c = 0; c < size_t(count); ++c) {
            const size_t first = begin * size_t(count) + c * size;
            set.first[strand * count + c] = uint32_t(first);
            const Child child = make_child(hash(hash(seed, strand), c), float(spread));
            for (uint32_t i = 0; i < size; ++i) {
                Vec3 p = guides.point(begin + i);
                if (c > 0) {
                    const float t = float(i) / float(size - 1);
                    const Vec2 offset = beside(child, t);
                    p = along(guides, begin, end, child.shortened * float(i)) + offset.x * side[i] +
                        offset.y * cross(tangent[i], side[i]);
                }
                put(set, first + i, p, guides, begin + i);
            }
        }
    });
    return set;
}

}  // namespace tress
