// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/ribbon_piece.h"

namespace tress {

RibbonPiece cut_thin(const LightView& view, const Ribbon& r, double from, double to, const glm::ivec2& corner) {
    const int major = r.major, minor = 1 - major;
    const double scale = 1 / (r.at[1][major] - r.at[0][major]);
    const double u = (from - r.at[0][major]) * scale, v = (to - r.at[0][major]) * scale;
    const double z_from = z_at(view, r, u), z_to = z_at(view, r, v);
    const double rise = r.at[1][minor] - r.at[0][minor], widening = r.half_width[1] - r.half_width[0];
    RibbonPiece p;
    p.shape = uint16_t(Ribbon::Shape::thin);
    p.major = uint16_t(major);
    p.low = float(from - corner[major]), p.high = float(to - corner[major]);
    p.center = float(r.at[0][minor] + u * rise - corner[minor]), p.slope = float(rise * scale);
    p.half_width = float(r.half_width[0] + u * widening), p.widening = float(widening * scale);
    p.depth = float(z_from - view.start), p.deepening = float(z_to - z_from);
    p.bend = view.parallel ? 1 : float(z_to / z_from);
    return p;
}

RibbonPiece whole_piece(const LightView& view, const Ribbon& ribbon, uint32_t segment) {
    RibbonPiece p{};
    p.segment = segment;
    p.shape = uint16_t(ribbon.shape);
    p.depth = float(z_at(view, ribbon, 0.5) - view.start);
    return p;
}

Rgb stopped_light(const HairInView& hair, const Ribbon& ribbon, uint32_t segment, const glm::dvec2& place) {
    const Rgb depth = hair.attenuation.depth(segment, float(abs_sin_theta(hair.view, ribbon, place)));
    Rgb stopped(0);
    for (int c = 0; c < hair.channels; ++c) stopped[c] = 1 - std::exp(-depth[c]);
    return stopped;
}

}  // namespace tress
