// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"
#include "tools/check/rows/bare_scenes.h"
#include "tools/check/rows/same_bits.h"
#include "tools/check/rows/strand_order.h"
#include "tools/check/rows/white_furnace.h"
#include "tools/check/rows/whole_turn.h"

namespace tress {

std::vector<CheckRow> picture_rows() {
    return {
        {"D38", "Scenes that lack lights, polygons, hair, hits, pixels or samples",
         "A picture all the same, or a refusal in words; no stage is built that the scene has no use for.",
         measure_bare_scenes},
        {"D41", "Any number of threads, any division into passes",
         "The same picture bit for bit. Tiles have one size here, and memory nodes are left to the system.",
         measure_threads_and_passes},
        {"D42", "Scalar, SSE4, AVX2, AVX-512: as many as run here", "The same picture bit for bit.",
         measure_instruction_sets},
        {"D45", "White furnace: a ball of white hair under a white sky",
         "Light of all types together is 1; what types 1 to 3 leave out is what they do not trace.",
         measure_white_furnace},
        {"D46", "Strands in another order, strands from tip to root",
         "The same picture: of fibers without tilt where strands are turned round.", measure_order_of_strands},
        {"D47", "The scene turned as a whole", "The same light in the mean, whichever way the cells stand.",
         measure_turned_scene},
    };
}

}  // namespace tress
