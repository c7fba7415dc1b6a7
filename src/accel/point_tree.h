// SPDX-License-Identifier: MIT
// A balanced kd-tree of points without pointers: the middle of a range of places splits it, what lies before it is the
// one half and what lies behind it the other. The same tree whatever the number of threads.
//
//     const PointTree tree = make_point_tree(positions);
//     std::vector<NearPoint> found;
//     find_nearest(tree, p, 50, largest_radius, [&](uint32_t place, float) { return is_wanted(tree.id[place]); },
//     found);
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <vector>

#include "core/math.h"

namespace tress {

/// Points in the order of the tree; `place` is an index into these arrays.
struct PointTree {
    std::vector<float> x, y, z;
    std::vector<uint32_t> id;   // of each point, among those given
    std::vector<uint8_t> axis;  // across which a point splits its range; of no meaning in ranges of a leaf's size
    static constexpr uint32_t kLeafPoints = 8;

    size_t size() const { return x.size(); }
    bool empty() const { return x.empty(); }
    Vec3 position(size_t place) const { return {x[place], y[place], z[place]}; }
    float along(uint32_t axis_of_split, uint32_t place) const {
        return axis_of_split == 0 ? x[place] : axis_of_split == 1 ? y[place] : z[place];
    }
    float distance2(const Vec3& p, uint32_t place) const {
        return square(x[place] - p.x) + square(y[place] - p.y) + square(z[place] - p.z);
    }
};

/// Of finite points, at most 2^32 - 1. Equal coordinates go by index.
PointTree make_point_tree(std::span<const Vec3> points);

/// `values`, one a point as given, in the order of the tree.
template <class T>
std::vector<T> in_tree_order(const PointTree& tree, std::span<const T> values) {
    std::vector<T> ordered;
    ordered.reserve(tree.size());
    for (const uint32_t id : tree.id) ordered.push_back(values[id]);
    return ordered;
}

inline size_t bytes(const PointTree& tree) {
    return tree.x.capacity() * 3 * sizeof(float) + tree.id.capacity() * sizeof(uint32_t) + tree.axis.capacity();
}

/// Places of a part of the tree, whose points are no nearer to the point asked for than the root of distance2.
struct PlaceRange {
    uint32_t begin, end;
    float distance2;

    uint32_t middle() const { return begin + (end - begin) / 2; }
};

/// Calls offer(place) for all points but those in ranges that wanted(range) turns down, in a fixed order, near ones
/// early.
template <class Offer, class Wanted>
void traverse(const PointTree& tree, const Vec3& p, const Offer& offer, const Wanted& wanted) {
    constexpr size_t kMostLevels = 32;  // sizes of 32 bits, halved
    std::array<PlaceRange, kMostLevels> pending;
    size_t depth = 0;
    PlaceRange range{0, uint32_t(tree.size()), 0};
    while (true) {
        while (range.end - range.begin > PointTree::kLeafPoints) {
            const uint32_t middle = range.middle(), axis = tree.axis[middle];
            const float beyond = p[int(axis)] - tree.along(axis, middle);
            PlaceRange near{range.begin, middle, range.distance2}, far{middle + 1, range.end, square(beyond)};
            if (beyond > 0) {
                std::swap(near.begin, far.begin);
                std::swap(near.end, far.end);
            }
            offer(middle);
            assert(depth < kMostLevels);
            pending[depth++] = far;
            range = near;
        }
        for (uint32_t place = range.begin; place < range.end; ++place) offer(place);
        do {
            if (depth == 0) return;
            range = pending[--depth];
        } while (!wanted(range));
    }
}

/// Calls visit(place, distance2) for the points nearer to `p` than the root of radius2, in a fixed order; it returns
/// the square of the radius that holds from then on, no larger than before.
template <class Visit>
void visit_near(const PointTree& tree, const Vec3& p, float radius2, const Visit& visit) {
    const auto offer = [&](uint32_t place) {
        const float distance2 = tree.distance2(p, place);
        if (distance2 < radius2) radius2 = visit(place, distance2);
    };
    traverse(tree, p, offer, [&](const PlaceRange& range) { return range.distance2 < radius2; });
}

struct NearPoint {
    float distance2;
    uint32_t place;
    bool operator<(const NearPoint& other) const { return distance2 < other.distance2; }
};

/// Up to `k` (at least 1) of the nearest points within `radius` of `p` that accept(place, distance2) takes, as a heap:
/// the farthest first. Which of several at the same distance are taken is fixed, but of no meaning.
template <class Accept>
void find_nearest(const PointTree& tree, const Vec3& p, size_t k, float radius, const Accept& accept,
                  std::vector<NearPoint>& found) {
    found.clear();
    float radius2 = square(radius);
    visit_near(tree, p, radius2, [&](uint32_t place, float distance2) {
        if (!accept(place, distance2)) return radius2;
        if (found.size() == k) {
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
        }
        found.push_back({distance2, place});
        std::push_heap(found.begin(), found.end());
        if (found.size() == k) radius2 = found.front().distance2;
        return radius2;
    });
}

inline constexpr uint32_t kNowhere = 0xffffffffu;

/// Place of the nearest point within `radius` of `p` that accept(place, distance2) takes; kNowhere: there is none.
template <class Accept>
uint32_t nearest_place(const PointTree& tree, const Vec3& p, float radius, const Accept& accept) {
    uint32_t nearest = kNowhere;
    float radius2 = square(radius);
    visit_near(tree, p, radius2, [&](uint32_t place, float distance2) {
        if (accept(place, distance2)) nearest = place, radius2 = distance2;
        return radius2;
    });
    return nearest;
}

}  // namespace tress
