// SPDX-License-Identifier: MIT
// One render of a study, in a process of its own.
#pragma once

#include <string>

#include "tools/study/study_scene.h"

namespace tress {

/// How long, and with which random numbers.
struct Budget {
    uint64_t seed = 0;
    double seconds = 0;  // of rendering; 0: by samples
    int samples = 0;     // a pixel; 0: by time
};

/// Renders into the EXR `picture`, with `snapshots` those at each power of two of samples beside it; its PNG is not
/// kept. Returns what `tress render --stats` writes. Throws InputError with what the render said where it failed.
Json render(const StudyScene& scene, Options options, const Budget& budget, const std::string& picture,
            bool snapshots = false);

}  // namespace tress
