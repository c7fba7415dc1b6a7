// SPDX-License-Identifier: MIT
#include "accel/subtree.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "accel/index_limit.h"

namespace tress {
namespace {

/// Where a fragment goes: its root to `slot`, its other nodes to `node` and on, its references to `reference` and on.
struct Placement {
    const Fragment* fragment;
    uint32_t slot;
    size_t node, reference;
};

struct Layout {
    std::vector<Placement> placements;
    size_t nodes = 1, references = 0;
};

/// Sizes first: fragments, in the order of the tree.
void count(const Subtree& tree, size_t& nodes, size_t& references) {
    if (tree.left) {
        nodes += 2;
        count(*tree.left, nodes, references);
        count(*tree.right, nodes, references);
    } else {
        nodes += tree.fragment.nodes.size() - 1;
        references += tree.fragment.references.size();
    }
}

/// Lays out `tree` with its root at `slot`; writes the inner nodes that lie above fragments.
void place(const Subtree& tree, uint32_t slot, Layout& layout, std::vector<KdNode>& nodes) {
    if (!tree.left) {
        layout.placements.push_back({&tree.fragment, slot, layout.nodes, layout.references});
        layout.nodes += tree.fragment.nodes.size() - 1;
        layout.references += tree.fragment.references.size();
        return;
    }
    const uint32_t pair = uint32_t(layout.nodes);
    layout.nodes += 2;
    nodes[slot] = KdNode::inner(Axis(tree.axis), tree.split, pair);
    place(*tree.left, pair, layout, nodes);
    place(*tree.right, pair + 1, layout, nodes);
}

void copy(const Placement& place, KdTopology& topology) {
    const Fragment& fragment = *place.fragment;
    for (size_t i = 0; i < fragment.nodes.size(); ++i) {
        const KdNode& from = fragment.nodes[i];
        KdNode& to = topology.nodes[i == 0 ? place.slot : place.node + i - 1];
        if (from.is_leaf())
            to = KdNode::leaf(uint32_t(place.reference + from.first_block()), from.references());
        else
            to = KdNode::inner(Axis(from.axis()), from.split(), uint32_t(place.node + from.left() - 1));
    }
    std::copy(fragment.references.begin(), fragment.references.end(),
              topology.references.begin() + std::ptrdiff_t(place.reference));
}

}  // namespace

KdTopology join(const Subtree& root, const Bounds& bounds, uint32_t index_limit) {
    size_t nodes = 1, references = 0;
    count(root, nodes, references);
    check_index_limit("nodes", nodes, index_limit);
    check_index_limit("references", references, KdNode::kMaxIndex);
    KdTopology topology{std::vector<KdNode>(nodes), std::vector<uint32_t>(references), bounds};
    Layout layout;
    place(root, 0, layout, topology.nodes);
    tbb::parallel_for(size_t(0), layout.placements.size(), [&](size_t i) { copy(layout.placements[i], topology); });
    return topology;
}

}  // namespace tress
