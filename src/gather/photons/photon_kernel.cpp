// SPDX-License-Identifier: MIT
#include "gather/photons/photon_kernel.h"

namespace tress {
namespace {

// The largest radius is kRadiusFactor times what holds k photons about a share kLitShare of them. All but a few per
// cent of the light then has k photons to an estimate, and what lies in the dim places between is blurred no wider than
// that.
constexpr size_t kProbes = 512;
constexpr double kLitShare = 0.95;
constexpr float kRadiusFactor = 2;

float radius_by_density(const PointTree& photons, size_t k) {
    std::vector<float> radii;
    std::vector<NearPoint> found;
    const size_t n = photons.size(), probes = std::min(n, kProbes);
    for (size_t i = 0; i < probes; ++i) {
        const Vec3 p = photons.position(i * n / probes);
        find_nearest(
            photons, p, k, kInfinity, [](uint32_t, float) { return true; }, found);
        radii.push_back(std::sqrt(found.front().distance2));
    }
    const auto rank = radii.begin() + ptrdiff_t(kLitShare * double(probes));
    std::nth_element(radii.begin(), rank, radii.end());
    return kRadiusFactor * *rank;
}

}  // namespace

float largest_coordinate(const PointTree& points) {
    float largest = 0;
    for (const auto* floats : {&points.x, &points.y, &points.z})
        for (const float v : *floats) largest = glm::max(largest, std::abs(v));
    return largest;
}

RadiusBounds radius_bounds(const PointTree& photons, const PhotonOptions& options, float farthest) {
    if (photons.empty()) return {};
    constexpr float kLeastUlps = 64 * std::numeric_limits<float>::epsilon();
    constexpr float kLeast = 1e-18f;  // squares of it are floats
    const float least = glm::max(kLeastUlps * glm::max(farthest, largest_coordinate(photons)), kLeast);
    const float largest = options.radius > 0 ? options.radius : radius_by_density(photons, size_t(options.nearest) + 1);
    return {least, glm::max(least, largest)};
}

}  // namespace tress
