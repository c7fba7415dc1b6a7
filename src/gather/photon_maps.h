// SPDX-License-Identifier: MIT
// What photons leave behind: the irradiance of polygons, and photons to be shown.
#pragma once

#include "gather/irradiance_map.h"
#include "gather/shown_photons.h"

namespace tress {

/// Empty where left out.
struct PhotonMaps {
    IrradianceMap irradiance;  // by all light on polygons
    ShownPhotons shown;
};

}  // namespace tress
