// SPDX-License-Identifier: MIT
// Whether a tree's answers to a ray are those of brute force in double precision.
#pragma once

#include "tools/check/support/segment_oracle.h"
#include "tools/check/support/tree_scenes.h"

namespace tress::oracle {

inline constexpr float kTransmission = 0.7f;  // of a crossing

/// What a tree says of a batch of rays, asked in three ways.
struct Answers {
    scenes::Nearest nearest;
    scenes::Constant constant;
    Crossings crossings;

    Answers(const KdTree& tree, const RayBatch& rays, Isa isa = Isa::automatic)
        : nearest(scenes::nearest(tree, rays, isa)),
          constant(scenes::constant(tree, rays, kTransmission, 0, isa)),
          crossings(tress::crossings(tree, rays, isa)) {}
};

struct Verdict {
    const char* fault = nullptr;  // the first thing that is wrong
    bool too_close = false;       // to call: several counts of crossings are right
};

/// The nearest hit of ray i.
inline const char* nearest_fault(const std::vector<Approach>& near, const Ray& ray, const scenes::Nearest& nearest,
                                 size_t i) {
    double surely_before = kInfinity, tolerance = 0;
    const Approach* hit = nullptr;
    for (const Approach& a : near) {
        if (surely(a, ray, false) && a.t + a.tolerance < surely_before) {
            surely_before = a.t + a.tolerance;
            tolerance = a.tolerance;
        }
        if (a.id == nearest.id[i] && possibly(a, ray, false)) hit = &a;
    }
    const double t = double(nearest.t[i]);
    if (nearest.id[i] == kNone)
        return surely_before < kInfinity ? "a hit is lost" : t < kInfinity ? "t without a hit" : nullptr;
    if (!hit) return "a hit that is none";
    if (t > surely_before + tolerance) return "a nearer hit is lost";
    if (std::abs(t - hit->t) > hit->tolerance) return "t is wrong";
    // Along the axis, h is the whole offset; at a round end, a part of it; and of a parallel ray it says nothing.
    if (hit->u != hit->u_line || hit->sine <= 1e-3) return nullptr;
    const double offset = std::min(hit->offset, 1.0);
    return std::abs(std::abs(double(nearest.h[i])) - offset) <= 2 * kEdge ? nullptr : "h is wrong";
}

/// What ray i passes through, `count` crossings by the constant query.
inline const char* crossings_fault(const Crossings& crossings, size_t i, uint32_t count) {
    const uint64_t first = crossings.first[i], last = crossings.first[i + 1];
    if (last - first != count) return "crossings are listed that are not counted, or the other way round";
    for (uint64_t k = first; k + 1 < last; ++k) {
        const float t = crossings.t[k], next = crossings.t[k + 1];
        if (t > next || (t == next && crossings.id[k] >= crossings.id[k + 1])) return "crossings are out of order";
    }
    return nullptr;
}

/// All answers to ray i of the batch.
inline Verdict judge(const Scene& scene, const RayBatch& rays, size_t i, const Answers& answers, bool open_ends) {
    const Ray ray = ray_of(rays, i);
    const std::vector<Approach> near = approaches(scene, ray);
    uint32_t fewest = 0, most = 0;
    for (const Approach& a : near) {
        fewest += surely(a, ray, open_ends);
        most += possibly(a, ray, open_ends);
    }
    const bool too_close = fewest != most;
    const uint32_t count = answers.constant.crossings[i];
    if (const char* fault = nearest_fault(near, ray, answers.nearest, i)) return {fault, too_close};
    if (count < fewest) return {"crossings are lost", too_close};
    if (count > most) return {"crossings that are none", too_close};
    if (std::abs(double(answers.constant.transmittance[i]) - std::pow(double(kTransmission), count)) > 1e-6)
        return {"transmittance is not that of the crossings", too_close};
    return {crossings_fault(answers.crossings, i, count), too_close};
}

}  // namespace tress::oracle
