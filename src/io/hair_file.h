// SPDX-License-Identifier: MIT
// The .hair format of cemyuksel.com/research/hairmodels: a header of 128 bytes, then the arrays it names.
// Its "thickness" is a width across, as other readers of the format take it: radius = thickness / 2.
#pragma once

#include <string>
#include <vector>

#include "io/strand_data.h"

namespace tress {

/// All that a .hair file holds: writing what was read keeps every array.
struct HairFile : StrandData {        // constant_radius: half the default thickness
    std::vector<float> transparency;  // one a point, or empty: the default
    float default_transparency = 0;   // told apart from the strands: nothing here renders it
    Rgb default_color{1};             // of files without colours
    std::string info;                 // at most 88 bytes are written
};

/// Throws InputError where the length of the file is not what its header says, or there are no strands.
/// Also where the thickness of all hair is negative; one that is not finite counts as none.
HairFile read_hair_file(const std::string& path);

/// Whole or not at all. Throws InputError where a strand has more than the 65,535 segments the format can say.
void write_hair_file(const std::string& path, const HairFile& hair);

/// The first four bytes of such a file, in either case.
bool has_hair_magic(const std::string& path);

}  // namespace tress
