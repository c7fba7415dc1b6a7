// SPDX-License-Identifier: MIT
#include "core/scene_hash.h"

#include <cstring>
#include <type_traits>

#include "core/rng.h"

namespace tress {
namespace {

/// Takes in numbers, vectors of them and arrays of them; structs field by field, so that no padding counts.
class Hasher {
public:
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void add(const T& value) {
        uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof value);
        key_ = hash(key_, bits);
    }
    template <glm::length_t n, class T>
    void add(const glm::vec<n, T>& v) {
        for (glm::length_t i = 0; i < n; ++i) add(v[i]);
    }
    template <class T>
    void add(const std::vector<T>& values) {
        add(values.size());
        for (const T& value : values) add(value);
    }

    void add(const StrandSet& s) {
        add(s.x), add(s.y), add(s.z), add(s.first), add(s.radius), add(s.color), add(s.constant_radius);
    }
    void add(const TriangleMesh& m) { add(m.x), add(m.y), add(m.z), add(m.normal), add(m.corner), add(m.surface); }
    void add(const Fiber& fiber) {
        const FiberParameters& p = fiber.parameters;
        add(p.model), add(p.sigma_a), add(p.beta_m), add(p.beta_n), add(p.alpha_degrees), add(p.eta);
    }
    void add(const Camera& c) { add(c.from), add(c.to), add(c.up), add(c.fov), add(c.width), add(c.height); }

    void add(const PointLight& l) { add(l.position), add(l.intensity); }
    void add(const SpotLight& l) { add(l.position), add(l.to), add(l.angle), add(l.intensity); }
    void add(const DistantLight& l) { add(l.direction), add(l.irradiance); }
    void add(const QuadLight& l) { add(l.corner), add(l.edge[0]), add(l.edge[1]), add(l.radiance); }
    void add(const EnvironmentLight& l) {
        add(l.image.width), add(l.image.height), add(l.image.pixel), add(l.radiance), add(l.rotation);
    }
    void add(const Light& light) {
        add(light.index());
        std::visit([this](const auto& l) { add(l); }, light);
    }

    uint64_t key() const { return key_; }

private:
    uint64_t key_ = 0;
};

}  // namespace

uint64_t scene_hash(const Scene& scene) {
    Hasher hasher;
    hasher.add(scene.origin);
    hasher.add(scene.hair);
    hasher.add(scene.segments.point);
    hasher.add(scene.fiber_segment);
    hasher.add(scene.fibers);
    hasher.add(scene.sigma_a);
    hasher.add(scene.mesh);
    hasher.add(scene.albedo);
    hasher.add(scene.lights);
    hasher.add(scene.camera);
    return hasher.key();
}

}  // namespace tress
