// SPDX-License-Identifier: MIT
// Photons that rounding does not tell apart, made one: a lamp that all but touches a polygon heaps all of its own on a
// point, and a sum over a million of them at each of a million places would have no end.
#pragma once

#include <span>

#include "gather/photons/photon_list.h"

namespace tress {

/// The given rows of `list`, photons on polygons. Those of one cell of a grid as fine as their coordinates' rounding,
/// with like normals, become the first of them with the power of all; directions are not kept.
PhotonList merge_photons(const PhotonList& list, std::span<const uint32_t> rows);

}  // namespace tress
