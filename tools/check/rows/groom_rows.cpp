// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"
#include "tools/check/rows/bad_segments.h"
#include "tools/check/rows/moved_scenes.h"
#include "tools/check/rows/radius_limits.h"

namespace tress {

std::vector<CheckRow> groom_rows() {
    return {
        {"D1", "segments without length, and strands whose points are all the same",
         "dropped, counted and said once; the picture is that of the scene without them, bit for bit",
         measure_no_length},
        {"D2", "segments of 1e-12 to 1e-45, denormal numbers too",
         "dropped up to 16 ulp or a thousandth of the radius, else met like a ball; all values finite, the count is "
         "printed",
         measure_hardly_any_length},
        {"D4", "NaN or infinity as a point, a radius or a colour",
         "only these segments are dropped; exit code 0; pixels away from them as they were, bit for bit",
         measure_not_finite},
        {"D5", "hair of radius 1e-3 in a scene moved by 1e3 and 1e6, input in double",
         "the same picture to a relMSE of 1e-6; hair thinner than 4 ulp of its input is refused with a message",
         measure_far_from_origin},
        {"D7", "the whole scene and its lights at sizes of 1e-6 and 1e6",
         "the same picture to a relMSE of 1e-6; at a power of two the same bits", measure_sizes},
        {"D8", "radius 0, and negative radii",
         "0 is not met and takes no light; a negative radius is an error where it is said of all hair, and takes its "
         "segments along, counted, where it is said of a point",
         measure_radius_limits},
    };
}

}  // namespace tress
