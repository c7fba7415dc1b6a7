// SPDX-License-Identifier: MIT
// One render of a study, in a process of its own.
#pragma once

#include <string>

#include "tools/study/study_scene.h"

namespace tress {

struct RenderJob {
    uint64_t seed = 0;
    double seconds = 0;  // of rendering; 0: by samples
    int samples = 0;     // a pixel; 0: by time
    bool snapshots = false;
    std::string picture;  // the EXR; its PNG is not kept
};

/// What `tress render --stats` writes. Throws InputError with what the render said where it failed.
Json render(const StudyScene& scene, Options options, const RenderJob& job);

}  // namespace tress
