// SPDX-License-Identifier: MIT
// What a render says of itself on stderr when it is done.
#pragma once

#include "core/scene.h"
#include "tools/render_stats.h"

namespace tress {
void print_report(const RenderStats& stats, const Plan& plan, const Scene& scene);
}
