// SPDX-License-Identifier: MIT
#include "gather/projection/moment_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gather/projection/hair_cube.h"
#include "gather/projection/hair_moments.h"

namespace tress {
namespace {

constexpr int kMostDepth = 20;
constexpr int kParallelDepth = 2;  // levels whose cubes are built side by side

struct Cube {
    DVec3 center;
    double half;

    Cube octant(int o) const {
        const double h = 0.5 * half;
        return {center + DVec3(o & 1 ? h : -h, o & 2 ? h : -h, o & 4 ? h : -h), h};
    }
};

/// A part of a tree, with indices of its own.
struct Part {
    std::vector<MomentBlock> blocks;
    std::vector<uint32_t> leaf_first = {0};
    std::vector<Vec3> leaf_low;
    std::vector<float> leaf_size;
    MomentPieces pieces;

    size_t leaves() const { return leaf_low.size(); }
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Every row of pieces; of two, with the like row of the other.
template <class F, class... P>
void for_each_row(const F& f, P&... p) {
    f(p.ax...), f(p.ay...), f(p.az...), f(p.bx...), f(p.by...), f(p.bz...);
    f(p.start_radius...), f(p.end_radius...), f(p.segment...);
}

/// Room for what parts add: as much as is needed, so that nothing moves meanwhile and nothing is left over.
void reserve(Part& to, std::span<const Part> parts) {
    size_t blocks = to.blocks.size(), leaves = to.leaves(), pieces = to.pieces.segment.size();
    for (const Part& part : parts) {
        blocks += part.blocks.size();
        leaves += part.leaves();
        pieces += part.pieces.segment.size();
    }
    to.blocks.reserve(blocks);
    to.leaf_first.reserve(leaves + 1);
    to.leaf_low.reserve(leaves);
    to.leaf_size.reserve(leaves);
    for_each_row([&](auto& row) { row.reserve(pieces); }, to.pieces);
}

/// Appends a part; returns by how much its blocks and leaves have moved.
std::pair<int32_t, int32_t> append(Part& to, const Part& from) {
    const int32_t block = int32_t(to.blocks.size()), leaf = int32_t(to.leaves());
    const uint32_t piece = uint32_t(to.pieces.segment.size());
    for (MomentBlock b : from.blocks) {
        for (int32_t& child : b.child)
            if (child != MomentBlock::kNoChild) child = child >= 0 ? child + block : child - leaf;
        to.blocks.push_back(b);
    }
    for (size_t i = 1; i < from.leaf_first.size(); ++i) to.leaf_first.push_back(from.leaf_first[i] + piece);
    append(to.leaf_low, from.leaf_low);
    append(to.leaf_size, from.leaf_size);
    for_each_row([](auto& row, const auto& more) { append(row, more); }, to.pieces, from.pieces);
    return {block, leaf};
}

struct Root {
    int32_t child = MomentBlock::kNoChild;  // as in a block
    HairMoments moments;
};

class Builder {
public:
    Builder(const HairOpacity& opacity, const MomentTreeOptions& options, float largest_radius)
        : opacity_(opacity), options_(options), largest_radius_(largest_radius) {}

    /// Hair in one cube: a leaf, or a block of smaller cubes.
    Root build(const Cube& cube, std::vector<HairPiece>& pieces, int depth, Part& to) const {
        if (pieces.empty()) return {};
        const bool small = 2 * cube.half <= double(options_.least_size) || depth >= kMostDepth;
        if (depth > 0 && (small || int(pieces.size()) <= options_.leaf_pieces)) return make_leaf(cube, pieces, to);
        std::array<std::vector<HairPiece>, 8> parts = divide(cube, pieces);
        pieces = {};
        const size_t at = to.blocks.size();
        to.blocks.emplace_back();
        std::array<Root, 8> roots;
        if (depth < kParallelDepth)
            build_side_by_side(cube, parts, depth, to, roots);
        else
            for (int o = 0; o < 8; ++o) roots[size_t(o)] = build(cube.octant(o), parts[size_t(o)], depth + 1, to);
        Root root{int32_t(at), {}};
        for (int o = 0; o < 8; ++o) {
            store(roots[size_t(o)], cube.octant(o), o, to.blocks[at]);
            root.moments.add(roots[size_t(o)].moments);
        }
        return root;
    }

private:
    void build_side_by_side(const Cube& cube, std::array<std::vector<HairPiece>, 8>& parts, int depth, Part& to,
                            std::array<Root, 8>& roots) const {
        std::array<Part, 8> built;
        tbb::parallel_for(0, 8, [&](int o) {
            roots[size_t(o)] = build(cube.octant(o), parts[size_t(o)], depth + 1, built[size_t(o)]);
        });
        reserve(to, built);
        for (size_t o = 0; o < 8; ++o) {
            const auto [block, leaf] = append(to, built[o]);
            built[o] = {};
            int32_t& child = roots[o].child;
            if (child != MomentBlock::kNoChild) child = child >= 0 ? child + block : child - leaf;
        }
    }

    static std::array<std::vector<HairPiece>, 8> divide(const Cube& cube, const std::vector<HairPiece>& pieces) {
        std::array<std::vector<HairPiece>, 8> parts;
        for (const HairPiece& piece : pieces)
            cut_at(piece, cube.center,
                   [&](const HairPiece& part, int octant) { parts[size_t(octant)].push_back(part); });
        return parts;
    }

    Root make_leaf(const Cube& cube, const std::vector<HairPiece>& pieces, Part& to) const {
        Root root{~int32_t(to.leaves()), {}};
        const DVec3 low = cube.center - cube.half;
        const double scale = 65535 / (2 * cube.half);
        const auto place = [&](float x, double from) {
            return uint16_t(std::clamp(std::lround((double(x) - from) * scale), 0l, 65535l));
        };
        const auto width = [&](float radius) {
            return uint16_t(std::lround(double(radius) * 65535 / double(largest_radius_)));
        };
        MomentPieces& p = to.pieces;
        for (const HairPiece& piece : pieces) {
            root.moments.add(piece);
            p.ax.push_back(place(piece.a.x, low.x)), p.bx.push_back(place(piece.b.x, low.x));
            p.ay.push_back(place(piece.a.y, low.y)), p.by.push_back(place(piece.b.y, low.y));
            p.az.push_back(place(piece.a.z, low.z)), p.bz.push_back(place(piece.b.z, low.z));
            p.start_radius.push_back(width(piece.radius_a)), p.end_radius.push_back(width(piece.radius_b));
            p.segment.push_back(piece.segment);
        }
        to.leaf_first.push_back(uint32_t(p.segment.size()));
        to.leaf_low.push_back(Vec3(low));
        to.leaf_size.push_back(float(2 * cube.half));
        return root;
    }

    void store(const Root& root, const Cube& cube, int o, MomentBlock& b) const {
        b.child[o] = root.child;
        const HairMoments& m = root.moments;
        if (root.child == MomentBlock::kNoChild || !(m.area > 0)) return;
        const DVec3 mean = m.first / m.area;
        const DVec3 room = cube.half - abs(mean - cube.center);  // a box about the mean stays in its cube
        const auto half_size = [&](int axis) {
            const double variance = std::max(m.second[axis] / m.area - square(mean[axis]), 0.0);
            return float(std::min(std::sqrt(3 * variance), std::max(room[axis], 0.0)));
        };
        b.x[o] = float(mean.x), b.y[o] = float(mean.y), b.z[o] = float(mean.z);
        b.hx[o] = half_size(0), b.hy[o] = half_size(1), b.hz[o] = half_size(2);
        b.xx[o] = float(m.tensor[0]), b.yy[o] = float(m.tensor[1]), b.zz[o] = float(m.tensor[2]);
        b.xy[o] = float(m.tensor[3]), b.xz[o] = float(m.tensor[4]), b.yz[o] = float(m.tensor[5]);
        b.kind[o] = int32_t(opacity_.kind_of(m.sample));
    }

    const HairOpacity& opacity_;
    const MomentTreeOptions& options_;
    const float largest_radius_;
};

std::vector<HairPiece> all_pieces(const SegmentView& segments, const DVec3& origin) {
    std::vector<HairPiece> pieces(segments.size());
    tbb::parallel_for(size_t(0), segments.size(), [&](size_t i) {
        pieces[i] = {Vec3(DVec3(segments.start(i)) - origin), Vec3(DVec3(segments.end(i)) - origin),
                     segments.start_radius(i), segments.end_radius(i), uint32_t(i)};
    });
    return pieces;
}

}  // namespace

MomentTree make_moment_tree(const SegmentView& segments, const HairOpacity& opacity, const MomentTreeOptions& options) {
    MomentTree tree;
    if (segments.size() == 0) return tree;
    const HairCube root = hair_cube(bounds(segments));
    tree.origin = root.center;
    tree.half_size = root.half;
    double area = 0, length = 0;
    for (size_t i = 0; i < segments.size(); ++i) {
        const float start = segments.start_radius(i), end = segments.end_radius(i);
        tree.largest_radius = std::max({tree.largest_radius, start, end});
        const double long_by = double(glm::distance(segments.start(i), segments.end(i)));
        area += 0.5 * (double(start) + double(end)) * long_by, length += long_by;
    }
    tree.mean_radius = length > 0 ? float(area / length) : tree.largest_radius;
    std::vector<HairPiece> pieces = all_pieces(segments, DVec3(tree.origin));
    Part part;
    Builder(opacity, options, tree.largest_radius).build({DVec3(0), double(tree.half_size)}, pieces, 0, part);
    tree.blocks = std::move(part.blocks);
    tree.leaf_first = std::move(part.leaf_first);
    tree.leaf_low = std::move(part.leaf_low);
    tree.leaf_size = std::move(part.leaf_size);
    tree.pieces = std::move(part.pieces);
    return tree;
}

size_t bytes(const MomentTree& t) {
    return t.blocks.capacity() * sizeof(MomentBlock) + t.leaf_first.capacity() * sizeof(uint32_t) +
           t.leaf_low.capacity() * sizeof(Vec3) + t.leaf_size.capacity() * sizeof(float) +
           t.pieces.segment.capacity() * (8 * sizeof(uint16_t) + sizeof(uint32_t));
}

}  // namespace tress
