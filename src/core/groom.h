// SPDX-License-Identifier: MIT
// Procedural hair on a head (head.h), in cm: clumped, layered, with flyaways; the same for the same seed.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/strands.h"

namespace tress {

/// Names of the grooms: "straight", "wavy", "curly", "short".
std::span<const std::string_view> groom_names();

/// Grows the groom `name` to about `segments` segments (within one strand of it). Radii taper towards the tips.
/// Throws InputError that names the nearest groom where `name` is none, or where `segments` is 0 or over 2^31.
StrandSet make_groom(std::string_view name, uint64_t segments, uint64_t seed);

/// Strands in all `count` a guide: the guide itself and count - 1 more within `spread` of it at the root, drawn
/// together towards the tip as hair clumps, each with a little length and shape of its own.
StrandSet grow_children(const StrandSet& guides, int count, double spread, uint64_t seed);

}  // namespace tress
