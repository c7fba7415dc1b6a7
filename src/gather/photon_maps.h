// SPDX-License-Identifier: MIT
// What photons leave behind: the irradiance of polygons, and photons to be shown.
#pragma once

namespace tress {

/// Empty where left out.
struct PhotonMaps {};

}  // namespace tress
