// SPDX-License-Identifier: MIT
// The figures of a render, as --stats writes them.
#pragma once

#include <nlohmann/json.hpp>

#include "core/options.h"
#include "core/photon_statistics.h"
#include "core/plan.h"
#include "core/stage_cost.h"
#include "core/type_shares.h"
#include "gather/projection/hair_projection.h"

namespace tress {

/// Of projection: what was made of gaps between cells, and the error that rays showed
/// (gather/projection/calibrate_gap.h).
struct ProjectionReport {
    CellGap at_hair, at_polygons;
};

/// A picture that was kept on the way.
struct Snapshot {
    int spp = 0;
    double seconds = 0;  // of rendering until then
    std::string file;
};

struct RenderStats {
    double load_seconds = 0, build_seconds = 0, render_seconds = 0, total_seconds = 0;
    std::vector<StageCost> stages;
    std::vector<PlanItem> left_out;
    std::optional<LampCost> lamp_cost;      // as estimated
    std::optional<GatherCost> gather_cost;  // likewise
    std::vector<TypeShare> types, types_on_hair;
    PhotonStatistics photons;
    std::optional<ProjectionReport> projection;
    std::vector<Snapshot> snapshots;
    int spp = 0, threads = 0;
    std::string isa;  // the one used
    uint64_t segments = 0, dropped_segments = 0;
};

/// Largest resident memory of this process so far.
uint64_t peak_rss_bytes();

/// Every option with its value, as text.
nlohmann::ordered_json option_texts(Options options);

nlohmann::ordered_json to_json(const RenderStats& stats, const Options& options);

}  // namespace tress
