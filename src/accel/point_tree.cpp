// SPDX-License-Identifier: MIT
#include "accel/point_tree.h"

#include <tbb/parallel_invoke.h>

#include "accel/index_limit.h"
#include "core/bounds.h"

namespace tress {
namespace {

struct IndexedPoint {
    Vec3 position;
    uint32_t id;
};

uint32_t widest_axis(std::span<const IndexedPoint> points) {
    Bounds box;
    for (const IndexedPoint& point : points) box.add(point.position);
    const Vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// Puts the middle of `points` in its place across their widest axis, and then both halves. What goes to which side
/// depends on coordinates and ids alone, as no two points are equal in both.
void arrange(std::span<IndexedPoint> points, std::span<uint8_t> axes) {
    constexpr size_t kParallelAbove = 8192;
    if (points.size() <= PointTree::kLeafPoints) {
        std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
        return;
    }
    const uint32_t axis = widest_axis(points);
    const size_t middle = points.size() / 2;
    std::nth_element(points.begin(), points.begin() + ptrdiff_t(middle), points.end(),
                     [axis](const IndexedPoint& a, const IndexedPoint& b) {
                         const float u = a.position[int(axis)], v = b.position[int(axis)];
                         return u != v ? u < v : a.id < b.id;
                     });
    axes[middle] = uint8_t(axis);
    const auto before = [&] { arrange(points.first(middle), axes.first(middle)); };
    const auto behind = [&] { arrange(points.subspan(middle + 1), axes.subspan(middle + 1)); };
    if (points.size() > kParallelAbove) {
        tbb::parallel_invoke(before, behind);
    } else {
        before();
        behind();
    }
}

}  // namespace

PointTree make_point_tree(std::span<const Vec3> points) {
    check_index_limit("points", points.size(), kNowhere);
    std::vector<IndexedPoint> arranged(points.size());
    for (uint32_t i = 0; i < points.size(); ++i) arranged[i] = {points[i], i};
    PointTree tree;
    tree.axis.resize(points.size());
    arrange(arranged, tree.axis);
    for (auto* floats : {&tree.x, &tree.y, &tree.z}) floats->resize(points.size());
    tree.id.resize(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
        const auto& [position, id] = arranged[i];
        tree.x[i] = position.x, tree.y[i] = position.y, tree.z[i] = position.z, tree.id[i] = id;
    }
    return tree;
}

}  // namespace tress
