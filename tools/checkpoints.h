// SPDX-License-Identifier: MIT
// A render kept on the way, beside its picture, so that one that dies goes on from there.
#pragma once

#include <chrono>
#include <string>

#include "core/scene.h"
#include "gather/render.h"

namespace tress {

class Checkpoints {
public:
    /// Of the picture NAME.exr: NAME.checkpoint. `seconds`: between two; 0: none are written.
    Checkpoints(const std::string& picture, double seconds, const Scene& scene, const Options& options);

    /// Takes up a checkpoint, if there is one. Throws InputError where it is damaged or of another render; how many
    /// threads there are, of which instruction set, and how long they may work does not matter.
    bool resume(RenderState& state);

    /// Writes one where it is time. Where that fails, it is said, once, and the last one stays.
    void after_pass(const RenderState& state);

    /// Writes one now, if any are written.
    void write(const RenderState& state);

    /// The picture is there: what was written or taken up is of no more use.
    void remove() const;

private:
    std::string path_, made_by_;
    double seconds_;
    std::chrono::steady_clock::time_point last_;
    bool used_, failed_ = false;
};

}  // namespace tress
