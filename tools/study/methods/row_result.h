// SPDX-License-Identifier: MIT
// What follows from the runs of a study: for each row its times, memory, bias and noise, and what it gives at equal
// time and at equal error.
#pragma once

#include <vector>

#include "tools/study/methods/study_row.h"
#include "tools/study/study_log.h"

namespace tress {

/// A row with its runs, one a seed.
struct MeasuredRow {
    StudyRow row;
    std::vector<Json> runs;
};

/// One line a row, in order: "line": "row", "row", "settings", "runs", "spp" (a power of two that every run of every
/// row has reached), "build_seconds", "render_seconds" (to that), "total_seconds", "times_as_fast" (as the first row),
/// "paper_seconds", "paper_times_as_fast" (as the paper's first row), "peak_rss_bytes", medians over runs; "errors" at
/// that spp (means over runs); "layers": {"whole": {"bias", "bias_error", "noise", "noise_error", "floor", "residual",
/// "signed_mean", "signed_mean_error", "last_relmse"}, ...}; "equal_time": [{"seconds", "relmse", "beyond"}],
/// "equal_error":
/// [{"relmse", "seconds", "beyond"}] of the whole; null where a row never gets there.
///
/// floor and noise are b and c of relMSE = b + c / t over t seconds of rendering (error_fit.h); bias is the root of
/// the floor without the reference's own error; signed_mean is the picture's mean over the reference's, less 1.
/// "beyond": outside of the times that were measured.
std::vector<Json> row_results(const std::vector<MeasuredRow>& rows, const Json& reference);

}  // namespace tress
