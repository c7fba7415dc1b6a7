// SPDX-License-Identifier: MIT
#include "gather/render.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "gather/tile.h"

namespace tress {
RenderState make_state(const Scene& scene, const Plan& plan) {
    return {make_film(scene.camera.width, scene.camera.height, plan), 0, 0, std::make_unique<StageClocks>()};
}

void advance(RenderState& state, const Scene& scene, const PreparedScene& prepared, const Plan& plan,
             const Options& options, int samples) {
    const auto start = std::chrono::steady_clock::now();
    const TileContext context{scene, prepared, plan, options, camera_frame(scene.camera)};
    tbb::enumerable_thread_specific<TileScratch> scratch;
    tbb::parallel_for(
        tbb::blocked_range<int>(0, tile_count(scene.camera), 1),
        [&](const tbb::blocked_range<int>& range) {
            for (int t = range.begin(); t < range.end(); ++t) {
                const Tile tile = tile_of(scene.camera, t);
                for (int s = state.samples; s < state.samples + samples; ++s)
                    render_tile(context, tile, uint32_t(s), scratch.local(), *state.clocks, state.film);
            }
        },
        tbb::simple_partitioner());
    state.samples += samples;
    state.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<StageCost> loop_costs(const RenderState& state, const PreparedScene& prepared, const Plan& plan) {
    std::vector<StageCost> costs;
    std::vector<LoopStage> stages;
    const auto list = [&](bool planned, const char* name, LoopStage stage, size_t bytes = 0) {
        if (!planned) return;
        costs.push_back({name, 0, bytes});
        stages.push_back(stage);
    };
    list(true, stage::kCameraRays, LoopStage::camera_rays, bytes(state.film));
    list(plan.direct, stage::kType1, LoopStage::type1);
    list(plan.projection.has_value(), stage::kProjection, LoopStage::projection,
         prepared.probes ? prepared.probes->bytes() : 0);
    list(plan.sky && !plan.projection, stage::kSky, LoopStage::sky);
    list(plan.gather_rays(), stage::kGatherRays, LoopStage::gather_rays);
    list(plan.polygon_gather && !plan.projection, stage::kPolygonGather, LoopStage::polygon_gather);
    list(plan.crossing_gather, stage::kCrossingGather, LoopStage::crossing_gather);
    list(any(plan.photon_display), stage::kPhotonDisplay, LoopStage::photon_display);
    list(any(plan.paths), stage::kPaths, LoopStage::paths);

    double all = 0;
    for (const auto& nanoseconds : state.clocks->nanoseconds) all += double(nanoseconds);
    for (size_t i = 0; i < costs.size() && all > 0; ++i)
        costs[i].seconds = state.seconds * double(state.clocks->nanoseconds[size_t(stages[i])]) / all;
    return costs;
}

}  // namespace tress
