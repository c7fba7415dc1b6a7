// SPDX-License-Identifier: MIT
// How far hair is seen in each cell about a point, where polygons among it end the sight.
#if defined(TRESS_GATHER_PROJECTION_SIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_SIGHT_INL_H
#undef TRESS_GATHER_PROJECTION_SIGHT_INL_H
#else
#define TRESS_GATHER_PROJECTION_SIGHT_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <vector>

#include "gather/projection/add_splats-inl.h"
#include "gather/projection/cell_light-inl.h"
#include "gather/projection/light_probe.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

struct Rotated {
    FloatVec x, y, z;
};
HWY_INLINE Rotated to_local(const Frame& f, FloatVec x, FloatVec y, FloatVec z) {
    return {dot3(set(f.x.x), set(f.x.y), set(f.x.z), x, y, z), dot3(set(f.y.x), set(f.y.y), set(f.y.z), x, y, z),
            dot3(set(f.z.x), set(f.z.y), set(f.z.z), x, y, z)};
}
HWY_INLINE Rotated to_world(const Frame& f, FloatVec x, FloatVec y, FloatVec z) {
    return {dot3(set(f.x.x), set(f.y.x), set(f.z.x), x, y, z), dot3(set(f.x.y), set(f.y.y), set(f.z.y), x, y, z),
            dot3(set(f.x.z), set(f.y.z), set(f.z.z), x, y, z)};
}

/// Distance of the polygon in each cell of a probe where it is among the hair; elsewhere infinity.
HWY_INLINE FloatVec among_distance(const LightProbe& probe, IntVec cell) {
    const Floats d;
    static_assert(sizeof(ProbeCell) == 8 && offsetof(ProbeCell, signed_distance) == 0);
    const FloatVec distance = hn::GatherIndex(d, &probe.cells[0].signed_distance, cell + cell);
    return hn::IfThenElse(distance < hn::Zero(d), hn::Neg(distance), set(kInfinity));
}

/// The farthest of what the probe sees in each cell: what hair is nearer counts.
inline void see_farthest(const LightProbe& probe, const Igloo& probe_igloo, const Igloo& igloo, const Viewpoint& from,
                         std::vector<float>& sight) {
    const Floats d;
    const Ints di;
    const Vec3 apart = probe.position - from.position;
    const IntVec last = hn::Set(di, int32_t(probe.cells.size()) - 1);
    for (size_t i = 0; i < probe.cells.size(); i += hn::Lanes(d)) {
        const FloatVec distance = among_distance(probe, hn::Min(counted_from(int32_t(i)), last));
        if (hn::AllTrue(d, distance == set(kInfinity))) continue;
        const Rotated middle = to_world(probe.frame, hn::LoadU(d, &probe_igloo.center_x[i]),
                                        hn::LoadU(d, &probe_igloo.center_y[i]), hn::LoadU(d, &probe_igloo.center_z[i]));
        const FloatVec x = distance * middle.x + set(apart.x), y = distance * middle.y + set(apart.y),
                       z = distance * middle.z + set(apart.z);
        const FloatVec squared = dot3(x, y, z, x, y, z), inverse = inverse_sqrt(hn::Max(squared, set(1e-30f)));
        const Rotated local = to_local(from.frame, x * inverse, y * inverse, z * inverse);
        HWY_ALIGN int32_t cell[kMostLanes];
        HWY_ALIGN float far[kMostLanes];
        hn::Store(cells_of(igloo, local.x, local.y, local.z), di, cell);
        hn::Store(squared, d, far);
        for (size_t lane = 0; lane < hn::Lanes(d); ++lane)
            if (far[lane] < kInfinity && size_t(cell[lane]) < sight.size())  // else below a polygon's horizon
                sight[size_t(cell[lane])] = std::max(sight[size_t(cell[lane])], far[lane]);
    }
}

/// What the probe sees along each cell's middle, where nothing has fallen into the cell.
inline void see_middles(const LightProbe& probe, const Igloo& probe_igloo, const Igloo& igloo, const Viewpoint& from,
                        std::vector<float>& sight) {
    const Floats d;
    const FloatVec apart = set(length(probe.position - from.position)), zero = hn::Zero(d);
    for (size_t i = 0; i < sight.size(); i += hn::Lanes(d)) {
        const Rotated world = to_world(from.frame, hn::LoadU(d, &igloo.center_x[i]), hn::LoadU(d, &igloo.center_y[i]),
                                       hn::LoadU(d, &igloo.center_z[i]));
        const Rotated local = to_local(probe.frame, world.x, world.y, world.z);
        const FloatVec far = among_distance(probe, cells_of(probe_igloo, local.x, local.y, local.z)) + apart;
        const FloatVec found = hn::LoadU(d, &sight[i]);
        hn::StoreU(hn::IfThenElse(found > zero, found, far * far), d, &sight[i]);
    }
}

/// Replaces `sight`; rows past the last cell hold anything.
inline void find_sight(const LightProbe& probe, const Igloo& probe_igloo, const Igloo& igloo, const Viewpoint& from,
                       std::vector<float>& sight) {
    sight.assign(padded(igloo.cells_of(from.dome)), 0);
    see_farthest(probe, probe_igloo, igloo, from, sight);
    see_middles(probe, probe_igloo, igloo, from, sight);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
