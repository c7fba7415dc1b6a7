// SPDX-License-Identifier: MIT
// tress study accel: trees built by different options, and traced by the rays of a render.
#pragma once

#include <string>
#include <vector>

#include "tools/scene_arguments.h"

namespace tress {

struct AccelStudyArguments {
    SceneArguments scene;
    std::string output;  // folder
    std::vector<std::string> rows, sweeps;
    bool quick = false, quiet = false;
    int rounds = 0;  // 0: the default
};

/// Measures what is not measured yet, and writes study.jsonl, CSV, SVG and index.html into the folder.
void run_accel_study(const AccelStudyArguments& arguments);

}  // namespace tress
