// SPDX-License-Identifier: MIT
// Builds the topology of a kd-tree over any primitives that have
//     kRows              of a block of leaf data, at least
//     size()             how many
//     reference(id)      their box
//     clip_below(part, axis, s), clip_above(part, axis, s)
//                        the box of a part that was just cut at s, shrunk to what lies in it; false: nothing
#pragma once

#include "accel/exact_node.h"
#include "accel/grow.h"
#include "accel/index_limit.h"
#include "accel/reference_node.h"

namespace tress {

template <class Primitives>
ReferenceArray all_references(const Primitives& primitives) {
    constexpr size_t kGrain = 16384;
    ReferenceArray references(primitives.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, references.size, kGrain), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) references.data[i] = primitives.reference(uint32_t(i));
    });
    return references;
}

inline Bounds bounds(std::span<const Reference> references) {
    Bounds box;
    for (const Reference& r : references) box.add({r.lo, r.hi});
    return box;
}

/// Of at least one primitive.
template <class Primitives>
KdTopology build_topology(const Primitives& primitives, const AccelOptions& options, const TreeLimits& limits) {
    check_index_limit("primitives", primitives.size(), KdNode::kMaxIndex);
    ReferenceArray references = all_references(primitives);
    const Bounds box = bounds(references.span());
    const PendingNode root = root_node(box, primitives.size(), options);
    GrowingBytes growing(limits.bytes, Primitives::kRows);
    std::unique_ptr<Subtree> tree;
    if (options.split == SplitMethod::exact) {
        tbb::enumerable_thread_specific<typename ExactNode<Primitives>::NoScratch> scratch;
        const auto span = references.span();
        std::vector<Reference> all(span.begin(), span.end());
        references = {};
        tree = grow(ExactNode(primitives, std::move(all)), root, options, scratch, growing);
    } else {
        tbb::enumerable_thread_specific<ReferenceScratch> scratch;
        tree = grow(LargeNode(primitives, std::move(references)), root, options, scratch, growing);
    }
    return join(*tree, box, limits.index);
}

}  // namespace tress
