// SPDX-License-Identifier: MIT
#include "gather/photons/shown_photons.h"

namespace tress {
namespace {

std::vector<uint32_t> rows_of(const PhotonList& list, const TypeSet& types) {
    std::vector<uint32_t> rows;
    for (uint32_t i = 0; i < list.size(); ++i)
        if (types[list.type[i]]) rows.push_back(i);
    return rows;
}

}  // namespace

ShownPhotons make_shown_photons(const PhotonList& in_hair, const PhotonList& on_polygons, const TypeSet& shown,
                                const SegmentView& segments, const PhotonOptions& options) {
    return {make_hair_photons(in_hair, rows_of(in_hair, shown), segments, options),
            make_polygon_photons(on_polygons, rows_of(on_polygons, shown), options, 0)};
}

size_t bytes(const ShownPhotons& photons) { return bytes(photons.hair) + bytes(photons.polygons); }

}  // namespace tress
