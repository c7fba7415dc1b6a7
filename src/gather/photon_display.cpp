// SPDX-License-Identifier: MIT
#include "gather/photon_display.h"

namespace tress {

void PhotonDisplay::operator()(const Scene&, const PreparedScene&, const Options&, const TypeSet&,
                               std::span<const ShadingPoint>, std::span<LightByType>) {}

}  // namespace tress
