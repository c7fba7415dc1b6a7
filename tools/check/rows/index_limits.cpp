// SPDX-License-Identifier: MIT
#include "tools/check/rows/index_limits.h"

#include "accel/build.h"
#include "accel/statistics.h"
#include "core/groom.h"
#include "tools/check/support/kd_sets.h"
#include "tools/check/support/refusal.h"

namespace tress {
namespace {

using namespace scenes;

constexpr uint32_t kSixteenBits = 0xffff;

/// Options of which trees have many nodes, and little in each leaf.
AccelOptions many_nodes() {
    AccelOptions options;
    options.traversal_cost = 2;
    options.exact_below = 0;
    return options;
}

/// What is said of a tree whose indices have so many values; empty where it is built.
std::string refusal_of(const SegmentView& view, const TreeLimits& limits) {
    return test::message_of([&] { build_segment_tree(view, many_nodes(), limits); });
}

void add_limits_of_nodes(const SegmentView& hair, std::vector<Figure>& to) {
    const auto nodes = uint32_t(build_segment_tree(hair, many_nodes()).nodes.size());
    const std::string of_nodes = std::to_string(nodes) + " nodes";
    to.push_back(at_least("nodes of a fine tree, more than 16 bits name", nodes, kSixteenBits + 1.0));
    to.push_back(holds("indices of 16 bits: refused with a message",
                       test::contains(refusal_of(hair, {kSixteenBits}), of_nodes)));
    to.push_back(holds("indices that just name all nodes: built", refusal_of(hair, {nodes}).empty()));
    to.push_back(holds("one fewer: refused", test::contains(refusal_of(hair, {nodes - 1}), of_nodes)));
}

void add_limits_of_blocks(std::vector<Figure>& to) {
    constexpr size_t kMost = size_t(kSixteenBits) * kLanes;
    const std::string full = refusal_of(coincident_segments(kMost).view(), {kSixteenBits});
    const std::string over = refusal_of(coincident_segments(kMost + 1).view(), {kSixteenBits});
    to.push_back(holds("indices of 16 bits, 65,535 blocks of leaf data: built", full.empty()));
    to.push_back(holds("one segment more: refused with a message", test::contains(over, "65536 blocks")));
}

/// Bytes from the first block that a leaf can name to the last; nothing is read there.
double bytes_to_last_block() {
    LeafBlocks blocks{segment_row::kVaryingRadius, AlignedArray<float>(1)};
    const auto address = [&](uint32_t index) { return reinterpret_cast<uintptr_t>(blocks.block(index)); };
    return double(address(KdNode::kMaxIndex) - address(0));
}

}  // namespace

Outcome measure_index_limits(const CheckSettings&) {
    const StrandSet groom = make_groom("wavy", 200000, 64);
    const SegmentList list = list_segments(groom);
    const SegmentView hair = view(groom, list);
    const AccelOptions options;
    const KdTree tree = build_segment_tree(hair, options);
    const TreeStatistics s = statistics(tree, hair.size(), options);
    const double last_block = double(KdNode::kMaxIndex) * segment_row::kVaryingRadius * kLanes * sizeof(float);
    const double segments = double(hair.size()), points = double(bytes(groom));
    const double indices = double(list.point.capacity() * sizeof(uint32_t));
    Outcome outcome;
    add_limits_of_nodes(hair, outcome.figures);
    add_limits_of_blocks(outcome.figures);
    outcome.figures.insert(
        outcome.figures.end(),
        {exactly("bytes by which the place of the last block of 2^30 is off", bytes_to_last_block() - last_block, 0),
         told("bytes a segment of the tree of " + std::to_string(hair.size()) + " segments of hair at the defaults",
              double(s.bytes) / segments),
         told("bytes a segment of its points and radii", points / segments),
         told("bytes a segment of its indices", indices / segments),
         at_most("bytes a segment in all", (double(s.bytes) + points + indices) / segments, 200)});
    return outcome;
}

}  // namespace tress
