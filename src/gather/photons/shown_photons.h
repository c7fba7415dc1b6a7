// SPDX-License-Identifier: MIT
// Photons of Types 4 and 5 to be shown directly: those in hair, and those on polygons.
#pragma once

#include "core/segments.h"
#include "gather/photons/hair_photons.h"
#include "gather/photons/polygon_photons.h"

namespace tress {

struct ShownPhotons {
    HairPhotons hair;
    PolygonPhotons polygons;
};

/// Of both lists, those of the types in `shown`. The same for any number of threads.
ShownPhotons make_shown_photons(const PhotonList& in_hair, const PhotonList& on_polygons, const TypeSet& shown,
                                const SegmentView& segments, const PhotonOptions& options);

size_t bytes(const ShownPhotons& photons);

}  // namespace tress
