// SPDX-License-Identifier: MIT
// The pieces of ribbons that are to be drawn in one tile of a view.
#pragma once

#include <span>
#include <vector>

#include "gather/shadow_maps/ribbon_piece.h"

namespace tress {

/// Those of the given segments, in that order, in texels `rect` of the view: one tile. A ribbon that is not thin is one
/// piece, without what it stops. Replaces what `pieces` held.
void cut_into_pieces(const HairInView& hair, std::span<const uint32_t> segments, const TexelRect& rect,
                     std::vector<RibbonPiece>& pieces);

}  // namespace tress
