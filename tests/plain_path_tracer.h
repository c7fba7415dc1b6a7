// SPDX-License-Identifier: MIT
// The whole of the light that a point sends to the eye, written from the formula in the plainest way: one ray at a
// time, at every crossing a choice between F and R, no types, no weighing of techniques. Lamps are only asked directly,
// environments only met (or only asked, where a small sun in them would be met too rarely). An R event draws its
// direction by all of f, so that f_R alone is never sampled here.
#pragma once

#include "core/light_sample.h"
#include "core/rng.h"
#include "gather/shading_point.h"

namespace tress::test {

/// One ray and what it crosses; in the full model just the first fiber.
class PlainRay {
public:
    PlainRay(const PreparedScene& prepared, const Vec3& origin, const Vec3& direction, float t_far,
             const Excluded& excluded, bool full)
        : direction_(direction), prepared_(prepared) {
        rays_.add(origin, direction, t_far, excluded);
        const auto out = [](Hit& hit) { return NearestHits{{&hit.t, 1}, {&hit.id, 1}, {&hit.u, 1}, {&hit.h, 1}}; };
        if (!prepared.mesh.empty()) nearest_triangle(prepared.mesh, rays_.for_mesh(), out(polygon), Isa::automatic);
        if (polygon.id != kNone) rays_.set_far(0, polygon.t);
        if (prepared.hair.empty()) return;
        if (!full) {
            crossed = crossings(prepared.hair, rays_.for_hair(), Isa::automatic);
            return;
        }
        Hit hit{kInfinity, kNone, 0, 0};
        nearest_segment(prepared.hair, rays_.for_hair(), out(hit), Isa::automatic);
        if (hit.id != kNone) crossed = {{0, 1}, {hit.t}, {hit.u}, {hit.h}, {hit.id}};
    }

    size_t crossings_met() const { return crossed.t.size(); }
    Hit crossing(size_t k) const { return {crossed.t[k], crossed.id[k], crossed.u[k], crossed.h[k]}; }

    /// a_k.
    Rgb passes(size_t k) const {
        const SegmentView& segments = prepared_.segments;
        const Vec3 axis = normalize(segments.end(crossed.id[k]) - segments.start(crossed.id[k]));
        return exp(-prepared_.attenuation.depth(crossed.id[k], glm::min(std::abs(dot(axis, direction_)), 1.0f)));
    }

    Hit polygon{kInfinity, kNone, 0, 0};  // the first
    Crossings crossed;                    // before it

private:
    Vec3 direction_;
    const PreparedScene& prepared_;
    RayBuffer rays_;
};

enum class PlainSky { met, asked };

class PlainPathTracer {
public:
    PlainPathTracer(const Scene& scene, const PreparedScene& prepared, ScatteringModel scattering, PlainSky sky)
        : scene_(scene), prepared_(prepared), full_(scattering == ScatteringModel::full), sky_(sky) {}

    /// One estimate of what `x` sends to the eye; `key` is the key of its random numbers.
    Rgb sample(const ShadingPoint& x, uint64_t key) const {
        Path path{x, false, Rgb(1), key};
        Rgb sum(0);
        for (int vertex = 0; path.alive; ++vertex) {
            sum += path.weight * from_lamps(path);
            if (sky_ == PlainSky::asked) sum += path.weight * from_sky(path);
            const Vec3 direction = scatter_on(path);
            if (vertex >= 3) survive(path, vertex);
            if (path.alive) sum += follow(path, direction);
        }
        return sum;
    }

private:
    struct Path {
        ShadingPoint point;
        bool reflects;  // of f only f_R scatters
        Rgb weight;
        uint64_t key, drawn = 0;
        bool alive = true;

        float number() { return tress::random(key, drawn++); }
    };

    Rgb value(const Path& path, const Scattering& s) const { return path.reflects ? s.reflected : s.value(); }

    Rgb visibility(const Path& path, const Vec3& direction, float distance) const {
        const PlainRay ray(prepared_, path.point.position, direction, distance, path.point.excluded, full_);
        if (ray.polygon.id != kNone) return Rgb(0);
        if (full_) return Rgb(ray.crossings_met() == 0 ? 1.0f : 0.0f);
        Rgb product(1);
        for (size_t k = 0; k < ray.crossings_met(); ++k) product *= ray.passes(k);
        return product;
    }

    Rgb from_lamps(Path& path) const {
        Rgb sum(0);
        for (const Light& light : scene_.lights) {
            const float u = path.number();
            const float v = path.number();
            const LightSample to = std::visit(
                [&]<class L>(const L& lamp) -> LightSample {
                    if constexpr (std::is_same_v<L, EnvironmentLight>)
                        return {};
                    else
                        return tress::sample(lamp, path.point.position, {u, v});
                },
                light);
            if (to.irradiance == Rgb(0)) continue;
            const Rgb f = value(path, scatter(scene_, path.point, to.direction));
            if (f != Rgb(0)) sum += f * to.irradiance * visibility(path, to.direction, to.distance);
        }
        return sum;
    }

    Rgb from_sky(Path& path) const {
        Rgb sum(0);
        for (const auto& environment : prepared_.environment) {
            const float u = path.number();
            const float v = path.number();
            if (!environment) continue;
            const EnvironmentSample to = sample_environment(*environment, {u, v});
            if (!(to.pdf > 0)) continue;
            const Rgb f = value(path, scatter(scene_, path.point, to.direction));
            if (f != Rgb(0)) sum += f * to.radiance / to.pdf * visibility(path, to.direction, kInfinity);
        }
        return sum;
    }

    Vec3 scatter_on(Path& path) const {
        glm::vec4 u;
        for (int i = 0; i < 4; ++i) u[i] = path.number();
        const Vec3 direction = sample_scattering(scene_, path.point, u);
        const Scattering s = scatter(scene_, path.point, direction);
        path.alive = s.pdf > 0;
        if (path.alive) path.weight *= value(path, s) / s.pdf;
        return direction;
    }

    void survive(Path& path, int vertex) const {
        const float chance = glm::min(max_component(path.weight), vertex < 20 ? 1.0f : 0.9f);
        path.alive = path.number() < chance;
        path.weight /= chance;
    }

    /// Moves the path to where the ray ends; what it brings if that is the sky.
    Rgb follow(Path& path, const Vec3& direction) const {
        const PlainRay ray(prepared_, path.point.position, direction, kInfinity, path.point.excluded, full_);
        for (size_t k = 0; k < ray.crossings_met(); ++k) {
            const Rgb a = full_ ? Rgb(0) : ray.passes(k);
            const float straight_on = mean(a);
            if (path.number() < straight_on) {
                path.weight *= a / straight_on;
                continue;
            }
            path.weight /= 1 - straight_on;
            path.point = fiber_point(scene_, prepared_, direction, ray.crossing(k));
            path.reflects = !full_;
            return Rgb(0);
        }
        path.alive = ray.polygon.id != kNone;
        path.reflects = false;
        if (path.alive) {
            path.point = polygon_point(scene_, direction, ray.polygon);
            return Rgb(0);
        }
        Rgb sky(0);
        if (sky_ == PlainSky::asked) return sky;
        for (const auto& environment : prepared_.environment)
            if (environment) sky += radiance(*environment, direction);
        return path.weight * sky;
    }

    const Scene& scene_;
    const PreparedScene& prepared_;
    bool full_;
    PlainSky sky_;
};

}  // namespace tress::test
