// SPDX-License-Identifier: MIT
// Hair by its moments, in an octree of cubes: what a cube's hair looks like from afar without its segments. The
// projected area of hair of direction t, seen along w, is 2 r L sin(t, w); summed over a cube it is nearly
// sqrt(m (m - w . M w)), with M = sum of 2 r L t t^T and m its trace: exact where all hair is parallel, and at most 4 %
// too much where it is isotropic. Leaves hold the pieces themselves, cut at their cube's faces, so that every part of
// the hair is in one cube.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/segments.h"
#include "gather/projection/hair_opacity.h"

namespace tress {

/// The eight cubes of a node. A child without hair has area 0.
struct alignas(32) MomentBlock {
    static constexpr int32_t kNoChild = INT32_MAX;

    float x[8], y[8], z[8];                          // centroid by area, relative to the tree's origin
    float hx[8], hy[8], hz[8];                       // half sizes of the box that has the spread of the hair
    float xx[8], yy[8], zz[8], xy[8], xz[8], yz[8];  // M
    int32_t child[8];                                // >= 0: block; < 0: leaf ~child
    int32_t kind[8];                                 // of HairOpacity
};

/// Pieces of all leaves, one after another. Rows belong together by index; ends are in 2^-16 of the cube of their leaf.
struct MomentPieces {
    std::vector<uint16_t> ax, ay, az, bx, by, bz;
    std::vector<uint16_t> start_radius, end_radius;  // in 1 / 65535 of the largest
    std::vector<uint32_t> segment;
};

/// One of the tree's cubes.
struct MomentCube {
    Vec3 center{0};  // relative to the tree's origin
    float half = 0;  // of its side
    int32_t child = MomentBlock::kNoChild;

    MomentCube octant(int o, int32_t of_octant) const {
        const float h = 0.5f * half;
        return {center + Vec3(o & 1 ? h : -h, o & 2 ? h : -h, o & 4 ? h : -h), h, of_octant};
    }
};

/// A box whose faces are planes between cubes of the tree.
struct MomentBox {
    Vec3 center{0};  // relative to the tree's origin
    float half = 0;  // of its side
    float cube = 0;  // side of the cubes between which its faces are

    bool meets(const MomentCube& c) const {
        // They overlap by as much as the smaller of the two kinds of cubes, or not at all.
        return max_component(abs(c.center - center)) < c.half + half - 0.25f * std::min(c.half, cube);
    }
    /// Of a cube that it meets; false for larger ones that it may hold.
    bool holds(const MomentCube& c) const { return c.half < 0.75f * cube; }
};

struct MomentTree {
    Vec3 origin{0};                             // center of the root
    float half_size = 0;                        // of the root
    float largest_radius = 0, mean_radius = 0;  // the mean over lengths
    std::vector<MomentBlock> blocks;            // blocks[0]: the children of the root; empty: no hair
    std::vector<uint32_t> leaf_first;           // piece that a leaf starts with; and one past the end
    std::vector<Vec3> leaf_low;                 // low corner of each leaf's cube, relative to origin
    std::vector<float> leaf_size;               // of its side
    MomentPieces pieces;
};

struct MomentTreeOptions {
    int leaf_pieces = 16;  // a cube with more is divided
    float least_size = 0;  // unless its sides are this short
};

/// The same tree for any number of threads.
MomentTree make_moment_tree(const SegmentView& segments, const HairOpacity& opacity, const MomentTreeOptions& options);

size_t bytes(const MomentTree& tree);

}  // namespace tress
