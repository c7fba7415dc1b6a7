// SPDX-License-Identifier: MIT
// Options that, one set after the other, use the methods that there are for each type of light.
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

/// Types 1 to 3 by rays.
inline Options by_rays(Isa isa) {
    Options options;
    options.isa = isa;
    options.spp = 16;
    options.photons.count = 20'000;
    return options;
}

inline Options by_maps(Options options, LampMethod lamps, CrossingMethod crossings) {
    options.type1 = lamps;
    options.type3 = crossings;
    return options;
}

inline Options by_projection(Options options, ProjectionDetail detail) {
    options.type2 = GatherMethod::projection;
    options.projection.detail = detail;
    return options;
}

inline std::vector<MethodSet> method_sets(Isa isa) {
    const Options effort = small_effort(isa);
    Options paths = effort, full = effort, rays = effort;
    use_paths(paths);
    use_paths(full);
    full.scattering = ScatteringModel::full;
    rays.type4 = rays.type5 = ScatteredMethod::photons;

    Options clusters = by_maps(rays, LampMethod::clusters, CrossingMethod::ray_clusters);
    clusters.type4 = clusters.type5 = ScatteredMethod::path;
    Options deep = by_projection(by_maps(rays, LampMethod::deep, CrossingMethod::ray_deep), ProjectionDetail::all);
    deep.projection.gap = 1;
    Options opacity =
        by_projection(by_maps(rays, LampMethod::opacity, CrossingMethod::ray_opacity), ProjectionDetail::tree);
    opacity.projection.far_field = FarField::on;
    return {
        {"paths", paths},       {"paths, full scattering", full},        {"rays and photons", rays},
        {"clusters", clusters}, {"deep maps, all hair projected", deep}, {"opacity maps, a tree projected", opacity}};
}

}  // namespace tress::test
