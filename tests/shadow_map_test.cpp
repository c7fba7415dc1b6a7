// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/shadow_map.h"

#include <doctest/doctest.h>

#include "tools/check/support/hair_views.h"

using namespace tress;
using namespace tress::fragments;

namespace {

/// Of 8 x 8 texels about the z axis, which see the square of side 1 at z = 4; the lamp is at z = 0.
LightView small_view(bool parallel) {
    LightView view;
    view.parallel = parallel;
    view.frame = frame_about(Vec3(0, 0, 1));
    view.start = 1;
    view.width = view.height = 8;
    view.texel = glm::dvec2(parallel ? 0.125 : 0.125 / 4);
    view.low = -4.0 * view.texel;
    return view;
}

}  // namespace

// deep: deep.error; layers are a quarter as thick as fibers are apart; there are more clusters than fibers.
TEST_CASE("fibers that run through a view and end outside it are lit one after another, by maps of every kind") {
    constexpr float kDepth = 0.5f;  // of each, which covers the whole view
    Hair hair;
    for (const float z : {3.0f, 4.0f, 5.0f}) hair.add({-20, 1, z}, {20, -1, z}, 1);
    const Options options;
    for (const bool parallel : {true, false})
        for (const MapKind kind : {MapKind::deep, MapKind::opacity, MapKind::clusters}) {
            CAPTURE(parallel);
            CAPTURE(int(kind));
            const ShadowMap map =
                make_shadow_map(small_view(parallel), kind, hair.view(), constant_attenuation(Rgb(kDepth)), options);
            for (int before = 0; before <= 3; ++before) {
                CAPTURE(before);
                const ViewPoint at = project(map.view, {0.01f, 0.02f, 2.5f + float(before)});
                CHECK(std::abs(transmittance(map, at).x - std::exp(-kDepth * float(before))) <= options.deep.error);
            }
        }
}
