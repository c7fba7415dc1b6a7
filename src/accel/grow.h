// SPDX-License-Identifier: MIT
// The recursion that grows a kd-tree, whatever a node holds of its primitives ("Node", below): find a split, take it
// or make a leaf, share out, recurse. Large nodes are shared between tasks; where that ends depends on sizes alone.
//
// A Node has
//     size()                                  references
//     find(cell, options)                     the best split, if any
//     divide(split, options)                  {left, right}: Nodes; destroys the contents of this one
//     append_ids(out)                         the primitives of a leaf, ascending
//     serial(scratch)                         itself, as the Node type that one task works on
#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include "accel/find_split.h"
#include "accel/subtree.h"
#include "accel/tree_limits.h"

namespace tress {

/// References up to which a node and all below it are one task's work. At 28 bytes a reference they fit a core's cache.
inline constexpr size_t kTaskSize = 32768;

template <class Node>
std::optional<Split> choose_split(Node& node, const PendingNode& pending, const AccelOptions& options) {
    if (!may_split(pending, node.size(), options)) return std::nullopt;
    std::optional<Split> split = node.find(pending.cell, options);
    if (split && !takes(*split, pending, node.size(), options)) split.reset();
    return split;
}

/// Recursion is bounded by the depth limit of 60. The right child first: its references lie on top of the left one's.
template <class Node>
void grow_serial(Node node, const PendingNode& pending, const AccelOptions& options, uint32_t slot, Fragment& out) {
    const size_t references = node.size();
    const std::optional<Split> split = choose_split(node, pending, options);
    if (!split) {
        out.nodes[slot] = KdNode::leaf(uint32_t(out.references.size()), uint32_t(references));
        node.append_ids(out.references);
        return;
    }
    const uint32_t left = uint32_t(out.nodes.size());
    out.nodes.resize(out.nodes.size() + 2);
    out.nodes[slot] = KdNode::inner(Axis(split->axis), split->position, left);
    auto [left_node, right_node] = node.divide(*split, options);
    const PendingPair pair = children(pending, *split, references, left_node.size(), right_node.size());
    grow_serial(std::move(right_node), pair.right, options, left + 1, out);
    grow_serial(std::move(left_node), pair.left, options, left, out);
}

template <class Node, class Scratch>
std::unique_ptr<Subtree> grow(Node node, const PendingNode& pending, const AccelOptions& options, Scratch& scratch,
                              GrowingBytes& growing) {
    auto tree = std::make_unique<Subtree>();
    const size_t references = node.size();
    std::optional<Split> split;
    if (references > kTaskSize) split = choose_split(node, pending, options);
    if (!split) {
        tree->fragment.nodes.resize(1);
        if (references > kTaskSize) {
            tree->fragment.nodes[0] = KdNode::leaf(0, uint32_t(references));
            node.append_ids(tree->fragment.references);
        } else {
            grow_serial(node.serial(scratch.local()), pending, options, 0, tree->fragment);
        }
        growing.add(tree->fragment.nodes);
        return tree;
    }
    auto [left_node, right_node] = node.divide(*split, options);
    const PendingPair pair = children(pending, *split, references, left_node.size(), right_node.size());
    tree->axis = split->axis;
    tree->split = split->position;
    tbb::parallel_invoke(
        [&, &left = left_node] { tree->left = grow(std::move(left), pair.left, options, scratch, growing); },
        [&, &right = right_node] { tree->right = grow(std::move(right), pair.right, options, scratch, growing); });
    return tree;
}

}  // namespace tress
