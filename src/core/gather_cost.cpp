// SPDX-License-Identifier: MIT
#include "core/gather_cost.h"

#include <algorithm>
#include <cmath>

#include "core/hair_measure.h"
#include "core/measured_seconds.h"

namespace tress {
namespace {

/// Of one point of hair. Cells and cubes cost by measured powers (docs/projection.md); layers and simplified hair as
/// what they keep.
double seconds_of_projection(const ProjectionOptions& o, ProjectionDetail detail, double segments) {
    switch (detail) {
        case ProjectionDetail::tree:
            return kWalkSeconds * std::pow(o.cells / 256.0, 1.2) * std::pow(3 / double(o.opening), 1.7) *
                   std::pow(segments / kWalkSegments, 0.2);
        case ProjectionDetail::simplified:
            return kProjectedSegmentSeconds * segments * double(o.share) / o.stride;
        default:
            return kProjectedSegmentSeconds * segments;
    }
}

/// Probes that points ask for: the corners of the cubes along a surface over the hair, some deep.
double probes(const ProjectionOptions& o) { return 6 * square(double(o.probes)); }

}  // namespace

GatherCost estimate_gather_cost(const Scene& scene, const Options& options, ProjectionDetail detail, size_t skies,
                                bool polygons) {
    const SegmentView segments = view(scene.hair, scene.segments);
    const HairMeasure hair = measure_hair(segments);
    const ProjectionOptions& o = options.projection;
    const double pixels = double(scene.camera.width) * scene.camera.height;
    const bool meshes = scene.mesh.triangles() > 0;
    const double at_hair = pixels * share_of_picture(scene.camera, hair.bounds),
                 elsewhere = meshes ? pixels - at_hair : 0;

    const double ways = double(options.gather.rays) * (double(skies) + (polygons ? 1 : 0));
    const double through_hair = kShadeSeconds + kRaySeconds + crossings_of_ray(scene, options, hair) * kCrossingSeconds;
    const double rays = ways * (at_hair * through_hair + elsewhere * kPolygonRaySeconds);
    const double cells =
        at_hair * (seconds_of_projection(o, detail, double(segments.size())) + o.directions * kDirectionSeconds) +
        elsewhere * o.rays * kPolygonRaySeconds;
    const double spp = samples_in_time(options, rays);
    const double probe = 2.0 * o.probe_cells * kProbeRaySeconds;
    return {spp * rays, spp * cells,
            (detail == ProjectionDetail::tree ? double(segments.size()) * kTreeSegmentSeconds : 0) + kTrialSeconds +
                (meshes ? std::min(probes(o), spp * at_hair) * probe : 0)};
}

}  // namespace tress
