// SPDX-License-Identifier: MIT
#include "gather/tree_measure.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "accel/build.h"
#include "accel/ray_work.h"
#include "core/golden_order.h"

namespace tress {
namespace {

constexpr size_t kLargestBatch = 1024, kSmallestBatch = 16;  // rays next to each other in the order of the renderer
constexpr size_t kCounted = 4096;                            // rays of a set whose work is counted
constexpr double kWarmUpShare = 0.1;                         // of the seconds of tracing
constexpr double kCountShare = 0.25;                         // likewise, at most

using Clock = std::chrono::steady_clock;
using Moment = Clock::time_point;

double seconds_since(Moment start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
Moment in(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Asks parts of a set of rays; one a thread.
class Questioner {
public:
    Questioner(const KdTree& tree, const RayBuffer& rays, HairQuery query, Isa isa)
        : tree_(tree), rays_(rays.for_hair()), query_(query), isa_(isa) {}

    void ask(size_t first, size_t count) {
        const RayBatch rays = take(first, count);
        if (query_ == HairQuery::nearest)
            nearest_segment(tree_, rays, hits(), isa_);
        else
            transmittance_constant(tree_, rays, kMeasuredTransmission, kMeasuredCutoff, t_, id_, isa_);
    }
    /// Its sum over these rays.
    RayWork count(size_t first, size_t count) {
        const RayBatch rays = take(first, count);
        work_.resize(count);
        if (query_ == HairQuery::nearest)
            count_nearest_work(tree_, rays, hits(), work_, isa_);
        else
            count_transmittance_work(tree_, rays, kMeasuredTransmission, kMeasuredCutoff, id_, work_, isa_);
        RayWork sum;
        for (const RayWork& w : work_) sum += w;
        return sum;
    }

private:
    RayBatch take(size_t first, size_t count) {
        for (auto* floats : {&t_, &u_, &h_}) floats->resize(count);
        id_.resize(count);
        return rays_.part(first, count);
    }
    NearestHits hits() { return {t_, id_, u_, h_}; }

    const KdTree& tree_;
    RayBatch rays_;
    HairQuery query_;
    Isa isa_;
    std::vector<float> t_, u_, h_;
    std::vector<uint32_t> id_;  // crossings, where these are asked for
    std::vector<RayWork> work_;
};

/// Rays asked at once: few where they are slow, so that the clock is looked at often enough.
class PieceSize {
public:
    size_t operator()() const { return rays_; }
    void learn(Clock::duration took) {
        constexpr std::chrono::microseconds kShort(500), kLong(5000);
        if (took < kShort) rays_ = std::min(2 * rays_, kLargestBatch);
        if (took > kLong) rays_ = std::max<size_t>(rays_ / 2, 1);
    }

private:
    size_t rays_ = 8;
};

/// Has every thread run `work(next)`, where next() hands out 0, 1, … n - 1 once each.
template <class Work>
void share_out(size_t n, const Work& work) {
    std::atomic<size_t> handed_out{0};
    const auto next = [&]() -> std::optional<size_t> {
        const size_t k = handed_out++;
        return k < n ? std::optional(k) : std::nullopt;
    };
    tbb::parallel_for(
        0, tbb::this_task_arena::max_concurrency(), [&](int) { work(next); }, tbb::simple_partitioner());
}

/// One set of rays on one tree.
struct Race {
    const KdTree& tree;
    const RayBuffer& rays;
    HairQuery query;
    Isa isa;
};

struct Pass {
    uint64_t traced;
    double seconds;
};

/// All batches once, or as far as one gets by `end`. `batch`: rays.
Pass trace(const Race& race, size_t batch, Moment end) {
    const size_t n = race.rays.size();
    const std::vector<uint32_t> order = golden_order(uint32_t((n + batch - 1) / batch));
    std::atomic<uint64_t> traced{0};
    const Moment start = Clock::now();
    share_out(order.size(), [&](const auto& next) {
        Questioner questioner(race.tree, race.rays, race.query, race.isa);
        PieceSize piece;
        uint64_t own = 0;
        Moment now = Clock::now();
        for (std::optional<size_t> k; now < end && (k = next());) {
            const size_t first = size_t(order[*k]) * batch, last = std::min(first + batch, n);
            for (size_t at = first; at < last && now < end;) {
                const size_t count = std::min(piece(), last - at);
                questioner.ask(at, count);
                const Moment before = std::exchange(now, Clock::now());
                piece.learn(now - before);
                at += count;
                own += count;
            }
        }
        traced += own;
    });
    return {traced, seconds_since(start)};
}

/// Whole passes for about `seconds`, to the nearest number; at least one, or what it gets to.
std::vector<Pass> trace_passes(const Race& race, size_t batch, double seconds) {
    const Moment start = Clock::now(), end = in(seconds);
    std::vector<Pass> passes{trace(race, batch, end)};
    if (passes[0].traced < race.rays.size()) return passes;
    while (seconds_since(start) + 0.5 * passes[0].seconds < seconds) passes.push_back(trace(race, batch, in(seconds)));
    return passes;
}

/// Rays of a batch: few where they are slow, so that the batches that there is time for sample the whole picture.
size_t batch_for(const Pass& warm_up, double seconds) {
    constexpr double kBatches = 128;
    const double rays = double(warm_up.traced) / std::max(warm_up.seconds, 1e-9) * seconds;
    return size_t(std::clamp(rays / kBatches, double(kSmallestBatch), double(kLargestBatch)));
}

double median_rate(const std::vector<Pass>& passes) {
    std::vector<double> rates;
    for (const Pass& p : passes) rates.push_back(double(p.traced) / std::max(p.seconds, 1e-9));
    const auto middle = rates.begin() + std::ptrdiff_t(rates.size() / 2);
    std::nth_element(rates.begin(), middle, rates.end());
    return *middle;
}

/// Of rays spread evenly over the set.
void count(const Race& race, double seconds, RayRate& to) {
    constexpr size_t kPiece = 4;
    const std::vector<uint32_t> order = golden_order(uint32_t(race.rays.size()));
    RayBuffer some;
    for (size_t k = 0; k < std::min(kCounted, race.rays.size()); ++k) some.add_from(race.rays, order[k]);
    const Moment end = in(seconds);
    std::mutex mutex;
    RayWork sum;
    share_out((some.size() + kPiece - 1) / kPiece, [&](const auto& next) {
        Questioner questioner(race.tree, some, race.query, race.isa);
        RayWork own;
        uint64_t counted = 0;
        for (std::optional<size_t> k; Clock::now() < end && (k = next());) {
            const size_t first = *k * kPiece, n = std::min(kPiece, some.size() - first);
            own += questioner.count(first, n);
            counted += n;
        }
        const std::lock_guard lock(mutex);
        sum += own;
        to.counted += counted;
    });
    const double n = double(std::max<uint64_t>(to.counted, 1));
    to.steps = double(sum.steps) / n;
    to.leaves = double(sum.leaves) / n;
    to.tests = double(sum.tests) / n;
}

}  // namespace

RayRate measure_rays(const KdTree& tree, const TreeRays& rays, Isa isa, double seconds) {
    RayRate rate;
    rate.rays = rays.name;
    rate.query = rays.query == HairQuery::nearest ? "nearest" : "transmittance";
    const Race race{tree, rays.rays, rays.query, isa};
    const Pass warm_up = trace(race, kSmallestBatch, in(kWarmUpShare * seconds));
    const std::vector<Pass> passes = trace_passes(race, batch_for(warm_up, seconds), seconds);
    for (const Pass& p : passes) rate.traced += p.traced, rate.seconds += p.seconds;
    rate.mrays_per_second = 1e-6 * median_rate(passes);
    count(race, kCountShare * seconds, rate);
    return rate;
}

TreeMeasure measure_tree(const SegmentView& segments, const AccelOptions& accel, std::span<const TreeRays> rays,
                         const Options& options, double seconds, const TreeLimits& limits) {
    TreeMeasure measure;
    const Moment start = Clock::now();
    const KdTree tree = build_segment_tree(segments, accel, limits);
    measure.build_seconds = seconds_since(start);
    measure.statistics = statistics(tree, segments.size(), accel);
    for (const TreeRays& set : rays)
        if (set.rays.size() > 0) measure.rates.push_back(measure_rays(tree, set, options.isa, seconds));
    return measure;
}

}  // namespace tress
