// SPDX-License-Identifier: MIT
#include "accel/statistics.h"

#include <algorithm>
#include <vector>

namespace tress {
namespace {

double half_area(const DBounds& cell) {
    const DVec3 e = cell.extent();
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

struct Visit {
    uint32_t node, depth;
    DBounds cell;
};

}  // namespace

TreeStatistics statistics(const KdTree& tree, uint64_t primitives, const AccelOptions& options) {
    TreeStatistics s;
    s.bytes = bytes(tree);
    s.nodes = tree.nodes.size();
    if (tree.empty()) return s;
    const DBounds root{DVec3(tree.bounds.lo), DVec3(tree.bounds.hi)};
    const double root_area = half_area(root);
    std::vector<Visit> stack{{0, 0, root}};
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const KdNode& node = tree.nodes[visit.node];
        const double share = root_area > 0 ? half_area(visit.cell) / root_area : 1;
        s.depth = std::max(s.depth, visit.depth);
        if (node.is_leaf()) {
            ++s.leaves;
            s.empty_leaves += node.references() == 0;
            s.references += node.references();
            s.sah_tests += share * double(node.references());
            continue;
        }
        s.sah_steps += share;
        Visit left{node.left(), visit.depth + 1, visit.cell}, right{node.left() + 1, visit.depth + 1, visit.cell};
        left.cell.hi[int(node.axis())] = right.cell.lo[int(node.axis())] = double(node.split());
        stack.push_back(right);
        stack.push_back(left);
    }
    s.sah_cost = s.sah_steps * double(options.traversal_cost) + s.sah_tests;
    s.references_per_primitive = primitives > 0 ? double(s.references) / double(primitives) : 0;
    const uint64_t filled = s.leaves - s.empty_leaves;
    s.references_per_leaf = filled > 0 ? double(s.references) / double(filled) : 0;
    return s;
}

}  // namespace tress
