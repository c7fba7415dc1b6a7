// SPDX-License-Identifier: MIT
// Shares the references of a node out between its children: left what has lo < s, right what has hi >= s, both what
// straddles the plane, cut to either side.
#pragma once

#include <tbb/parallel_for.h>

#include <memory>
#include <span>
#include <vector>

#include "accel/cost_model.h"

namespace tress {

/// References owned by a large node; not initialized.
struct ReferenceArray {
    std::unique_ptr<Reference[]> data;
    size_t size = 0;

    ReferenceArray() = default;
    explicit ReferenceArray(size_t n) : data(std::make_unique_for_overwrite<Reference[]>(n)), size(n) {}
    std::span<Reference> span() { return {data.get(), size}; }
};

/// How a node is cut, with what is needed to cut it.
template <class Primitives>
struct Cut {
    const Primitives& primitives;
    uint32_t axis;
    float s;
    bool clip;

    Cut(const Primitives& p, const Split& split, const AccelOptions& options)
        : primitives(p), axis(split.axis), s(split.position), clip(options.clip) {}

    bool goes_left(const Reference& r) const { return r.lo[int(axis)] < s; }
    bool goes_right(const Reference& r) const { return r.hi[int(axis)] >= s; }

    /// Parts of a reference that goes to both sides; false where clipping leaves nothing.
    bool left_part(Reference& r) const {
        r.hi[int(axis)] = below(s);
        return !clip || primitives.clip_below(r, axis, s);
    }
    bool right_part(Reference& r) const {
        r.lo[int(axis)] = s;
        return !clip || primitives.clip_above(r, axis, s);
    }
};

/// Writes the left children's references from `left` on and the right ones' from `right` on, in order, and moves both
/// pointers past them. `left` may be the start of `references` itself. Both need room for one reference more than
/// they get.
template <class Primitives>
void partition(std::span<const Reference> references, const Cut<Primitives>& cut, Reference*& left, Reference*& right) {
    Reference *l = left, *r = right;
    for (const Reference& reference : references) {
        const bool goes_left = cut.goes_left(reference), goes_right = cut.goes_right(reference);
        *r = reference;
        *l = reference;  // last: it may be the same
        if (goes_left && goes_right) {
            l += cut.left_part(*l);
            r += cut.right_part(*r);
        } else {  // no branch: which side is as good as random
            l += goes_left;
            r += goes_right;
        }
    }
    left = l;
    right = r;
}

/// How many references either side gets.
struct PartCount {
    size_t left = 0, right = 0;
};

/// Counts what partition would write.
template <class Primitives>
PartCount count_parts(std::span<const Reference> references, const Cut<Primitives>& cut) {
    PartCount count;
    for (const Reference& r : references) {
        const bool goes_left = cut.goes_left(r), goes_right = cut.goes_right(r);
        if (goes_left && goes_right) {
            Reference left_part = r, right_part = r;
            count.left += cut.left_part(left_part);
            count.right += cut.right_part(right_part);
        } else {
            count.left += goes_left;
            count.right += goes_right;
        }
    }
    return count;
}

struct ReferencePair {
    ReferenceArray left, right;
};

/// partition for large nodes: chunks in parallel, laid one after the other, so that the order stays.
template <class Primitives>
ReferencePair parallel_partition(std::span<const Reference> references, const Cut<Primitives>& cut) {
    constexpr size_t kChunk = 16384;
    const size_t chunks = (references.size() + kChunk - 1) / kChunk;
    const auto chunk = [&](size_t i) {
        return references.subspan(i * kChunk, std::min(kChunk, references.size() - i * kChunk));
    };
    std::vector<PartCount> first(chunks + 1);  // of each chunk, after the sums below
    tbb::parallel_for(size_t(0), chunks, [&](size_t i) { first[i + 1] = count_parts(chunk(i), cut); });
    for (size_t i = 0; i < chunks; ++i) {
        first[i + 1].left += first[i].left;
        first[i + 1].right += first[i].right;
    }
    ReferencePair pair{ReferenceArray(first[chunks].left), ReferenceArray(first[chunks].right)};
    tbb::parallel_for(size_t(0), chunks, [&](size_t i) {
        // Not `partition`: it writes one past the end, which here is another chunk's.
        Reference *left = pair.left.data.get() + first[i].left, *right = pair.right.data.get() + first[i].right;
        for (const Reference& reference : chunk(i)) {
            const bool goes_left = cut.goes_left(reference), goes_right = cut.goes_right(reference);
            if (goes_left && goes_right) {
                Reference part = reference;
                if (cut.left_part(part)) *left++ = part;
                part = reference;
                if (cut.right_part(part)) *right++ = part;
            } else if (goes_left) {
                *left++ = reference;
            } else {
                *right++ = reference;
            }
        }
    });
    return pair;
}

}  // namespace tress
