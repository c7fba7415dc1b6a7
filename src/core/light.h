// SPDX-License-Identifier: MIT
// The five kinds of lights. Lights are not surfaces: no ray hits them, and nothing is shadowed by them.
// Positions are double until the scene is recentred about its middle, and stay so: a light may be far away.
#pragma once

#include <string>
#include <variant>

#include "core/image.h"

namespace tress {

struct PointLight {
    DVec3 position{0};
    Rgb intensity{1};  // W/sr
};

struct SpotLight {
    DVec3 position{0}, to{0, 0, -1};
    double angle = 30;  // degrees, of the whole cone; the outer tenth fades smoothly to nothing
    Rgb intensity{1};   // W/sr, inside the cone
};

struct DistantLight {
    DVec3 direction{0, -1, 0};  // the way the light travels
    Rgb irradiance{1};          // on a plane across it
};

/// A parallelogram that shines on the side of cross(edge[0], edge[1]).
struct QuadLight {
    DVec3 corner{0}, edge[2]{{1, 0, 0}, {0, 0, 1}};
    Rgb radiance{1};
};

/// Light from infinitely far all round: an image, latitude (top row: +y) by longitude (middle column: -z, going right:
/// towards +x), or one radiance.
struct EnvironmentLight {
    std::string file;     // as the scene names it; empty: constant
    Image image;          // of `file`, once loaded
    Rgb radiance{1};      // constant, or a factor on the image
    double rotation = 0;  // degrees about +y
};

using Light = std::variant<PointLight, SpotLight, DistantLight, QuadLight, EnvironmentLight>;

}  // namespace tress
