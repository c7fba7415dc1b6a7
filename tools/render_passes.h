// SPDX-License-Identifier: MIT
// The passes of a render, until its samples or its time are used up, or it is told to stop.
#pragma once

#include <functional>
#include <string>

#include "gather/render.h"

namespace tress {

struct PassLimits {
    double seconds_a_pass = 0;  // that a pass should not take longer than, where a sample a pixel does not; 0: none
    bool quiet = false;
};

/// Passes of `state`, with `after_pass` after each. A signal to stop (interrupt.h) ends it after the pass that runs.
/// Returns that signal, or 0.
int render_passes(RenderState& state, const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                  const Options& options, const PassLimits& limits, const std::function<void()>& after_pass);

}  // namespace tress
