// SPDX-License-Identifier: MIT
// What photons leave behind: the irradiance of polygons, and photons to be shown.
#pragma once

#include "gather/photons/irradiance_map.h"
#include "gather/photons/shown_photons.h"

namespace tress {

/// Empty where left out.
struct PhotonMaps {
    IrradianceMap irradiance;  // by all light on polygons
    ShownPhotons shown;
};

}  // namespace tress
