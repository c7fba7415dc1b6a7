// SPDX-License-Identifier: MIT
// From strands to light through hair: a curtain of 500 fibers, and how much of a lamp behind it comes through.
#include <cstdio>

#include "core/scene.h"
#include "gather/prepared_scene.h"
#include "gather/visibility.h"

using namespace tress;

int main() {
    PlacedHair hair;
    hair.strands.constant_radius = 0.004f;  // cm
    hair.strands.first = {0};
    for (int i = 0; i < 500; ++i) {
        const float x = 0.01f * float(i % 100), z = 0.2f * float(i / 100);  // five rows of 100, a gap of 20 % each
        hair.strands.add_point({x, 0, z});
        hair.strands.add_point({x, 10, z});
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    FiberParameters brown;
    brown.sigma_a = sigma_a_from_melanin(1.3f, 0);
    hair.fiber = make_fiber(brown);

    const Options options;
    const Scene scene = assemble({hair}, {}, {PointLight{}}, Camera{});
    const PreparedScene prepared = prepare(scene, make_plan(scene, options), options);

    RayBuffer rays;
    for (int i = 0; i < 1000; ++i) {
        const DVec3 eye(0.1 + 0.0008 * i, 5, -10);
        rays.add(Vec3(eye - scene.origin), {0, 0, 1}, kInfinity, {});
    }
    std::vector<Rgb> visibility(rays.size());
    VisibilityQuery()(prepared, rays, options, visibility);

    glm::dvec3 sum(0);
    for (const Rgb& v : visibility) sum += glm::dvec3(v);
    sum /= double(rays.size());
    std::printf("%zu segments; light that comes through: %.4f %.4f %.4f\n", scene.segments.point.size(), sum.x, sum.y,
                sum.z);
    return sum.x > sum.z && sum.z > 0 && sum.x < 1 ? 0 : 1;  // brown hair lets more red through than blue
}
