// SPDX-License-Identifier: MIT
#include "gather/photons/photon_tracing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "core/error.h"
#include "gather/photons/photon_block.h"

namespace tress {
namespace {

constexpr uint32_t kBlock = 4096;  // photons

/// Counts the bytes of all blocks together.
class PhotonMemory {
public:
    PhotonMemory(int photons, size_t most_bytes) : photons_(photons), most_(most_bytes) {}

    void operator()(size_t bytes) {
        if ((stored_ += bytes) <= most_) return;
        constexpr int kMegabyteBits = 20;
        throw InputError("photons.count", std::to_string(photons_) + " photons leave more than " +
                                              std::to_string(most_ >> kMegabyteBits) +
                                              " MiB where they arrive, expected fewer");
    }

private:
    std::atomic<size_t> stored_{0};
    int photons_;
    size_t most_;
};

PhotonStatistics no_photons(const PhotonSource& source) {
    PhotonStatistics none;
    for (const PhotonSource::Share& share : source.shares) none.lights.push_back({share.light});
    return none;
}

void add(PhotonStatistics& sum, const PhotonStatistics& more) {
    for (size_t i = 0; i < sum.lights.size(); ++i) {
        sum.lights[i].emitted += more.lights[i].emitted;
        sum.lights[i].met_hair += more.lights[i].met_hair;
        sum.lights[i].on_polygons += more.lights[i].on_polygons;
        sum.lights[i].power += more.lights[i].power;
    }
    for (size_t source = 0; source < sum.hair.size(); ++source) {
        for (size_t k = 0; k < sum.hair[source].size(); ++k) {
            sum.hair[source][k].crossings += more.hair[source][k].crossings;
            sum.hair[source][k].power += more.hair[source][k].power;
        }
    }
}

/// In the order of the blocks; they are emptied on the way.
TracedPhotons join(std::vector<TracedPhotons>& blocks, const PhotonSource& source) {
    TracedPhotons all;
    all.statistics = no_photons(source);
    size_t on_polygons = 0, in_hair = 0;
    for (const TracedPhotons& block : blocks) {
        on_polygons += block.on_polygons.size();
        in_hair += block.in_hair.size();
    }
    reserve(all.on_polygons, on_polygons, true);
    reserve(all.in_hair, in_hair, false);
    for (TracedPhotons& block : blocks) {
        append(all.on_polygons, block.on_polygons);
        append(all.in_hair, block.in_hair);
        add(all.statistics, block.statistics);
        block = {};
    }
    return all;
}

}  // namespace

TracedPhotons trace_photons(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                            size_t most_bytes) {
    const uint32_t count = uint32_t(options.photons.count);
    const PhotonSource source = make_photon_source(scene, prepared, plan, options.photons.count);
    std::vector<TracedPhotons> blocks(source.dark ? 0 : (size_t(count) + kBlock - 1) / kBlock);
    const PhotonContext context{scene, prepared, plan, options, source};
    PhotonMemory memory(options.photons.count, most_bytes);
    tbb::enumerable_thread_specific<PhotonBlock> tracers([&] { return PhotonBlock(context); });
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, blocks.size(), 1),
        [&](const tbb::blocked_range<size_t>& range) {
            for (size_t b = range.begin(); b < range.end(); ++b) {
                blocks[b].statistics = no_photons(source);
                const uint32_t first = uint32_t(b) * kBlock;
                tracers.local()({first, std::min(count, first + kBlock)}, blocks[b],
                                [&](size_t bytes) { memory(bytes); });
            }
        },
        tbb::simple_partitioner());
    return join(blocks, source);
}

}  // namespace tress
