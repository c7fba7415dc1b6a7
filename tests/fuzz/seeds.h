// SPDX-License-Identifier: MIT
// Good inputs that fuzzers start from: small, and of every kind that a reader knows.
#pragma once

#include <string>

#include "core/film.h"

namespace tress::fuzz {

/// Writes FOLDER/TARGET/SEED for every target.
void write_seeds(const std::string& folder);

/// What the checkpoints of the seeds are of.
inline constexpr const char* kCheckpointMadeBy = "scene=0123\nspp=8\n";
Film checkpoint_film();

}  // namespace tress::fuzz
