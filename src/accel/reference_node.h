// SPDX-License-Identifier: MIT
// Nodes that hold references and nothing else: for all split methods but `exact`.
#pragma once

#include <algorithm>

#include "accel/find_split.h"
#include "accel/partition.h"

namespace tress {

/// Work space of one task.
struct ReferenceScratch {
    std::vector<Reference> stack;
    SplitScratch split;
};

/// References on a task's stack, from `begin` on; what lies above is free. Dividing leaves the left child in their
/// place and puts the right one above: the right one must be done with before the left one is divided.
template <class Primitives>
class StackNode {
public:
    StackNode(const Primitives& primitives, ReferenceScratch& scratch, size_t begin, size_t size)
        : primitives_(&primitives), scratch_(&scratch), begin_(begin), size_(size) {}

    size_t size() const { return size_; }

    std::optional<Split> find(const Bounds& cell, const AccelOptions& options) {
        return find_split(span(), cell, options, scratch_->split);
    }

    std::pair<StackNode, StackNode> divide(const Split& split, const AccelOptions& options) {
        const size_t end = begin_ + size_, needed = end + size_ + 1;
        if (scratch_->stack.size() < needed) scratch_->stack.resize(2 * needed);
        Reference* const base = scratch_->stack.data();
        Reference *left = base + begin_, *right = base + end;
        partition(span(), Cut(*primitives_, split, options), left, right);
        return {StackNode(*primitives_, *scratch_, begin_, size_t(left - base) - begin_),
                StackNode(*primitives_, *scratch_, end, size_t(right - base) - end)};
    }

    void append_ids(std::vector<uint32_t>& out) const {
        for (const Reference& r : span()) out.push_back(r.id);
    }

private:
    std::span<const Reference> span() const { return {scratch_->stack.data() + begin_, size_}; }

    const Primitives* primitives_;
    ReferenceScratch* scratch_;
    size_t begin_, size_;
};

/// References in memory of their own, divided by all threads.
template <class Primitives>
class LargeNode {
public:
    LargeNode(const Primitives& primitives, ReferenceArray references)
        : primitives_(&primitives), references_(std::move(references)) {}

    size_t size() const { return references_.size; }

    std::optional<Split> find(const Bounds& cell, const AccelOptions& options) {
        SplitScratch scratch;
        return find_split(references_.span(), cell, options, scratch);
    }

    std::pair<LargeNode, LargeNode> divide(const Split& split, const AccelOptions& options) {
        ReferencePair pair = parallel_partition<Primitives>(references_.span(), Cut(*primitives_, split, options));
        references_ = {};
        return {LargeNode(*primitives_, std::move(pair.left)), LargeNode(*primitives_, std::move(pair.right))};
    }

    void append_ids(std::vector<uint32_t>& out) {
        for (const Reference& r : references_.span()) out.push_back(r.id);
    }

    StackNode<Primitives> serial(ReferenceScratch& scratch) {
        const auto references = references_.span();
        if (scratch.stack.size() < references.size()) scratch.stack.resize(references.size());
        std::copy(references.begin(), references.end(), scratch.stack.begin());
        references_.data.reset();
        return {*primitives_, scratch, 0, references_.size};
    }

private:
    const Primitives* primitives_;
    ReferenceArray references_;
};

}  // namespace tress
