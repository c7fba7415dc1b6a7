// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"
#include "tools/check/rows/few_photons.h"
#include "tools/check/rows/huge_lights.h"

namespace tress {

std::vector<CheckRow> light_rows() {
    return {
        {"D37", "No photon, one, fewer than an estimate takes, all at one point",
         "No light, finite light, and the energy that was emitted, within three sigma of so few photons; discs have a "
         "least radius.",
         measure_few_photons},
        {"D40", "Lights of intensity 1e30, or at a distance of 1e-20",
         "Finite pictures, whose range the 32-bit floats of an EXR file keep.", measure_huge_lights},
    };
}

}  // namespace tress
