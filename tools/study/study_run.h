// SPDX-License-Identifier: MIT
// One run of a study: a row at one seed, rendered for a while, its picture held against the reference at each power of
// two of samples.
#pragma once

#include <string>

#include "tools/study/reference.h"
#include "tools/study/study_row.h"

namespace tress {

struct RunJob {
    uint64_t seed = 0;
    double seconds = 0;  // of rendering; 0: by samples
    int samples = 0;     // a pixel; 0: by time
};

/// The line of the run: "key", "row", "settings", "seed", "picture" (in `folder`, at the end of the run), "spp",
/// "seconds" {load, build, render, total}, "peak_rss_bytes", "stages", and "points": [{"spp", "seconds" (of rendering),
/// "errors" (picture_error.h)}, ...].
Json run_row(const StudyScene& scene, const StudyRow& row, const RunJob& job, const Reference& reference,
             const std::string& folder);

/// By what the log knows it: the scene, the options, the machine, the program and the reference.
std::string run_key(const StudyScene& scene, const StudyRow& row, const RunJob& job, const Reference& reference);

}  // namespace tress
