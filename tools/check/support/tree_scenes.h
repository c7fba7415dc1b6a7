// SPDX-License-Identifier: MIT
// Segments and rays to try a hair tree on, ordinary and hostile, the same for the same seed.
#pragma once

#include <string>
#include <vector>

#include "accel/queries.h"
#include "core/rng.h"
#include "core/segments.h"

namespace tress::scenes {

/// Numbers in [-1, 1) and such, one after another.
class Dice {
public:
    explicit Dice(uint64_t seed) : key_(hash(seed, 0)) {}
    float unit() { return random(key_, next_++); }
    float both() { return 2 * unit() - 1; }
    int below(int n) { return std::min(int(unit() * float(n)), n - 1); }
    Vec3 in_cube() {
        const float x = both();
        const float y = both();
        const float z = both();
        return {x, y, z};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube();
            const float l2 = dot(v, v);
            if (l2 > 0.01f && l2 < 1) return v / std::sqrt(l2);
        }
    }

private:
    uint64_t key_, next_ = 0;
};

/// Points and segments; `view` looks into them.
struct Hair {
    StrandSet points;
    std::vector<uint32_t> point;
    bool linked = false;

    void add(const Vec3& start, const Vec3& end, float start_radius, float end_radius) {
        point.push_back(uint32_t(points.points()));
        points.add_point(start);
        points.add_point(end);
        points.radius.push_back(start_radius);
        points.radius.push_back(end_radius);
    }
    void add(const Vec3& start, const Vec3& end, float radius) { add(start, end, radius, radius); }
    void add_strand(const std::vector<Vec3>& corners, float radius) {
        for (size_t i = 0; i < corners.size(); ++i) {
            if (i + 1 < corners.size()) point.push_back(uint32_t(points.points()));
            points.add_point(corners[i]);
            points.radius.push_back(radius);
        }
        linked = true;
    }
    SegmentView view() const {
        SegmentView v;
        v.x = points.x, v.y = points.y, v.z = points.z, v.radius = points.radius;
        v.point = point;
        v.linked = linked;
        return v;
    }
};

inline constexpr float kRadius = 0.004f;  // of a scene about two units across

inline Hair random_hair(size_t n, uint64_t seed, bool tapered = false) {
    Hair hair;
    Dice dice(seed);
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = dice.in_cube(), way = dice.direction();
        const float length = 0.05f + 0.4f * dice.unit();
        hair.add(start, start + length * way, kRadius, tapered ? kRadius * dice.unit() : kRadius);
    }
    return hair;
}

/// Bundles of nearly parallel hairs that lie a few radii apart.
inline Hair clumped_hair(size_t n, uint64_t seed) {
    constexpr size_t kClump = 50;
    Hair hair;
    Dice dice(seed);
    Vec3 root(0), way(0);
    for (size_t i = 0; i < n; ++i) {
        if (i % kClump == 0) {
            root = dice.in_cube();
            way = dice.direction();
        }
        const Vec3 start = root + 0.03f * dice.in_cube();
        hair.add(start, start + 0.5f * way + 0.03f * dice.in_cube(), kRadius);
    }
    return hair;
}

/// Along the axes, from a lattice whose planes the splits fall on.
inline Hair lattice_hair(size_t n, uint64_t seed) {
    Hair hair;
    Dice dice(seed);
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = round(dice.in_cube() * 16.0f) / 16.0f;
        Vec3 way(0);
        way[dice.below(3)] = float(1 + dice.below(4)) / 16.0f;
        hair.add(start, start + way, kRadius);
    }
    return hair;
}

/// Each segment ten times, at the same place.
inline Hair coincident_hair(size_t n, uint64_t seed) {
    const Hair once = random_hair(n / 10, seed);
    Hair hair;
    for (size_t i = 0; i < n / 10 * 10; ++i) {
        const size_t k = i % (n / 10);
        hair.add(once.points.point(2 * k), once.points.point(2 * k + 1), kRadius);
    }
    return hair;
}

inline Hair far_hair(size_t n, uint64_t seed) {
    Hair hair = random_hair(n, seed);
    for (float& x : hair.points.x) x += 1e4f;
    for (float& y : hair.points.y) y -= 1e4f;
    return hair;
}

inline Hair strands(size_t count, int segments, uint64_t seed) {
    Hair hair;
    Dice dice(seed);
    for (size_t s = 0; s < count; ++s) {
        std::vector<Vec3> corners{dice.in_cube()};
        Vec3 way = dice.direction();
        for (int i = 0; i < segments; ++i) {
            corners.push_back(corners.back() + 0.1f * way);
            way = normalize(way + 0.3f * dice.in_cube());
        }
        hair.add_strand(corners, kRadius);
    }
    return hair;
}

/// Rays as arrays that a RayBatch looks into.
struct Rays {
    std::vector<float> ox, oy, oz, dx, dy, dz, t_near, t_far;
    std::vector<uint32_t> skip_first, skip_last;

    size_t size() const { return ox.size(); }
    void add(const Vec3& o, const Vec3& d, float near = 0, float far = kInfinity) {
        ox.push_back(o.x), oy.push_back(o.y), oz.push_back(o.z);
        dx.push_back(d.x), dy.push_back(d.y), dz.push_back(d.z);
        t_near.push_back(near), t_far.push_back(far);
    }
    RayBatch batch(size_t first = 0, size_t count = size_t(-1)) const {
        count = std::min(count, size() - first);
        return RayBatch{ox, oy, oz, dx, dy, dz, t_near, t_far, skip_first, skip_last}.part(first, count);
    }
};

/// From outside, from inside, along the axes and on the lattice's planes, with and without ends.
inline Rays mixed_rays(size_t n, const Vec3& middle, uint64_t seed) {
    Rays rays;
    Dice dice(seed);
    for (size_t i = 0; i < n; ++i) {
        Vec3 o = dice.in_cube(), d = dice.direction();
        const Vec3 target = dice.in_cube();
        const float scale = 0.1f + 3 * dice.unit();
        if (i % 4 == 0) {
            o *= 10.0f;
            d = normalize(target - o);
        } else if (i % 4 == 1) {
            o = round(o * 16.0f) / 16.0f + (i % 8 == 1 ? Vec3(0) : 0.01f * target);
            const int axis = dice.below(3);
            d = Vec3(0);
            d[axis] = i % 16 < 8 ? -1.0f : 1.0f;
            o[axis] = 3 * o[axis] + 0.013f;  // not on a plane itself
        }
        const float near = i % 3 == 0 ? 0.3f * dice.unit() : 0;
        rays.add(o + middle, scale * d, near, i % 5 == 0 ? near + dice.unit() : kInfinity);
    }
    return rays;
}

struct Nearest {
    std::vector<float> t, u, h;
    std::vector<uint32_t> id;

    bool operator==(const Nearest&) const = default;
};
inline Nearest nearest(const KdTree& tree, const RayBatch& rays, Isa isa = Isa::automatic) {
    const size_t n = rays.size();
    Nearest out{std::vector<float>(n), std::vector<float>(n), std::vector<float>(n), std::vector<uint32_t>(n)};
    nearest_segment(tree, rays, {out.t, out.id, out.u, out.h}, isa);
    return out;
}
inline Nearest nearest_on_mesh(const KdTree& tree, const RayBatch& rays, Isa isa = Isa::automatic) {
    const size_t n = rays.size();
    Nearest out{std::vector<float>(n), std::vector<float>(n), std::vector<float>(n), std::vector<uint32_t>(n)};
    nearest_triangle(tree, rays, {out.t, out.id, out.u, out.h}, isa);
    return out;
}

struct Constant {
    std::vector<float> transmittance;
    std::vector<uint32_t> crossings;

    bool operator==(const Constant&) const = default;
};
inline Constant constant(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                         Isa isa = Isa::automatic) {
    Constant out{std::vector<float>(rays.size()), std::vector<uint32_t>(rays.size())};
    transmittance_constant(tree, rays, transmission, cutoff, out.transmittance, out.crossings, isa);
    return out;
}

}  // namespace tress::scenes
