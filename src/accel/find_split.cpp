// SPDX-License-Identifier: MIT
#include "accel/find_split.h"

#include <algorithm>

#include "accel/binned_split.h"
#include "accel/kd_node.h"
#include "accel/median_split.h"

namespace tress {
namespace {

constexpr float kDeepest = 60;  // levels, whatever the options say: traversals keep a stack of fixed size

}  // namespace

std::optional<Split> find_split(std::span<const Reference> references, const Bounds& cell, const AccelOptions& options,
                                SplitScratch& scratch) {
    switch (options.split) {
        case SplitMethod::binned:
            if (references.size() > size_t(options.exact_below)) return binned_split(references, cell, options);
            return sweep_split(references, cell, options, scratch.faces);
        case SplitMethod::exact:  // has sorted faces of its own, see exact_node.h
        case SplitMethod::naive:
            return sweep_split(references, cell, options, scratch.faces);
        case SplitMethod::spatial_median:
            return spatial_median_split(references, cell, options);
        case SplitMethod::object_median:
            return object_median_split(references, cell, options, scratch.centers);
    }
    return std::nullopt;
}

PendingNode root_node(const Bounds& bounds, size_t primitives, const AccelOptions& options) {
    const float depth = options.depth_base + options.depth_factor * std::log2(float(std::max<size_t>(primitives, 1)));
    const auto references = uint64_t(double(options.references) * double(primitives));
    return {.cell = bounds,
            .levels_left = uint32_t(std::clamp(depth, 0.0f, kDeepest)),
            .failed_splits_left = options.failed_splits,
            .budget = std::clamp<uint64_t>(references, primitives, KdNode::kMaxIndex)};
}

bool may_split(const PendingNode& node, size_t references, const AccelOptions& options) {
    if (references == 0 || node.levels_left == 0) return false;
    if (!options.automatic) return references > size_t(options.leaf_size);
    return least_split_cost(options) < float(references) || node.failed_splits_left > 0;
}

bool takes(const Split& split, const PendingNode& node, size_t references, const AccelOptions& options) {
    if (split.left == references && split.right == references) return false;
    if (uint64_t(split.left) + split.right > node.budget) return false;
    return !options.automatic || split.cost < float(references) || node.failed_splits_left > 0;
}

PendingPair children(const PendingNode& node, const Split& split, size_t references, size_t left, size_t right) {
    PendingNode child = node;
    --child.levels_left;
    if (!(split.cost < float(references))) --child.failed_splits_left;
    PendingPair pair{child, child};
    pair.left.cell = left_cell(node.cell, split.axis, split.position);
    pair.right.cell = right_cell(node.cell, split.axis, split.position);
    // Shares of the budget in proportion to the references: no share depends on what the other subtree does.
    const double share = double(left) / double(std::max<size_t>(left + right, 1));
    pair.left.budget = std::max<uint64_t>(left, uint64_t(double(node.budget) * share));
    pair.right.budget = std::max<uint64_t>(right, uint64_t(double(node.budget) * (1 - share)));
    return pair;
}

}  // namespace tress
