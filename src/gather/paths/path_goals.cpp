// SPDX-License-Identifier: MIT
#include "gather/paths/path_goals.h"

namespace tress {
namespace {

bool carries(const Throughput& t, int state) { return max_component(t.by[size_t(state)]) > 0; }

bool is_wanted(const PathGoals& goals, PathType type) { return goals.wanted[size_t(index_of(type))]; }

bool takes(const PathGoals& goals, bool settled, int state, LightSource source) {
    return is_wanted(goals, type_in(settled, state, source));
}

/// Whether a wanted type can come of `state`, however the path goes on: events R only add up.
bool leads_on(const PathGoals& goals, bool settled, int state) {
    if (settled) return takes(goals, true, state, LightSource::elsewhere);
    for (int later = state; later < Throughput::kStates; ++later)
        for (const LightSource source : {LightSource::lamp, LightSource::elsewhere})
            if (takes(goals, false, later, source)) return true;
    return false;
}

bool goes_on(const PathGoals& goals, bool settled, int state) {
    const int last = Throughput::kStates - 1;
    if (goals.areas && takes(goals, settled, state, LightSource::lamp)) return true;
    if (goals.sky && takes(goals, settled, state, LightSource::elsewhere)) return true;
    if (goals.polygons && leads_on(goals, true, std::min(state, 1))) return true;
    if (goals.forward && leads_on(goals, settled, state)) return true;
    return goals.reflections && leads_on(goals, settled, settled ? state : std::min(state + 1, last));
}

}  // namespace

PathGoals path_goals(const Scene& scene, const Plan& plan, const Options& options) {
    PathGoals goals;
    goals.wanted = plan.paths;
    for (const uint32_t lamp : plan.lamps) goals.areas |= std::holds_alternative<QuadLight>(scene.lights[lamp]);
    goals.sky = !plan.environments.empty();
    goals.polygons = plan.mesh_tree;
    goals.reflections = plan.hair_tree;
    goals.forward = plan.hair_tree && options.scattering == ScatteringModel::full;
    return goals;
}

bool takes(const PathGoals& goals, const Throughput& t, LightSource source) {
    for (int state = 0; state < Throughput::kStates; ++state)
        if (carries(t, state) && takes(goals, t.settled, state, source)) return true;
    return false;
}

bool goes_on(const PathGoals& goals, const Throughput& t) {
    for (int state = 0; state < Throughput::kStates; ++state)
        if (carries(t, state) && goes_on(goals, t.settled, state)) return true;
    return false;
}

Throughput still_wanted(const PathGoals& goals, Throughput t) {
    for (int state = 0; state < Throughput::kStates; ++state)
        if (!leads_on(goals, t.settled, state)) t.by[size_t(state)] = Rgb(0);
    return t;
}

void book(const PathGoals& goals, const Throughput& t, LightSource source, const Rgb& radiance, LightByType& light) {
    for (int state = 0; state < Throughput::kStates; ++state)
        if (carries(t, state) && takes(goals, t.settled, state, source))
            light[size_t(index_of(type_in(t.settled, state, source)))] += t.by[size_t(state)] * radiance;
}

}  // namespace tress
