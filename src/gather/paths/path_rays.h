// SPDX-License-Identifier: MIT
// Where the rays of paths end. Straight model: light comes through hair weakened, and a ray ends at a fiber with the
// chance that its transmittance falls by there (of the channel that passes best). So one random number a ray decides
// between the fibers and what lies behind them, and no ray branches. Full model: hair is opaque, as polygons are.
#pragma once

#include <span>
#include <vector>

#include "gather/ray_buffer.h"
#include "gather/shading_point.h"

namespace tress {

enum class PathEnd { nothing, polygon, fiber };

class PathRays {
public:
    /// The rays to trace next; their far ends are set by trace().
    RayBuffer rays;

    /// `chance`: one a ray, uniform in (0, 1].
    void trace(const PreparedScene& prepared, const Options& options, std::span<const float> chance);

    PathEnd end(size_t ray) const { return end_[ray]; }
    /// Of an end that is not nothing.
    Hit hit(size_t ray) const { return {t_[ray], id_[ray], u_[ray], h_[ray]}; }
    /// Weight of light that a ray brings from its end.
    Rgb weight(size_t ray) const { return weight_[ray]; }
    /// Weight of light that enters the ray at `distance`: 0 where the ray ends before.
    Rgb weight_at(size_t ray, float distance) const;

private:
    void find_polygons(const PreparedScene& prepared, const Options& options);
    void fly_through_hair(const PreparedScene& prepared, const Options& options, std::span<const float> chance);
    void find_hair(const PreparedScene& prepared, const Options& options);

    std::vector<PathEnd> end_;
    std::vector<Rgb> weight_;
    std::vector<float> t_, u_, h_;  // of polygons h is the barycentric coordinate v
    std::vector<uint32_t> id_;
    std::vector<float> hair_t_, hair_u_, hair_h_;
    std::vector<uint32_t> hair_id_;
    Flights flights_;
    bool flown_ = false;  // flights_ belong to these rays
};

}  // namespace tress
