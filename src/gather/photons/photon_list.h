// SPDX-License-Identifier: MIT
// Photons where they arrived, as arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/path_type.h"

namespace tress {

/// Row i is one arrival. `normal` is empty for photons in hair, `cosine` for those on polygons.
struct PhotonList {
    std::vector<float> x, y, z;   // on the polygon; in hair: on the fiber's axis
    std::vector<Vec3> direction;  // of travel, unit
    std::vector<Vec3> normal;     // geometric, unit, on the side of arrival
    std::vector<float> cosine;    // of the direction to the fiber's normal plane: cos theta_i where it arrives
    std::vector<Rgb> power;       // W
    std::vector<uint8_t> type;    // index_of the PathType of this light for what it arrives at

    size_t size() const { return x.size(); }
    Vec3 position(size_t i) const { return {x[i], y[i], z[i]}; }
};

/// A photon as it arrives.
struct Arrival {
    Vec3 position, direction;
    Rgb power;
    PathType type;
};
/// In hair, or on a polygon: a list has rows of one kind only.
void add(PhotonList& list, const Arrival& photon, float cosine);
void add(PhotonList& list, const Arrival& photon, const Vec3& normal);

void reserve(PhotonList& list, size_t photons, bool on_polygons);
void append(PhotonList& list, const PhotonList& more);
size_t bytes(const PhotonList& list);

/// Bytes of one row in hair and of one on a polygon.
inline constexpr size_t kPhotonBytes = 4 * sizeof(float) + sizeof(Vec3) + sizeof(Rgb) + sizeof(uint8_t);
inline constexpr size_t kPolygonPhotonBytes = kPhotonBytes - sizeof(float) + sizeof(Vec3);

}  // namespace tress
