// SPDX-License-Identifier: MIT
// One run of a study: a row at one seed, rendered for a while, its picture held against the reference at each power of
// two of samples.
#pragma once

#include <string>

#include "tools/study/methods/reference.h"
#include "tools/study/methods/rendering.h"
#include "tools/study/methods/study_row.h"

namespace tress {

/// Renders in the folder `work` and leaves the picture at the end of the run in `folder`/pictures. The line of the run:
/// "key", "row", "settings", "seed", "picture" (below `folder`), "spp",
/// "seconds" {load, build, render, total}, "peak_rss_bytes", "stages", and "points": [{"spp", "seconds" (of rendering),
/// "errors" (picture_error.h)}, ...].
Json run_row(const StudyScene& scene, const StudyRow& row, const Budget& budget, const Reference& reference,
             const std::string& folder, const std::string& work);

/// By what the log knows it: the scene, the options, the machine, the program and the reference.
std::string run_key(const StudyScene& scene, const StudyRow& row, const Budget& budget, const Reference& reference);

}  // namespace tress
