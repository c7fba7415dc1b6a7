// SPDX-License-Identifier: MIT
// Nodes for the split method `exact`: the faces of all boxes are sorted once, at the root, and stay sorted when a node
// is divided, so a tree takes O(n log n) (Wald & Havran 2006, section 4.3). Only straddling references get new faces;
// those are sorted by themselves and merged in.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>

#include "accel/grow.h"
#include "accel/partition.h"
#include "accel/sweep_split.h"

namespace tress {

/// All lower, or all upper, faces of a node's references across one axis, sorted.
using FaceList = std::vector<Face>;
inline bool is_before(const Face& a, const Face& b) { return a.at < b.at; }

template <class Primitives>
class ExactNode {
public:
    ExactNode(const Primitives& primitives, std::vector<Reference> references)
        : primitives_(&primitives), references_(std::move(references)) {
        const uint32_t n = uint32_t(references_.size());
        for_each_list([&](uint32_t list) {
            for (uint32_t i = 0; i < n; ++i) faces_[list].push_back({face(references_[i], list), i});
            std::sort(faces_[list].begin(), faces_[list].end(), is_before);
        });
    }

    size_t size() const { return references_.size(); }

    std::optional<Split> find(const Bounds& cell, const AccelOptions& options) const {
        std::optional<Split> best;
        for (uint32_t axis = 0; axis < 3; ++axis)
            sweep_axis<Face>(faces_[2 * axis], faces_[2 * axis + 1], AxisCost(options, cell, axis), axis, best);
        return best;
    }

    std::pair<ExactNode, ExactNode> divide(const Split& split, const AccelOptions& options) {
        Side left(*this), right(*this);
        const Cut cut(*primitives_, split, options);
        for (uint32_t i = 0; i < references_.size(); ++i) {
            const Reference& r = references_[i];
            const bool goes_left = cut.goes_left(r), goes_right = cut.goes_right(r);
            Reference part = r;
            if (goes_left && goes_right) {
                if (cut.left_part(part)) left.add_part(part);
                part = r;
                if (cut.right_part(part)) right.add_part(part);
            } else {
                (goes_left ? left : right).add_whole(i, r);
            }
        }
        for_each_list([&](uint32_t list) {
            left.take_faces(faces_[list], list);
            right.take_faces(faces_[list], list);
            faces_[list] = {};
        });
        references_ = {};
        return {std::move(left.node), std::move(right.node)};
    }

    void append_ids(std::vector<uint32_t>& out) const {
        for (const Reference& r : references_) out.push_back(r.id);
    }

    struct NoScratch {};
    ExactNode serial(NoScratch&) { return std::move(*this); }

private:
    static constexpr uint32_t kLists = 6;  // 2 axis: lower faces, 2 axis + 1: upper faces

    explicit ExactNode(const Primitives* primitives) : primitives_(primitives) {}

    static float face(const Reference& r, uint32_t list) {
        return list % 2 == 0 ? r.lo[int(list / 2)] : r.hi[int(list / 2)];
    }

    template <class Work>
    void for_each_list(const Work& work) const {
        if (references_.size() > kTaskSize)
            tbb::parallel_for(uint32_t(0), kLists, work);
        else
            for (uint32_t list = 0; list < kLists; ++list) work(list);
    }

    /// A child in the making.
    struct Side {
        ExactNode node;
        std::vector<uint32_t>
            place;  // of each of the parent's references here; kNone: elsewhere, or only a part is here
        std::vector<uint32_t> parts;  // places of those cut by the plane

        explicit Side(const ExactNode& parent) : node(parent.primitives_), place(parent.size(), kNone) {}

        void add_whole(uint32_t i, const Reference& r) {
            place[i] = uint32_t(node.references_.size());
            node.references_.push_back(r);
        }
        void add_part(const Reference& part) {
            parts.push_back(uint32_t(node.references_.size()));
            node.references_.push_back(part);
        }
        void take_faces(const FaceList& parent, uint32_t list) {
            FaceList whole, cut;
            whole.reserve(node.references_.size() - parts.size());
            for (const Face& f : parent)
                if (place[f.reference] != kNone) whole.push_back({f.at, place[f.reference]});
            for (const uint32_t i : parts) cut.push_back({face(node.references_[i], list), i});
            std::sort(cut.begin(), cut.end(), is_before);
            FaceList& faces = node.faces_[list];
            faces.reserve(whole.size() + cut.size());
            std::merge(whole.begin(), whole.end(), cut.begin(), cut.end(), std::back_inserter(faces), is_before);
        }
    };

    const Primitives* primitives_;
    std::vector<Reference> references_;
    std::array<FaceList, kLists> faces_;
};

}  // namespace tress
