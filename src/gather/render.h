// SPDX-License-Identifier: MIT
// The pixel loop. The picture is the same bit for bit whatever the number of threads, and however the samples are
// divided into passes.
//
//     const Plan plan = make_plan(scene, options);
//     const PreparedScene prepared = prepare(scene, plan, options);
//     RenderState state = make_state(scene, plan);
//     advance(state, scene, prepared, plan, options, 64);
//     LayeredImage picture = develop(state.film);
#pragma once

#include <memory>

#include "core/film.h"
#include "gather/prepared_scene.h"
#include "gather/stage_clock.h"

namespace tress {

struct RenderState {
    Film film;
    int samples = 0;     // a pixel, so far
    double seconds = 0;  // of wall time in advance()
    std::unique_ptr<StageClocks> clocks;
};

RenderState make_state(const Scene& scene, const Plan& plan);

/// Adds `samples` samples to every pixel.
void advance(RenderState& state, const Scene& scene, const PreparedScene& prepared, const Plan& plan,
             const Options& options, int samples);

/// Cost of each stage of the loop that the plan lists.
std::vector<StageCost> loop_costs(const RenderState& state, const PreparedScene& prepared, const Plan& plan);

}  // namespace tress
