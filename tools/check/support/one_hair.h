// SPDX-License-Identifier: MIT
// A lone hair, and rays that are hard on it: from very far, along its axis, through its tip, from within it.
#pragma once

#include "accel/build.h"
#include "core/frame.h"
#include "tools/check/support/segment_oracle.h"
#include "tools/check/support/tree_scenes.h"

namespace tress::scenes {

struct FarErrors {
    double wrong = 0;    // share of rays that hit where they should miss, or the other way round
    double t_error = 0;  // 99th percentile, in radii
};

/// Rays from `distance` radii away that pass a lone hair of unit length at up to two radii from its axis.
inline FarErrors far_errors(double distance, size_t count, Isa isa = Isa::automatic) {
    constexpr float kThin = 35e-4f;
    FarErrors errors;
    std::vector<double> t_errors;
    Dice dice(21);
    Hair hair;
    hair.add(Vec3(-0.31f, 0.2f, 0.11f), Vec3(0.6f, -0.13f, 0.24f), kThin);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const oracle::Scene scene(hair.view());
    const DVec3 start(hair.view().start(0)), end(hair.view().end(0));
    Rays rays;
    for (size_t i = 0; i < count; ++i) {
        const DVec3 d(dice.direction());
        const double along = double(dice.unit()), side = 2 * double(dice.both());
        const DVec3 across = normalize(cross(d, end - start));
        const DVec3 through = start + along * (end - start) + side * double(kThin) * across;
        rays.add(Vec3(through - distance * double(kThin) * d), Vec3(d));
    }
    const Nearest found = nearest(tree, rays.batch(), isa);
    for (size_t i = 0; i < count; ++i) {
        const auto near = oracle::approaches(scene, oracle::ray_of(rays.batch(), i));
        const bool hit = !near.empty() && near[0].offset <= 1;
        errors.wrong += double(hit != (found.id[i] == 0)) / double(count);
        if (hit && found.id[i] == 0) t_errors.push_back(std::abs(double(found.t[i]) - near[0].t) / double(kThin));
    }
    const auto percentile = t_errors.begin() + long(t_errors.size() * 99 / 100);
    std::nth_element(t_errors.begin(), percentile, t_errors.end());
    errors.t_error = *percentile;
    return errors;
}

/// A random hair of radius kThick.
inline constexpr float kThick = 0.05f;
inline Hair one_hair(Dice& dice) {
    Hair hair;
    const Vec3 start = dice.in_cube();
    hair.add(start, start + dice.direction(), kThick);
    return hair;
}

/// Along the axis, from before the start and from past the end in turn, within 0.99 radii of it.
inline Rays rays_along(const Hair& hair, size_t count, Dice& dice) {
    const Vec3 start = hair.view().start(0), end = hair.view().end(0), way = end - start;
    const Frame frame = frame_about(normalize(way));
    Rays rays;
    for (size_t i = 0; i < count; ++i) {
        const float angle = 2 * kPi * dice.unit(), r = 0.99f * kThick * std::sqrt(dice.unit());
        const Vec3 off = r * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
        if (i % 2 == 0)
            rays.add(start + off - 2.0f * way, way);
        else
            rays.add(end + off + 2.0f * way, -way);
    }
    return rays;
}

/// In any direction, through the ball of 0.99 radii about the end.
inline Rays rays_through_tip(const Hair& hair, size_t count, Dice& dice) {
    const Vec3 end = hair.view().end(0);
    const Frame frame = frame_about(normalize(end - hair.view().start(0)));
    Rays rays;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 d = dice.direction();
        rays.add(end + 0.99f * kThick * dice.unit() * cross(d, frame.x) - 3.0f * d, d);
    }
    return rays;
}

/// In any direction, from points within 0.99 radii of the axis.
inline Rays rays_from_within(const Hair& hair, size_t count, Dice& dice) {
    const Vec3 start = hair.view().start(0), way = hair.view().end(0) - start;
    const Frame frame = frame_about(normalize(way));
    Rays rays;
    for (size_t i = 0; i < count; ++i) {
        const float angle = 2 * kPi * dice.unit(), r = 0.99f * kThick * std::sqrt(dice.unit());
        const float along = dice.unit();
        const Vec3 off = r * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
        const Vec3 d = dice.direction();
        rays.add(start + along * way + off, d);
    }
    return rays;
}

struct Losses {
    size_t rays = 0, lost = 0, false_hits = 0;
    size_t too_close = 0;  // to call: grazing, or the axis passed within a rounding of where the ray starts
};

/// Nearest hits against double: a ray meets the hair where it passes within the radius of the axis ahead of its start.
inline void add_losses(const Hair& hair, const KdTree& tree, const Rays& rays, Isa isa, Losses& sum) {
    constexpr double kNearStart = 1e-5;  // some roundings of a scene of a few units
    const oracle::Scene scene(hair.view());
    const Nearest found = nearest(tree, rays.batch(), isa);
    for (size_t i = 0; i < rays.size(); ++i) {
        const auto near = oracle::approaches(scene, oracle::ray_of(rays.batch(), i));
        const bool is_hit = found.id[i] == 0;
        const bool close =
            !near.empty() && (std::abs(near[0].offset - 1) < oracle::kEdge || std::abs(near[0].t) < kNearStart);
        const bool meets = !near.empty() && near[0].t >= 0;
        sum.too_close += close;
        sum.lost += !close && meets && !is_hit;
        sum.false_hits += !close && !meets && is_hit;
    }
    sum.rays += rays.size();
}

}  // namespace tress::scenes
