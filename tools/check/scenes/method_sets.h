// SPDX-License-Identifier: MIT
// Options that, one set after the other, use every method there is for each type of light.
#pragma once

#include <vector>

#include "core/options.h"

namespace tress::test {

struct MethodSet {
    const char* name;
    Options options;
};

/// Few samples, photons and texels: for pictures that are held against each other, not looked at.
inline Options small_effort(Isa isa) {
    Options options;
    options.isa = isa;
    options.spp = 2;
    options.photons.count = 2000;
    options.maps.resolution = 48;
    options.projection.cells = 128;
    options.projection.directions = 16;
    options.projection.probe_cells = 64;
    options.projection.probes = 16;
    return options;
}

inline MethodSet projected(const char* name, ProjectionDetail detail, const Options& by) {
    MethodSet set{name, by};
    set.options.type2 = GatherMethod::projection;
    set.options.projection.detail = detail;
    return set;
}

inline std::vector<MethodSet> method_sets(Isa isa) {
    Options effort = small_effort(isa);
    std::vector<MethodSet> sets{{"paths", effort}, {"paths, full scattering", effort}};
    for (MethodSet& set : sets) use_paths(set.options);
    sets[1].options.scattering = ScatteringModel::full;

    effort.type4 = effort.type5 = ScatteredMethod::photons;
    sets.push_back({"rays and photons", effort});
    effort.type1 = LampMethod::deep;
    effort.type3 = CrossingMethod::ray_deep;
    sets.push_back(projected("deep maps, all hair projected", ProjectionDetail::all, effort));
    effort.type1 = LampMethod::opacity;
    effort.type3 = CrossingMethod::ray_opacity;
    sets.push_back(projected("opacity maps, a tree projected", ProjectionDetail::tree, effort));
    sets.back().options.projection.far_field = FarField::on;
    effort.type1 = LampMethod::clusters;
    effort.type3 = CrossingMethod::ray_clusters;
    sets.push_back(projected("clusters, layers projected", ProjectionDetail::layers, effort));
    effort.type4 = effort.type5 = ScatteredMethod::off;
    sets.push_back(projected("simplified hair projected", ProjectionDetail::simplified, effort));
    return sets;
}

}  // namespace tress::test
