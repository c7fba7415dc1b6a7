// SPDX-License-Identifier: MIT
#include "accel/build.h"

#include "accel/builder.h"
#include "accel/pack_leaves.h"
#include "accel/segment_primitives.h"
#include "accel/triangle_primitives.h"

namespace tress {
namespace {

/// Where padding lanes lie: far from any scene, yet near enough that squares of it are finite.
constexpr float kFarAway = 1e18f;
/// Where padding segments lie: every comparison with it fails, so that no test passes it on.
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

template <class Primitives, class Source>
KdTree build_tree(const Source& source, const DVec3& origin, const AccelOptions& options, const TreeLimits& limits,
                  LeafBlocks (*pack)(const Primitives&, KdTopology&, uint32_t)) {
    KdTree tree;
    tree.origin = origin;
    const Primitives primitives(source, origin);
    KdTopology topology = build_topology(primitives, options, limits);
    tree.leaves = pack(primitives, topology, limits.index);
    tree.bounds = topology.bounds;
    tree.nodes = std::move(topology.nodes);
    return tree;
}

LeafBlocks pack_segments(const SegmentPrimitives& segments, KdTopology& topology, uint32_t index_limit) {
    namespace row = segment_row;
    bool varying = false;
    for (size_t i = 0; i < segments.size() && !varying; ++i)
        varying = segments[i].start_radius != segments[i].end_radius;
    const auto write = [&segments, varying](const Lane& lane, uint32_t id) {
        const AxisSegment& s = segments[id];
        const Vec3 axis(DVec3(s.end) - DVec3(s.start));
        lane[row::x] = s.start.x, lane[row::y] = s.start.y, lane[row::z] = s.start.z;
        lane[row::dx] = axis.x, lane[row::dy] = axis.y, lane[row::dz] = axis.z;
        lane[row::radius] = s.start_radius;
        lane.set_id(row::id, id);
        if (varying) lane[row::radius_slope] = float(double(s.end_radius) - s.start_radius);
    };
    const auto pad = [](const Lane& lane) {  // the rest is 0: no length, no radius
        lane[row::x] = lane[row::y] = lane[row::z] = kNowhere;
        lane.set_id(row::id, kNone);
    };
    return pack_leaves(topology, varying ? row::kVaryingRadius : row::kConstantRadius, index_limit, write, pad);
}

LeafBlocks pack_triangles(const TrianglePrimitives& triangles, KdTopology& topology, uint32_t index_limit) {
    namespace row = triangle_row;
    const auto write = [&triangles](const Lane& lane, uint32_t id) {
        for (uint32_t corner = 0; corner < 3; ++corner)
            for (uint32_t k = 0; k < 3; ++k) lane[row::ax + 3 * corner + k] = triangles[id][corner][int(k)];
        lane.set_id(row::id, id);
    };
    const auto pad = [](const Lane& lane) {  // three corners in one point
        for (uint32_t k = row::ax; k <= row::cz; ++k) lane[k] = kFarAway;
        lane.set_id(row::id, kNone);
    };
    return pack_leaves(topology, row::kRows, index_limit, write, pad);
}

float longest(const SegmentView& segments) {
    double squared = 0;
    for (size_t i = 0; i < segments.size(); ++i) {
        const DVec3 axis = DVec3(segments.end(i)) - DVec3(segments.start(i));
        squared = std::max(squared, dot(axis, axis));
    }
    constexpr double kRoundedUp = 1 + 1e-6;  // ends are rounded again about the tree's origin
    return float(kRoundedUp * std::sqrt(squared));
}

/// A middle with few digits: what has a float's digits keeps nearly all of them when it is subtracted.
DVec3 round_middle(const DBounds& box) {
    constexpr double kSteps = 64;  // of the longest side
    const double grid =
        std::exp2(std::floor(std::log2(glm::max(box.extent().x, glm::max(box.extent().y, box.extent().z)) / kSteps)));
    return grid > 0 && std::isfinite(grid) ? glm::round(box.center() / grid) * grid : box.center();
}

}  // namespace

KdTree build_segment_tree(const SegmentView& segments, const AccelOptions& options, const TreeLimits& limits) {
    if (segments.size() == 0) return {};
    const Bounds box = bounds(segments);
    const DVec3 middle = round_middle({DVec3(box.lo), DVec3(box.hi)});
    KdTree tree = build_tree<SegmentPrimitives>(segments, middle, options, limits, pack_segments);
    tree.open_ends = segments.linked;
    tree.longest_segment = longest(segments);
    return tree;
}

KdTree build_triangle_tree(const TriangleMesh& mesh, const AccelOptions& options, const TreeLimits& limits) {
    if (mesh.triangles() == 0) return {};
    DBounds box;
    for (const uint32_t corner : mesh.corner) box.add(DVec3(mesh.vertex(corner)));
    return build_tree<TrianglePrimitives>(mesh, box.center(), options, limits, pack_triangles);
}

}  // namespace tress
