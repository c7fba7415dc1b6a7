// SPDX-License-Identifier: MIT
// A render between two passes, on disk: what it is of, how far it got, and the sums of its film.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/film.h"

namespace tress {

struct Checkpoint {
    std::string made_by;   // lines of "key=value": all that the picture depends on
    uint32_t samples = 0;  // a pixel
    double seconds = 0;    // of rendering
    std::vector<uint64_t> stage_nanoseconds;
};

/// The file takes the place of an older one once it is whole (whole_file.h). Throws InputError where it cannot be
/// written.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const Film& film);

/// Fills `film`, which has the size and the arrays of the render that goes on. Throws InputError where the file is
/// damaged, where it was made by something else than `made_by` (with the line that differs), and where the film's
/// shape is another.
Checkpoint read_checkpoint(const std::string& path, const std::string& made_by, Film& film);

}  // namespace tress
