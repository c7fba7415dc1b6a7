// SPDX-License-Identifier: MIT
// Hair projected by its moments: cubes that look small are splats, those that look large are opened, and the pieces of
// leaves next to the point are drawn exactly. Every part of the hair is in one cube, so nothing counts twice.
#if defined(TRESS_GATHER_PROJECTION_MOMENT_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_MOMENT_WALK_INL_H
#undef TRESS_GATHER_PROJECTION_MOMENT_WALK_INL_H
#else
#define TRESS_GATHER_PROJECTION_MOMENT_WALK_INL_H
#endif

#include <bit>

#include "gather/projection/arcs-inl.h"
#include "gather/projection/cube_pattern.h"
#include "gather/projection/far_hair.h"
#include "gather/projection/projection_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Of its distance, the size of a cube that is taken whole, however large the cells: next to larger ones, and within
/// them, light changes where no hair does, and cubes show in the picture.
inline constexpr float kWidestCube = 0.8f;

/// Fibers straight through a cube below which a point's own may be much of its hair.
inline constexpr float kLittleHair = 2;

using CubeFloats = hn::CappedTag<float, 8>;
using CubeInts = hn::RebindToSigned<CubeFloats>;
using CubeVec = hn::Vec<CubeFloats>;

/// The eight cubes of a block as seen from a point.
struct SeenCubes {
    HWY_ALIGN float x[8], y[8], z[8];  // centroids, relative to the point
    HWY_ALIGN float solid_angle[8];    // of all hair in it
    HWY_ALIGN float splats[8];         // that stand for it
    HWY_ALIGN int32_t opacity_row[8];
    uint32_t taken, opened;  // bits
};

/// What leaves alone tell apart: hair whose samples are asked, and a point's own fiber. Opened are cubes with hair as
/// near as `reach`, and cubes that the box of the fiber meets and that have so little hair that it may be much of it.
/// Without a fiber, none is met.
struct NextToPoint {
    Vec3 middle{0}, half{-std::numeric_limits<float>::infinity()};  // of the fiber's box, relative to the point
    float reach;
    float little = 0;  // area of hair, of a cube with sides of 1
};

/// Opened are cubes nearer than `reach`, and those that `next` says. `side`: of the cubes.
HWY_INLINE void look_at(const MomentBlock& b, const Vec3& from, float reach, const NextToPoint& next, float side,
                        float splats_at_reach, SeenCubes& seen) {
    const CubeFloats d;
    const CubeInts di;
    const CubeVec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const CubeVec tiny = hn::Set(d, std::numeric_limits<float>::min());
    seen.taken = seen.opened = 0;
    for (size_t i = 0; i < 8; i += hn::Lanes(d)) {
        const CubeVec x = hn::Load(d, b.x + i) - hn::Set(d, from.x), y = hn::Load(d, b.y + i) - hn::Set(d, from.y),
                      z = hn::Load(d, b.z + i) - hn::Set(d, from.z);
        const CubeVec squared = hn::Max(x * x + y * y + z * z, tiny);
        const CubeVec inverse_squared = one / squared;
        const CubeVec xx = hn::Load(d, b.xx + i), yy = hn::Load(d, b.yy + i), zz = hn::Load(d, b.zz + i);
        const CubeVec area = xx + yy + zz;
        const CubeVec mixed =
            x * y * hn::Load(d, b.xy + i) + x * z * hn::Load(d, b.xz + i) + y * z * hn::Load(d, b.yz + i);
        const CubeVec along = (x * x * xx + y * y * yy + z * z * zz + hn::Set(d, 2.0f) * mixed) * inverse_squared;
        const CubeVec difference = area - along;  // rounded by some 1e-7 of the area: what is seen end on has none
        const CubeVec across = hn::IfThenElseZero(difference > area * hn::Set(d, 1e-6f), difference);
        const CubeVec sine = hn::Sqrt(across / hn::Max(area, tiny));
        const CubeVec projected = area * sine;
        hn::Store(x, d, seen.x + i), hn::Store(y, d, seen.y + i), hn::Store(z, d, seen.z + i);
        hn::Store(projected * inverse_squared, d, seen.solid_angle + i);
        const CubeVec share = hn::Set(d, splats_at_reach * reach * reach) * inverse_squared;
        hn::Store(hn::Min(hn::Ceil(share), hn::Set(d, float(kMostSubSplats))), d, seen.splats + i);
        const auto kind = hn::Load(di, b.kind + i);
        hn::Store(opacity_rows(d, hn::Min(sine, one)) + hn::ShiftLeft<std::countr_zero(unsigned(kOpacityRows))>(kind),
                  di, seen.opacity_row + i);
        uint8_t hair[8] = {}, near[8] = {};
        hn::StoreMaskBits(d, area > zero, hair);
        const auto meets = [&](const CubeVec& v, const float* half, float own_middle, float own_half) {
            return hn::Abs(v - hn::Set(d, own_middle)) <= hn::Load(d, half + i) + hn::Set(d, own_half);
        };
        const auto off = [&](const CubeVec& v, const float* half) {
            return hn::Max(hn::Abs(v) - hn::Load(d, half + i), zero);
        };
        const auto few = area < hn::Set(d, next.little * side);
        const CubeVec off_x = off(x, b.hx), off_y = off(y, b.hy), off_z = off(z, b.hz);
        const auto beside = off_x * off_x + off_y * off_y + off_z * off_z < hn::Set(d, next.reach * next.reach);
        const auto meets_box =
            hn::And(meets(x, b.hx, next.middle.x, next.half.x),
                    hn::And(meets(y, b.hy, next.middle.y, next.half.y), meets(z, b.hz, next.middle.z, next.half.z)));
        hn::StoreMaskBits(d, hn::Or(hn::Or(hn::And(meets_box, few), beside), squared < hn::Set(d, reach * reach)),
                          near);
        seen.taken |= uint32_t(hair[0] & ~near[0]) << i;
        seen.opened |= uint32_t(hair[0] & near[0]) << i;
    }
}

/// A cube as splats: one at its centroid, or pairs about it.
HWY_INLINE void splat_cube(const MomentBlock& b, const SeenCubes& seen, size_t o, Splats& to) {
    const Floats d;
    const Ints di;
    const size_t count = size_t(seen.splats[o]) <= 1 ? 1 : (size_t(seen.splats[o]) + 1) & ~size_t(1);
    const float scale = count == 1 ? 0.0f : 1.0f;
    const FloatVec hx = set(scale * b.hx[o]), hy = set(scale * b.hy[o]), hz = set(scale * b.hz[o]);
    const FloatVec solid = set(seen.solid_angle[o] / float(count));
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
        const size_t at = to.size + i;
        hn::StoreU(set(seen.x[o]) + hx * hn::Load(d, kCubePattern.x + i), d, &to.x[at]);
        hn::StoreU(set(seen.y[o]) + hy * hn::Load(d, kCubePattern.y + i), d, &to.y[at]);
        hn::StoreU(set(seen.z[o]) + hz * hn::Load(d, kCubePattern.z + i), d, &to.z[at]);
        hn::StoreU(solid, d, &to.solid_angle[at]);
        hn::StoreU(hn::Set(di, seen.opacity_row[o]), di, &to.opacity_row[at]);
    }
    to.size += count;
}

/// The part of a segment within a box, as shares of its length; empty: first >= last.
struct PartWithin {
    float first = 0, last = 1;

    PartWithin(const MomentBox& box, const Vec3& a, const Vec3& b) {
        for (int axis = 0; axis < 3; ++axis) {
            const float along = b[axis] - a[axis], from = a[axis] - box.center[axis];
            if (along == 0) {
                if (std::abs(from) > box.half) last = -1;
                continue;
            }
            const float t = (-box.half - from) / along, u = (box.half - from) / along;
            first = std::max(first, std::min(t, u));
            last = std::min(last, std::max(t, u));
        }
    }
};

enum class Kept { whole, inside, outside };  // what of pieces, by a box

/// The pieces of leaf `~child`, or what of them is inside or outside of `box`.
template <Kept kKept, class Depth>
void draw_leaf(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, int32_t child,
               const MomentBox& box, ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const MomentTree& tree = in.tree;
    const MomentPieces& p = tree.pieces;
    const size_t leaf = size_t(~child);
    const float scale = tree.leaf_size[leaf] / 65535, radius = tree.largest_radius / 65535;
    const Vec3 offset = tree.origin - from.position;
    for (size_t i = tree.leaf_first[leaf]; i < tree.leaf_first[leaf + 1]; ++i) {
        if (unseen.holds(p.segment[i])) continue;
        const Vec3 a = tree.leaf_low[leaf] + scale * Vec3(p.ax[i], p.ay[i], p.az[i]);
        const Vec3 b = tree.leaf_low[leaf] + scale * Vec3(p.bx[i], p.by[i], p.bz[i]);
        const float start = radius * float(p.start_radius[i]), end = radius * float(p.end_radius[i]);
        const auto add = [&](float s, float t) {
            if (!(s < t)) return;
            if (scratch.pieces.full()) draw_pieces(in, from, scratch, to);
            scratch.pieces.add(s > 0 ? offset + glm::mix(a, b, s) : offset + a,
                               t < 1 ? offset + glm::mix(a, b, t) : offset + b, glm::mix(start, end, s),
                               glm::mix(start, end, t), scale, in.opacity.kind_of(p.segment[i]), p.segment[i]);
        };
        if constexpr (kKept == Kept::whole) {
            add(0, 1);
        } else {
            const PartWithin within(box, a, b);
            if constexpr (kKept == Kept::inside) {
                add(within.first, within.last);
            } else if (within.first < within.last) {
                add(0, within.first), add(within.last, 1);
            } else {
                add(0, 1);
            }
        }
    }
}

/// The walk from one point: cubes are taken as splats, or opened.
template <class Depth>
class MomentWalk {
public:
    MomentWalk(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, ProjectionScratch& scratch,
               CellDepths<Depth>& to)
        : in_(in), from_(from), unseen_(unseen), scratch_(scratch), to_(to), at_(from.position - in.tree.origin) {
        const float widest = std::min(in.opening * in.igloo.cell_size(), kWidestCube);
        per_half_ = 1 / widest;
        splats_at_reach_ = in.sub_splats * square(widest / in.igloo.cell_size());
        const MomentTree& tree = in.tree;
        next_.reach = 2 * tree.mean_radius / (in.near * in.igloo.cell_size());
        if (unseen.first > unseen.last) return;
        next_ = {unseen.box.center() - from.position, 0.5f * unseen.box.extent() + Vec3(tree.largest_radius),
                 std::max(next_.reach, (kOwnStrandRadii + 1) * tree.largest_radius),
                 kLittleHair * 2 * tree.largest_radius};
    }

    /// All hair.
    void everything() {
        if (in_.tree.blocks.empty()) return;
        open({Vec3(0), in_.tree.half_size, 0});
        run([](const MomentCube&, SeenCubes&) {});
    }

    /// Hair in the box of `far`.
    void near(const FarHair& far) {
        for (const MomentCube& cube : far.near) {
            if (cube.child >= 0)
                open(cube);
            else if (far.near_box.holds(cube))
                draw_leaf<Kept::whole>(in_, from_, unseen_, cube.child, far.near_box, scratch_, to_);
            else
                draw_leaf<Kept::inside>(in_, from_, unseen_, cube.child, far.near_box, scratch_, to_);
        }
        run([](const MomentCube&, SeenCubes&) {});
    }

    /// Hair outside the box of `far`; the cubes inside are listed.
    void beyond(FarHair& far) {
        if (in_.tree.blocks.empty()) return;
        open({Vec3(0), in_.tree.half_size, 0});
        run([&](const MomentCube& cube, SeenCubes& seen) {
            if (far.near_box.meets(cube)) split(cube, far, seen);
        });
    }

private:
    void open(const MomentCube& cube) { stack_[entries_++] = cube; }

    /// Of the cubes of a block, takes away from `seen` those that the box of `far` meets.
    void split(const MomentCube& of, FarHair& far, SeenCubes& seen) {
        const MomentBlock& block = in_.tree.blocks[size_t(of.child)];
        for (int o = 0; o < 8; ++o) {
            const uint32_t bit = 1u << o;
            if (!((seen.taken | seen.opened) & bit)) continue;
            const MomentCube cube = of.octant(o, block.child[o]);
            if (!far.near_box.meets(cube)) continue;
            seen.taken &= ~bit, seen.opened &= ~bit;
            const bool leaf = cube.child < 0, held = far.near_box.holds(cube);
            if (leaf || held) far.near.push_back(cube);
            if (leaf && !held)
                draw_leaf<Kept::outside>(in_, from_, unseen_, cube.child, far.near_box, scratch_, to_);
            else if (!held)
                open(cube);
        }
    }

    /// Below the horizon of a polygon, whole.
    bool hidden(const SeenCubes& seen, size_t o, float half) const {
        return from_.dome == Dome::hemisphere && dot(from_.frame.z, Vec3(seen.x[o], seen.y[o], seen.z[o])) < -2 * half;
    }

    /// Empties the stack. split(cube, seen) may take away cubes of a block that is opened.
    template <class Split>
    void run(const Split& split) {
        SeenCubes seen;
        while (entries_ > 0) {
            const MomentCube cube = stack_[--entries_];
            const MomentBlock& block = in_.tree.blocks[size_t(cube.child)];
            look_at(block, at_, cube.half * per_half_, next_, cube.half, splats_at_reach_, seen);
            split(cube, seen);
            for (uint32_t bits = seen.taken; bits != 0; bits &= bits - 1) {
                const size_t o = size_t(std::countr_zero(bits));
                if (hidden(seen, o, cube.half)) continue;
                if (!scratch_.cube_splats.has_room(kMostSubSplats))
                    add_splats<SplatOf::cube>(in_.igloo, from_, in_.opacity, scratch_.cube_splats, to_);
                splat_cube(block, seen, o, scratch_.cube_splats);
            }
            for (uint32_t bits = seen.opened; bits != 0; bits &= bits - 1) {
                const size_t o = size_t(std::countr_zero(bits));
                if (hidden(seen, o, cube.half)) continue;
                if (block.child[o] >= 0)
                    open(cube.octant(int(o), block.child[o]));
                else
                    draw_leaf<Kept::whole>(in_, from_, unseen_, block.child[o], {}, scratch_, to_);
            }
        }
        finish_pieces(in_, from_, scratch_, to_);
        add_splats<SplatOf::cube>(in_.igloo, from_, in_.opacity, scratch_.cube_splats, to_);
    }

    const ProjectionInput& in_;
    const Viewpoint& from_;
    const Unseen& unseen_;
    ProjectionScratch& scratch_;
    CellDepths<Depth>& to_;
    Vec3 at_;
    float per_half_;  // distance at which a cube is taken whose parent is of half side 1
    float splats_at_reach_;
    NextToPoint next_{};
    static constexpr size_t kDeepest = 24;  // of the tree (kMostDepth of moment_tree.cpp), and some
    MomentCube stack_[8 * kNearCubes * kNearCubes * kNearCubes + 8 * kDeepest];
    size_t entries_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
