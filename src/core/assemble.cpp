// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/error.h"
#include "core/scene.h"

namespace tress {
namespace {

constexpr double kUlpsAFiber = 4;  // a fiber thinner than this many ulp of its coordinates has no shape left
constexpr size_t kMostPoints = 0xfffffffe;

/// Calls use(point) with the ends of every segment that is kept: what is dropped moves nothing else.
template <class Use>
void for_kept_points(const StrandSet& strands, const Use& use) {
    for (size_t strand = 0; strand < strands.strands(); ++strand) {
        bool used = false;  // point p, by the segment before it
        for (uint32_t p = strands.first[strand]; p + 1 < strands.first[strand + 1]; ++p) {
            const bool kept = fate_of_segment(strands, p) == SegmentFate::kept;
            if (kept && !used) use(strands.point(p));
            if (kept) use(strands.point(p + 1));
            used = kept;
        }
    }
}

DBounds placed_bounds(const PlacedHair& hair) {
    DBounds box;
    for_kept_points(hair.strands, [&](const Vec3& p) { box.add(hair.placement.point(DVec3(p))); });
    return box;
}

DBounds placed_bounds(const PlacedMesh& mesh) {
    DBounds box;
    for (size_t i = 0; i < mesh.mesh.vertices(); ++i)
        if (const Vec3 p = mesh.mesh.vertex(i); is_finite(p)) box.add(mesh.placement.point(DVec3(p)));
    return box;
}

template <class Objects>
DBounds all_bounds(const Objects& objects) {
    DBounds box;
    for (const auto& object : objects)
        if (const DBounds b = placed_bounds(object); !b.empty()) box.add(b);
    return box;
}

double largest_coordinate(const StrandSet& s) {
    double largest = 0;
    for_kept_points(s, [&](const Vec3& p) { largest = std::max<double>(largest, max_component(abs(p))); });
    return largest;
}

double largest_radius(const StrandSet& s) {
    double largest = s.radius.empty() ? s.constant_radius : 0;
    for (const float r : s.radius)
        if (std::isfinite(r)) largest = std::max<double>(largest, r);
    return largest;
}

void check_resolution(size_t object, double radius, double coordinate, const char* which) {
    const double ulp = coordinate * std::numeric_limits<float>::epsilon();
    if (radius > 0 && radius < kUlpsAFiber * ulp)
        throw InputError("hair[" + std::to_string(object) + "]",
                         "radius " + std::to_string(radius) + " is below 4 ulp of its " + which +
                             " coordinates (up to " + std::to_string(coordinate) +
                             "), expected hair nearer to its origin or thicker");
}

void append_strands(Scene& scene, const PlacedHair& object) {
    const StrandSet& from = object.strands;
    StrandSet& to = scene.hair;
    const size_t base = to.points();
    if (base + from.points() > kMostPoints) throw InputError("hair", "more points than 32 bits count");
    for (size_t i = 0; i < from.points(); ++i)
        to.add_point(Vec3(object.placement.point(DVec3(from.point(i))) - scene.origin));
    if (to.first.empty()) to.first.push_back(0);
    for (size_t strand = 0; strand < from.strands(); ++strand)
        to.first.push_back(uint32_t(base + from.first[strand + 1]));
}

/// One radius for everything where the scene allows it, else one a point.
void merge_radii(Scene& scene, const std::vector<PlacedHair>& hair) {
    const auto scaled = [](const PlacedHair& object, float radius) {
        return float(double(radius) * object.placement.scale());
    };
    bool constant = true;
    for (const PlacedHair& object : hair)
        constant &= object.strands.radius.empty() && scaled(object, object.strands.constant_radius) ==
                                                         scaled(hair.front(), hair.front().strands.constant_radius);
    if (constant) {
        scene.hair.constant_radius = hair.empty() ? 0 : scaled(hair.front(), hair.front().strands.constant_radius);
        return;
    }
    scene.hair.radius.reserve(scene.hair.points());
    for (const PlacedHair& object : hair)
        for (size_t i = 0; i < object.strands.points(); ++i)
            scene.hair.radius.push_back(scaled(object, object.strands.radius_at(i)));
}

void merge_absorption(Scene& scene, const std::vector<PlacedHair>& hair) {
    const bool any = std::any_of(hair.begin(), hair.end(), [](const auto& h) { return !h.strands.color.empty(); });
    if (!any) return;
    scene.sigma_a.reserve(scene.hair.points());
    for (const PlacedHair& object : hair) {
        const FiberParameters& fiber = object.fiber.parameters;
        for (const Rgb& color : object.strands.color) scene.sigma_a.push_back(sigma_a_from_color(color, fiber.beta_n));
        if (object.strands.color.empty())
            scene.sigma_a.insert(scene.sigma_a.end(), object.strands.points(), fiber.sigma_a);
    }
}

void add_hair(Scene& scene, const std::vector<PlacedHair>& hair) {
    size_t points = 0;
    for (const PlacedHair& object : hair) points += object.strands.points();
    for (std::vector<float>* axis : {&scene.hair.x, &scene.hair.y, &scene.hair.z}) axis->reserve(points);
    std::vector<uint32_t> first_point;
    for (const PlacedHair& object : hair) {
        first_point.push_back(uint32_t(scene.hair.points()));
        append_strands(scene, object);
        scene.fibers.push_back(object.fiber);
    }
    merge_radii(scene, hair);
    merge_absorption(scene, hair);
    scene.segments = list_segments(scene.hair);
    const auto& point = scene.segments.point;
    for (const uint32_t first : first_point)
        scene.fiber_segment.push_back(uint32_t(std::lower_bound(point.begin(), point.end(), first) - point.begin()));
    scene.fiber_segment.push_back(uint32_t(point.size()));
}

/// Unit normal of a placed surface: by the cofactors of the map, which also holds for mirrors and squeezes.
Vec3 placed_normal(const Placement& placement, const Vec3& n) {
    const DVec3 x = placement.vector({1, 0, 0}), y = placement.vector({0, 1, 0}), z = placement.vector({0, 0, 1});
    const DVec3 v = double(n.x) * cross(y, z) + double(n.y) * cross(z, x) + double(n.z) * cross(x, y);
    const double length = glm::length(v);
    return length > 0 ? Vec3(v / length) : n;
}

void add_mesh(Scene& scene, const PlacedMesh& object) {
    TriangleMesh& to = scene.mesh;
    const uint32_t base = uint32_t(to.vertices());
    if (base + object.mesh.vertices() > kMostPoints) throw InputError("meshes", "more vertices than 32 bits count");
    const bool mirrored = object.placement.determinant() < 0;
    for (size_t i = 0; i < object.mesh.vertices(); ++i)
        to.add_vertex(Vec3(object.placement.point(DVec3(object.mesh.vertex(i))) - scene.origin));
    for (size_t t = 0; t < object.mesh.triangles(); ++t) {
        const uint32_t* c = &object.mesh.corner[3 * t];
        to.corner.insert(to.corner.end(), {base + c[0], base + c[mirrored ? 2 : 1], base + c[mirrored ? 1 : 2]});
    }
    to.surface.insert(to.surface.end(), object.mesh.triangles(), uint16_t(scene.albedo.size()));
    scene.albedo.push_back(object.albedo);
}

/// Normals of all meshes where any has them; a zero normal says that a vertex is flat.
void merge_normals(Scene& scene, const std::vector<PlacedMesh>& meshes) {
    const bool any = std::any_of(meshes.begin(), meshes.end(), [](const auto& m) { return !m.mesh.normal.empty(); });
    if (!any) return;
    for (const PlacedMesh& object : meshes) {
        const float side = object.placement.determinant() < 0 ? -1.0f : 1.0f;
        for (const Vec3& n : object.mesh.normal) scene.mesh.normal.push_back(side * placed_normal(object.placement, n));
        if (object.mesh.normal.empty())
            scene.mesh.normal.insert(scene.mesh.normal.end(), object.mesh.vertices(), Vec3(0));
    }
}

struct Recentre {
    DVec3 origin;
    void operator()(PointLight& light) const { light.position -= origin; }
    void operator()(SpotLight& light) const {
        light.position -= origin;
        light.to -= origin;
    }
    void operator()(DistantLight&) const {}
    void operator()(QuadLight& light) const { light.corner -= origin; }
    void operator()(EnvironmentLight&) const {}
};

}  // namespace

Scene assemble(std::vector<PlacedHair> hair, std::vector<PlacedMesh> meshes, std::vector<Light> lights,
               const Camera& camera) {
    constexpr size_t most_objects = 0xffff;  // 16-bit fiber and surface numbers
    if (hair.size() > most_objects) throw InputError("hair", "more than 65,535 objects");
    if (meshes.size() > most_objects) throw InputError("meshes", "more than 65,535 objects");
    Scene scene;
    DBounds middle = all_bounds(hair);
    if (middle.empty()) middle = all_bounds(meshes);
    if (!middle.empty()) scene.origin = middle.center();

    for (size_t i = 0; i < hair.size(); ++i) {
        const double radius = largest_radius(hair[i].strands);
        check_resolution(i, radius, largest_coordinate(hair[i].strands), "own");
        DBounds box = placed_bounds(hair[i]);
        if (box.empty()) continue;
        const DVec3 farthest = max(abs(box.lo - scene.origin), abs(box.hi - scene.origin));
        check_resolution(i, radius * hair[i].placement.scale(), max_component(Vec3(farthest)), "recentred");
    }
    add_hair(scene, hair);
    for (const PlacedMesh& mesh : meshes) add_mesh(scene, mesh);
    merge_normals(scene, meshes);

    scene.lights = std::move(lights);
    for (Light& light : scene.lights) std::visit(Recentre{scene.origin}, light);
    scene.camera = camera;
    scene.camera.from -= scene.origin;
    scene.camera.to -= scene.origin;
    scene.bounds = bounds(view(scene.hair, scene.segments));
    for (size_t i = 0; i < scene.mesh.vertices(); ++i) scene.bounds.add(scene.mesh.vertex(i));
    return scene;
}

uint32_t fiber_of(const Scene& scene, uint32_t segment) {
    const auto& first = scene.fiber_segment;
    return uint32_t(std::upper_bound(first.begin(), first.end(), segment) - first.begin()) - 1;
}

}  // namespace tress
