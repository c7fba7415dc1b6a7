// SPDX-License-Identifier: MIT
#include "gather/irradiance_map.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "core/mesh_points.h"
#include "core/rng.h"
#include "gather/disc_coverage.h"

namespace tress {
namespace {

// Places are photons and points spread evenly over the polygons, so many a photon. Were there the former alone, all
// that is dark would read the nearest light: a shadow edge has its photons on one side.
constexpr float kPlaceShare = 0.125f, kEvenShare = 0.25f;
constexpr size_t kBatch = 64;  // places worked out together

/// Rows of photons, shared out by a number of each one's own, not by counting: paths of photons have their rhythm.
struct Roles {
    std::vector<uint32_t> places, sources;
};
Roles draw_roles(size_t photons) {
    constexpr uint64_t kKey = hash(0, 0x706c6163);
    Roles roles;
    for (uint32_t i = 0; i < photons; ++i) (random(kKey, i) < kPlaceShare ? roles.places : roles.sources).push_back(i);
    return roles;
}

struct Scratch {
    DiscSearch search;
    DiscCoverage coverage;
    std::vector<SurfacePoint> points;
    std::vector<float> radius, share;
};

enum class Side : uint8_t { front, back, both };

/// Of the nearest source on about the same plane; both where there is none.
std::vector<Side> lit_sides(const MeshPoints& points, const PolygonPhotons& sources) {
    std::vector<Side> sides(points.position.size(), Side::both);
    tbb::parallel_for(tbb::blocked_range<size_t>(0, sides.size(), kBatch), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const SurfacePoint front = surface_point(points.position[i], points.normal[i]);
            const auto on_either_side = [&](uint32_t place, float distance2) {
                const Vec3& normal = sources.normal[place];
                const Vec3 chord = sources.tree.position(place) - front.position;
                return on_same_surface(front, chord, std::sqrt(distance2),
                                       dot(normal, front.normal) > 0 ? normal : -normal);
            };
            const uint32_t nearest =
                nearest_place(sources.tree, front.position, sources.radius.largest, on_either_side);
            if (nearest == kNowhere) continue;
            sides[i] = dot(sources.normal[nearest], front.normal) > 0 ? Side::front : Side::back;
        }
    });
    return sides;
}

/// Photons and even points; these on the side of the nearest light, or on both where there is none.
MeshPoints list_places(const PhotonList& list, std::span<const uint32_t> photons, const PolygonPhotons& sources,
                       const TriangleMesh& mesh) {
    MeshPoints places;
    const auto add = [&](const Vec3& position, const Vec3& normal) {
        places.position.push_back(position);
        places.normal.push_back(normal);
    };
    for (const uint32_t row : photons) add(list.position(row), list.normal[row]);
    const MeshPoints even = spread_points(mesh, size_t(kEvenShare * float(list.size())));
    const std::vector<Side> sides = lit_sides(even, sources);
    for (size_t i = 0; i < even.position.size(); ++i) {
        if (sides[i] != Side::back) add(even.position[i], even.normal[i]);
        if (sides[i] != Side::front) add(even.position[i], -even.normal[i]);
    }
    return places;
}

/// What the sources must stand for: all the power.
float power_of_all(const PhotonList& list, const Roles& roles) {
    double of_sources = 0, of_places = 0;
    for (const uint32_t row : roles.sources) of_sources += double(mean(list.power[row]));
    for (const uint32_t row : roles.places) of_places += double(mean(list.power[row]));
    return of_sources > 0 ? float(1 + of_places / of_sources) : 0;
}

}  // namespace

IrradianceMap make_irradiance_map(const PhotonList& list, const TriangleMesh& mesh, const KdTree& mesh_tree,
                                  const Options& options) {
    const Roles roles = draw_roles(list.size());
    const PolygonPhotons sources = make_polygon_photons(list, roles.sources, options.photons);
    const auto& [position, normal] = list_places(list, roles.places, sources, mesh);
    IrradianceMap map;
    map.tree = make_point_tree(position);
    map.normal = in_tree_order<Vec3>(map.tree, normal);
    map.irradiance.resize(map.tree.size());
    map.farthest = sources.radius.largest;

    const float strength = power_of_all(list, roles);
    tbb::enumerable_thread_specific<Scratch> scratch;
    const auto fill = [&](const tbb::blocked_range<size_t>& range) {
        Scratch& s = scratch.local();
        s.points.clear();
        s.radius.clear();
        for (size_t i = range.begin(); i < range.end(); ++i) {
            s.points.push_back(surface_point(map.tree.position(i), map.normal[i]));
            s.search(sources, s.points.back());
            s.radius.push_back(s.search.radius());
            for (const Rgb& light : s.search.irradiance(sources)) map.irradiance[i] += light;
        }
        s.share.resize(s.points.size());
        s.coverage(mesh_tree, mesh, options.isa, s.points, s.radius, s.share);
        for (size_t i = range.begin(); i < range.end(); ++i) map.irradiance[i] *= strength / s.share[i - range.begin()];
    };
    tbb::parallel_for(tbb::blocked_range<size_t>(0, map.tree.size(), kBatch), fill, tbb::simple_partitioner());
    return map;
}

Rgb irradiance(const IrradianceMap& map, const Vec3& position, const Vec3& normal) {
    const SurfacePoint point = surface_point(position, normal);
    const uint32_t place = nearest_place(map.tree, position, map.farthest, [&](uint32_t at, float distance2) {
        return on_same_surface(point, map.tree.position(at) - position, std::sqrt(distance2), map.normal[at]);
    });
    return place == kNowhere ? Rgb(0) : map.irradiance[place];
}

size_t bytes(const IrradianceMap& map) {
    return bytes(map.tree) + map.normal.capacity() * sizeof(Vec3) + map.irradiance.capacity() * sizeof(Rgb);
}

}  // namespace tress
