// SPDX-License-Identifier: MIT
// A look at the header of an OpenEXR file before the library sees it: the library believes what a header says and
// allocates for it.
#pragma once

#include <string>

namespace tress {

/// Throws InputError where `path` is not a single-part picture of pixels whose size goes with the file's length.
void check_exr_header(const std::string& path);

}  // namespace tress
