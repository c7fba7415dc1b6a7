// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"
#include "tools/check/rows/index_limits.h"
#include "tools/check/rows/tree_rays.h"
#include "tools/check/rows/tree_sizes.h"

namespace tress {

std::vector<CheckRow> hair_tree_rows() {
    return {
        {"D3", "a million segments at one place",
         "one leaf, no deeper than allowed, no more references than segments, built within 2 s; hits are those of one "
         "segment",
         measure_identical_segments},
        {"D6", "thin hair seen from far: distances of 3e4 and 3e5 radii",
         "at most 0.02 % of hits wrong, and t right to 0.01 radii in 99 of 100, at 3e4; at most 0.5 % at 3e5",
         measure_thin_hair_from_far},
        {"D9", "segments whose radii differ by more than their length",
         "one end holds the other; answers are those of brute force in double", measure_steep_cones},
        {"D10", "rays along the axis, through the tip, and from inside the hair",
         "no hit is lost against double over 1e6 rays; a segment that is skipped is not met",
         measure_rays_along_the_axis},
        {"D22", "hair along the axes, exactly on split planes", "each is found: brute force in double over 1e6 rays",
         measure_hair_on_split_planes},
        {"D23", "all hair in one plane, all in one line",
         "boxes have a thickness, costs are finite; answers are those of brute force in double", measure_flat_hair},
        {"D24", "one segment across a million tiny ones", "at most 4 references a segment; a cap where splits are free",
         measure_one_long_segment},
        {"D25", "sizes in a geometric series", "no deeper than allowed, and rays still find their way",
         measure_series_of_sizes},
        {"D36", "more segments than indices can name", "said, not wrapped; places of leaf data count in 64 bits",
         measure_index_limits},
        {"D39", "a single segment, and a single strand",
         "the tree is one leaf; the shadow is as wide as by its formula", measure_single_hair},
    };
}

}  // namespace tress
