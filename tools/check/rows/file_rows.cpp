// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"
#include "tools/check/rows/corrupt_hair.h"
#include "tools/check/rows/hostile_system.h"

namespace tress {

std::vector<CheckRow> file_rows() {
    return {
        {"D43", "Corrupt .hair files: counts past 2^32, short files, 65,535 segments, no strands, unknown flags",
         "An error that names the byte, before anything large is allocated. (tools/fuzz runs the reader under "
         "libFuzzer "
         "and sanitizers.)",
         measure_corrupt_hair},
        {"D44", "Decimal commas, places that cannot be written, a full disk, an interrupt",
         "The same numbers; an error; never half a file in a file's place. (tests/checkpoint_command_test.cpp kills "
         "and interrupts whole renders.)",
         measure_hostile_system},
    };
}

}  // namespace tress
