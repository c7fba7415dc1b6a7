// SPDX-License-Identifier: MIT
// tress study methods, and convergence: rows of methods rendered and held against the truth.
#pragma once

#include <string>
#include <vector>

#include "tools/scene_arguments.h"

namespace tress {

/// Which page is made: tables first, or plots first.
enum class MethodStudyKind { methods, convergence };

struct MethodStudyArguments {
    SceneArguments scene;
    std::string output, references;  // folders; references empty: in `output`
    std::vector<std::string> rows, sweeps;
    bool all = false, quick = false, quiet = false;
    int seeds = 0;                 // runs a row; 0: the default
    double reference_seconds = 0;  // 0: the default
};

/// Measures what is not measured yet, and writes study.jsonl, CSV, SVG and index.html into the folder.
void run_method_study(MethodStudyArguments arguments, MethodStudyKind kind);

}  // namespace tress
