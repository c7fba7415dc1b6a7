// SPDX-License-Identifier: MIT
// A stretch of one ribbon in one tile of a view, along which it stops the same share of the light: what is drawn.
#pragma once

#include "core/attenuation.h"
#include "gather/shadow_maps/ribbon.h"

namespace tress {

/// Texels along a thin ribbon that share one look-up of what it stops: of 90 degrees in 512 texels, the light's
/// direction changes by 1.5 degrees.
inline constexpr int kPieceTexels = 8;

/// Texels are counted from the tile's corner. Thin: the part of the axis from `low` to `high` on the major axis.
struct RibbonPiece {
    uint32_t segment;
    uint16_t shape;              // as Ribbon::Shape
    uint16_t major;              // of a thin ribbon
    float depth;                 // at its start; of others: of the middle
    float low, high;             // thin alone, from here on
    float center, slope;         // of the axis on the minor axis: at `low`, and its change a texel
    float half_width, widening;  // likewise
    float deepening, bend;       // depth at `high` - at `low`, and z there / z here
    Rgb stopped;                 // 1 - a; one channel where no fiber colours light
};

inline float middle_depth(const RibbonPiece& piece) { return piece.depth + 0.5f * piece.deepening; }

/// The part of a thin ribbon between two places of its major axis (view's texels, within its ends), in the tile whose
/// first texel is `corner`.
RibbonPiece cut_thin(const LightView& view, const Ribbon& ribbon, double from, double to, const glm::ivec2& corner);

/// A ribbon that is not thin; what it stops is not set.
RibbonPiece whole_piece(const LightView& view, const Ribbon& ribbon, uint32_t segment);

/// What `channels` of the light (1 or 3) a fiber stops, of light through a place of the view.
Rgb stopped_light(const LightView& view, const Ribbon& ribbon, uint32_t segment, const Attenuation& attenuation,
                  int channels, const glm::dvec2& place);

}  // namespace tress
