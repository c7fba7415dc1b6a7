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

/// What hair next to a point, told apart by samples, adds to that at the defaults: it grows with the area that it is
/// in.
double seconds_of_near(const ProjectionOptions& o) {
    return kSampledSeconds * (square(double(ProjectionOptions().near) / double(o.near)) - 1);
}

/// Corners of a grid over the hair that points ask for: those about the surface that the picture shows, and some deep.
double corners(const Scene& scene, const HairMeasure& hair, double share, int across, double points) {
    const double size = double(max_component(hair.bounds.extent())) / across;
    const double shown = share * area_of_picture(scene.camera, hair.bounds) / square(size);
    return std::min({8 * points, 6 * square(double(across)), 9 * shown});
}

constexpr double kMostFarBytes = 1 << 30, kFarCellBytes = 4, kFarCubesBytes = 1500;  // of a corner

}  // namespace

GatherCost estimate_gather_cost(const Scene& scene, const Options& options, ProjectionDetail detail, size_t skies,
                                bool polygons) {
    const SegmentView segments = view(scene.hair, scene.segments);
    const HairMeasure hair = measure_hair(segments);
    const ProjectionOptions& o = options.projection;
    const double pixels = double(scene.camera.width) * scene.camera.height;
    const double share = share_of_picture(scene.camera, segments);
    const bool meshes = scene.mesh.triangles() > 0;
    const double at_hair = pixels * share, elsewhere = meshes ? pixels - at_hair : 0;

    const double ways = double(options.gather.rays) * (double(skies) + (polygons ? 1 : 0));
    const double through_hair = kShadeSeconds + kRaySeconds + crossings_of_ray(scene, options, hair) * kCrossingSeconds;
    const double rays = ways * (at_hair * through_hair + elsewhere * kPolygonRaySeconds);
    const double spp = samples_in_time(options, rays);

    const bool tree = detail == ProjectionDetail::tree;
    const double whole = seconds_of_projection(o, detail, double(segments.size()));
    const double near = tree ? seconds_of_near(o) : 0;
    const int at_gaps = gap_points(spp * at_hair);
    const double trials = at_gaps * (1 + 1.0 / kGapPointsOfPolygons);
    const auto cost = [&](bool far_field) {
        const double probes = corners(scene, hair, share, probes_across(o, far_field), spp * at_hair);
        const double point = near + (far_field ? kNearSeconds + kNearShare * whole : whole);
        const double probe = (meshes ? 2.0 * o.probe_cells * kProbeRaySeconds : 0) + (far_field ? whole : 0);
        return GatherCost{
            spp * rays,
            spp * (at_hair * (point + o.directions * kDirectionSeconds) + elsewhere * o.rays * kPolygonRaySeconds),
            (tree ? double(segments.size()) * kTreeSegmentSeconds : 0) +
                trials * (kTrialSeconds + kTrialWalks * (whole + near)) + probes * probe,
            far_field, at_gaps};
    };
    const GatherCost alone = cost(false);
    if (!tree || o.far_field == FarField::off) return alone;
    const GatherCost shared = cost(true);
    if (o.far_field == FarField::on) return shared;
    const double probes = corners(scene, hair, share, probes_across(o, true), spp * at_hair);
    // Shared far hair has the point's own fiber in it: what of that does not count must be near.
    const double own = (kOwnStrandRadii + 1) * hair.area / std::max(2 * hair.length, 1e-300);
    const double size = double(max_component(hair.bounds.extent())) / probes_across(o, true);
    const bool fits =
        own < size && probes * (2 * o.cells * kFarCellBytes * (meshes ? 2 : 1) + kFarCubesBytes) < kMostFarBytes;
    return fits && shared.build + shared.projection < alone.build + alone.projection ? shared : alone;
}

}  // namespace tress
