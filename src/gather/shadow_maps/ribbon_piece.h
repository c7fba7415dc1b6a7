// SPDX-License-Identifier: MIT
// A stretch of one ribbon in one tile of a view, along which it stops the same share of the light: what is drawn.
#pragma once

#include "core/attenuation.h"
#include "gather/shadow_maps/ribbon.h"

namespace tress {

/// What is projected, and how.
struct HairInView {
    const LightView& view;
    const SegmentView& segments;
    const Attenuation& attenuation;
    int channels;  // of light: 1 where no fiber colours it, else 3
};

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

/// What a fiber stops of the light through a place of the view, texels; channels that are not asked for are 0.
Rgb stopped_light(const HairInView& hair, const Ribbon& ribbon, uint32_t segment, const glm::dvec2& place);

}  // namespace tress
