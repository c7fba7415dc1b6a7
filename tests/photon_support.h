// SPDX-License-Identifier: MIT
// Photons of small scenes, and means over seeds with their errors.
#pragma once

#include <cmath>
#include <vector>

#include "gather/photons/photon_tracing.h"
#include "tools/check/support/small_scenes.h"

namespace tress::test {

/// A scene made ready for photons, without any traced yet.
struct PhotonScene {
    Scene scene;
    Options options;
    Plan plan;
    PreparedScene prepared;

    TracedPhotons trace(uint64_t seed = 0) const {
        Options o = options;
        o.seed = seed;
        return trace_photons(scene, prepared, plan, o);
    }
};

inline Options photon_options(int count) {
    Options o;
    o.photons.count = count;
    return o;
}

/// Type 2 by `ray`, so that polygons store photons.
inline PhotonScene photon_scene(std::vector<PlacedHair> hair, std::vector<PlacedMesh> meshes, std::vector<Light> lights,
                                const Options& options) {
    PhotonScene s;
    s.scene = assemble(std::move(hair), std::move(meshes), std::move(lights), camera_on_z(10, 30, 4));
    s.options = options;
    s.plan = make_plan(s.scene, options);
    Plan trees = s.plan;
    trees.polygon_gather = false;
    trees.photon_display = {};
    s.prepared = prepare(s.scene, trees, options);
    return s;
}

/// Mean over seeds and its standard error, from their spread.
struct Estimate {
    double mean = 0, error = 0;
};

constexpr int kSeeds = 16;

/// `value(photons, i)` for i < values; one estimate each.
template <class Value>
std::vector<Estimate> over_seeds(const PhotonScene& scene, size_t values, const Value& value) {
    std::vector<double> sum(values), squares(values);
    for (uint64_t seed = 0; seed < kSeeds; ++seed) {
        const TracedPhotons photons = scene.trace(seed);
        for (size_t i = 0; i < values; ++i) {
            const double v = value(photons, i);
            sum[i] += v, squares[i] += v * v;
        }
    }
    std::vector<Estimate> estimates;
    for (size_t i = 0; i < values; ++i) {
        const double mean = sum[i] / kSeeds, variance = std::max(squares[i] / kSeeds - mean * mean, 0.0);
        estimates.push_back({mean, std::sqrt(variance / (kSeeds - 1))});
    }
    return estimates;
}

/// Within 4.5 errors of a mean over 16 seeds (Student's t with 15 degrees: once in 2000), and what floats round away.
inline bool agrees(const Estimate& e, double expected) {
    return std::abs(e.mean - expected) <= 4.5 * e.error + 1e-5 * std::abs(expected);
}

/// Power, of one channel, of the photons for which keep(i).
template <class Keep>
double power_of(const PhotonList& list, int channel, const Keep& keep) {
    double sum = 0;
    for (size_t i = 0; i < list.size(); ++i)
        if (keep(i)) sum += double(list.power[i][channel]);
    return sum;
}

inline auto of_type(const PhotonList& list, PathType type) {
    return [&list, type](size_t i) { return list.type[i] == index_of(type); };
}

/// Six squares about the origin, facing in.
inline PlacedMesh closed_box(float half, const Rgb& albedo) {
    PlacedMesh box;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-half, half}) {
            const uint32_t first = uint32_t(box.mesh.vertices());
            for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
                Vec3 p;
                p[axis] = side, p[(axis + 1) % 3] = half * corner.x, p[(axis + 2) % 3] = half * corner.y;
                box.mesh.add_vertex(p);
            }
            for (const uint32_t c : {0u, 1u, 2u, 0u, 2u, 3u}) box.mesh.corner.push_back(first + c);
        }
    }
    box.albedo = albedo;
    return box;
}

}  // namespace tress::test
