// SPDX-License-Identifier: MIT
#include "gather/photons/irradiance_map.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <numeric>

#include "core/light_sample.h"
#include "core/mesh_points.h"
#include "core/rng.h"
#include "gather/photons/disc_sum.h"
#include "gather/photons/merge_photons.h"

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

MeshPoints photon_places(const PhotonList& list, std::span<const uint32_t> rows) {
    MeshPoints places;
    for (const uint32_t row : rows) {
        places.position.push_back(list.position(row));
        places.normal.push_back(list.normal[row]);
    }
    return places;
}

/// On the side of the nearest light, or on both where there is none.
MeshPoints even_places(const TriangleMesh& mesh, size_t n, const PolygonPhotons& sources) {
    const MeshPoints even = spread_points(mesh, n);
    const std::vector<Side> sides = lit_sides(even, sources);
    MeshPoints places;
    const auto add = [&](const Vec3& position, const Vec3& normal) {
        places.position.push_back(position);
        places.normal.push_back(normal);
    };
    for (size_t i = 0; i < even.position.size(); ++i) {
        if (sides[i] != Side::back) add(even.position[i], even.normal[i]);
        if (sides[i] != Side::front) add(even.position[i], -even.normal[i]);
    }
    return places;
}

std::vector<Vec3> joined(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    std::vector<Vec3> both = a;
    both.insert(both.end(), b.begin(), b.end());
    return both;
}

/// For each source the radius of its disc: what holds the k nearest sources about the nearest pilot.
std::vector<float> disc_radii(const PolygonPhotons& sources, const MeshPoints& pilots) {
    const PointTree tree = make_point_tree(pilots.position);
    std::vector<float> of_pilot(tree.size()), of_source(sources.size());
    tbb::enumerable_thread_specific<DiscSearch> searches;
    tbb::parallel_for(tbb::blocked_range<size_t>(0, tree.size(), kBatch), [&](const auto& range) {
        DiscSearch& search = searches.local();
        for (size_t i = range.begin(); i < range.end(); ++i) {
            search(sources, surface_point(tree.position(i), pilots.normal[tree.id[i]]));
            of_pilot[i] = search.radius();
        }
    });
    tbb::parallel_for(tbb::blocked_range<size_t>(0, sources.size(), kBatch), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const SurfacePoint source = surface_point(sources.tree.position(i), sources.normal[i]);
            const uint32_t pilot =
                nearest_place(tree, source.position, sources.radius.largest, [&](uint32_t at, float distance2) {
                    return on_same_surface(source, tree.position(at) - source.position, std::sqrt(distance2),
                                           pilots.normal[tree.id[at]]);
                });
            of_source[i] = pilot == kNowhere ? sources.radius.largest : of_pilot[pilot];
        }
    });
    return of_source;
}

/// Shares of the discs of the largest radius; 0 for others.
std::vector<float> own_shares(const PolygonPhotons& sources, std::span<const float> radius, const TriangleMesh& mesh,
                              const KdTree& mesh_tree, Isa isa) {
    std::vector<float> shares(sources.size(), 0);
    tbb::enumerable_thread_specific<DiscCoverage> coverages;
    tbb::parallel_for(tbb::blocked_range<size_t>(0, sources.size(), kBatch), [&](const auto& range) {
        std::vector<SurfacePoint> points;
        std::vector<float> radii, share;
        std::vector<size_t> rows;
        for (size_t i = range.begin(); i < range.end(); ++i) {
            if (radius[i] < sources.radius.largest || radius[i] <= sources.radius.least) continue;
            points.push_back(surface_point(sources.tree.position(i), sources.normal[i]));
            radii.push_back(radius[i]);
            rows.push_back(i);
        }
        share.resize(rows.size());
        coverages.local()(mesh_tree, mesh, isa, points, radii, share);
        for (size_t k = 0; k < rows.size(); ++k) shares[rows[k]] = share[k];
    });
    return shares;
}

/// Largest coordinate of a box, without its sign.
float farthest_of(const Bounds& box) {
    return box.empty() ? 0 : glm::max(max_component(abs(box.lo)), max_component(abs(box.hi)));
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
    const PhotonList merged = merge_photons(list, roles.sources);
    std::vector<uint32_t> all(merged.size());
    std::iota(all.begin(), all.end(), 0u);
    const PolygonPhotons sources = make_polygon_photons(merged, all, options.photons, farthest_of(mesh_tree.bounds));
    const MeshPoints pilots = photon_places(list, roles.places);
    const std::vector<float> radii = disc_radii(sources, pilots);
    const PhotonDiscs discs{make_point_balls(sources.tree, radii),
                            own_shares(sources, radii, mesh, mesh_tree, options.isa)};
    const MeshPoints even = even_places(mesh, size_t(kEvenShare * float(list.size())), sources);

    IrradianceMap map;
    map.tree = make_point_tree(joined(pilots.position, even.position));
    map.normal = in_tree_order<Vec3>(map.tree, joined(pilots.normal, even.normal));
    map.irradiance.resize(map.tree.size());
    map.farthest = sources.radius.largest;
    const float strength = power_of_all(list, roles);
    tbb::enumerable_thread_specific<DiscSum> sums;
    const auto fill = [&](const tbb::blocked_range<size_t>& range) {
        std::vector<SurfacePoint> points;
        for (size_t i = range.begin(); i < range.end(); ++i)
            points.push_back(surface_point(map.tree.position(i), map.normal[i]));
        const std::span<Rgb> irradiance = std::span(map.irradiance).subspan(range.begin(), range.size());
        sums.local()(sources, discs, mesh_tree, mesh, options.isa, points, irradiance);
        for (Rgb& light : irradiance) light = min(strength * light, Rgb(kLargestIrradiance));
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
