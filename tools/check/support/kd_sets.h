// SPDX-License-Identifier: MIT
// Sets of segments and triangles that are hard on a kd-tree, and what tests ask of a built one.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "accel/build.h"
#include "core/rng.h"

namespace tress::scenes {

/// Segments with points of their own.
struct SegmentSet {
    std::string name;
    std::vector<float> x, y, z, radius;
    std::vector<uint32_t> point;

    void add(const Vec3& start, const Vec3& end, float start_radius, float end_radius) {
        point.push_back(uint32_t(x.size()));
        for (const Vec3& p : {start, end}) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
        radius.push_back(start_radius);
        radius.push_back(end_radius);
    }
    void add(const Vec3& start, const Vec3& end, float r) { add(start, end, r, r); }

    SegmentView view() const {
        SegmentView v;
        v.x = x, v.y = y, v.z = z, v.radius = radius, v.point = point;
        v.linked = false;
        return v;
    }
};

/// A stream of random numbers.
struct Stream {
    uint64_t key, next = 0;
    float unit() { return random(key, next++); }
    float in(float lo, float hi) { return lo + (hi - lo) * unit(); }
    Vec3 vector(float lo, float hi) {
        const float x = in(lo, hi);
        const float y = in(lo, hi);
        const float z = in(lo, hi);
        return {x, y, z};
    }
};

inline SegmentSet random_segments(size_t n, float length, float radius, uint64_t seed = 1) {
    SegmentSet set;
    set.name = "random";
    Stream stream{seed};
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = stream.vector(-1, 1);
        set.add(start, start + stream.vector(-length, length), radius);
    }
    return set;
}

/// Tapered, of very different lengths, in clumps far from each other and from the origin.
inline SegmentSet clumped_segments(size_t n) {
    SegmentSet set;
    set.name = "clumped, tapered";
    Stream stream{2};
    const Vec3 clumps[] = {{100, 0, 0}, {101, 0, 0}, {100, 7, 3}, {-40, 7, 3}};
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = clumps[i % 4] + stream.vector(-0.2f, 0.2f);
        const float length = std::exp2(stream.in(-8, 1));
        const float r0 = stream.in(0.001f, 0.02f);
        const float r1 = stream.in(0.0f, 0.02f);
        set.add(start, start + stream.vector(-length, length), r0, r1);
    }
    return set;
}

/// Along the axes on a lattice, with radii that put faces of boxes on one another and on the planes of bins.
inline SegmentSet lattice_segments(int side) {
    SegmentSet set;
    set.name = "lattice";
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            for (int k = 0; k < 3; ++k) {
                Vec3 start(0), end(0);
                start[k] = 0, end[k] = float(side);
                start[(k + 1) % 3] = end[(k + 1) % 3] = float(i);
                start[(k + 2) % 3] = end[(k + 2) % 3] = float(j);
                set.add(start, end, 0.25f);
            }
    return set;
}

inline SegmentSet coincident_segments(size_t n) {
    SegmentSet set;
    set.name = "coincident";
    for (size_t i = 0; i < n; ++i) set.add({0, 0, 0}, {1, 2, 3}, 0.01f);
    return set;
}

inline SegmentSet coplanar_segments(size_t n) {
    SegmentSet set = random_segments(n, 0.1f, 1e-7f, 3);
    set.name = "coplanar, hardly any radius";
    for (float& z : set.z) z = 5;
    return set;
}

inline SegmentSet collinear_segments(size_t n) {
    SegmentSet set;
    set.name = "collinear";
    for (size_t i = 0; i < n; ++i) set.add({float(i), 0, 0}, {float(i + 1), 0, 0}, 1e-6f);
    return set;
}

/// Each half as large and half as far from a corner as the one before.
inline SegmentSet geometric_segments(int n) {
    SegmentSet set;
    set.name = "geometric series";
    for (int i = 0; i < n; ++i) {
        const float s = std::exp2(float(-i % 100));
        for (int copy = 0; copy < 8; ++copy)
            set.add(Vec3(s), Vec3(s * 1.25f, s * (1 + 0.03f * float(copy)), s), s * 0.01f);
    }
    return set;
}

inline std::vector<SegmentSet> hard_sets(size_t n) {
    std::vector<SegmentSet> sets;
    sets.push_back(random_segments(n, 0.5f, 0.01f));
    sets.push_back(clumped_segments(n));
    sets.push_back(lattice_segments(int(std::sqrt(float(n) / 3))));
    sets.push_back(coincident_segments(n / 4));
    sets.push_back(coplanar_segments(n));
    sets.push_back(collinear_segments(n));
    sets.push_back(geometric_segments(int(n / 16)));
    return sets;
}

/// Options that make deep trees of small sets.
inline AccelOptions deep_options(SplitMethod split = SplitMethod::binned) {
    AccelOptions options;
    options.split = split;
    options.traversal_cost = 2;
    options.exact_below = 8;
    return options;
}

/// The leaf whose cell holds the point, in the tree's coordinates.
inline const KdNode& leaf_at(const KdTree& tree, const Vec3& p) {
    const KdNode* node = tree.nodes.data();
    while (!node->is_leaf()) node = &tree.nodes[node->left() + (p[int(node->axis())] < node->split() ? 0 : 1)];
    return *node;
}

inline float lane_value(const KdTree& tree, const KdNode& leaf, uint32_t lane, uint32_t row) {
    return tree.leaves.block(leaf.first_block() + lane / kLanes)[row * kLanes + lane % kLanes];
}

/// Identities of a leaf; `id_row` is segment_row::id or triangle_row::id.
inline std::vector<uint32_t> leaf_ids(const KdTree& tree, const KdNode& leaf, uint32_t id_row) {
    std::vector<uint32_t> ids;
    for (uint32_t k = 0; k < leaf.references(); ++k)
        ids.push_back(std::bit_cast<uint32_t>(lane_value(tree, leaf, k, id_row)));
    return ids;
}

inline bool same_tree(const KdTree& a, const KdTree& b) {
    const LeafBlocks &p = a.leaves, &q = b.leaves;
    return a.nodes.size() == b.nodes.size() && p.rows == q.rows && p.values.size() == q.values.size() &&
           std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(KdNode)) == 0 &&
           (p.values.size() == 0 || std::memcmp(p.values.data(), q.values.data(), bytes(p)) == 0);
}

struct LeafCell {
    const KdNode* leaf;
    Bounds cell;
};

/// All leaves with their cells, whose upper faces belong to the neighbours.
inline void collect_cells(const KdTree& tree, uint32_t node, const Bounds& cell, std::vector<LeafCell>& out) {
    const KdNode& n = tree.nodes[node];
    if (n.is_leaf()) {
        out.push_back({&n, cell});
        return;
    }
    Bounds left = cell, right = cell;
    left.hi[int(n.axis())] = right.lo[int(n.axis())] = n.split();
    collect_cells(tree, n.left(), left, out);
    collect_cells(tree, n.left() + 1, right, out);
}
inline std::vector<LeafCell> leaf_cells(const KdTree& tree) {
    std::vector<LeafCell> cells;
    collect_cells(tree, 0, tree.bounds, cells);
    return cells;
}

}  // namespace tress::scenes
