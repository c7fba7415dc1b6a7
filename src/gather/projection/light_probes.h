// SPDX-License-Identifier: MIT
// Probes shared between points: each is made when a point first asks for it, by whichever thread, and is a function of
// its place alone.
#pragma once

#include <tbb/concurrent_unordered_map.h>

#include "core/gather_cost.h"
#include "gather/projection/light_probe.h"
#include "gather/projection/probe_grid.h"

namespace tress {

class LightProbes {
public:
    LightProbes(const Bounds& hair, const ProjectionOptions& options, bool far_field)
        : grid_(make_probe_grid(hair_cube(hair), probes_across(options, far_field))),
          igloo_(make_igloo(uint32_t(options.probe_cells))) {}

    const ProbeGrid& grid() const { return grid_; }
    const Igloo& igloo() const { return igloo_; }
    /// The probe of a corner of the grid; `make` is called with its key where there is none yet.
    template <class Make>
    const LightProbe& at(uint64_t key, const Make& make) {
        if (const auto found = probes_.find(key); found != probes_.end()) return found->second;
        return probes_.emplace(key, make(key)).first->second;
    }
    size_t bytes() const {
        size_t sum = 0;
        for (const auto& [key, probe] : probes_) sum += probe.bytes();
        return sum;
    }

private:
    ProbeGrid grid_;
    Igloo igloo_;
    tbb::concurrent_unordered_map<uint64_t, LightProbe> probes_;  // by ProbeCube::key
};

}  // namespace tress
