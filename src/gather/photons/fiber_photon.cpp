// SPDX-License-Identifier: MIT
#include "gather/photons/fiber_photon.h"

#include "core/sampling.h"
#include "gather/reservoir.h"

namespace tress {
namespace {

/// Ways out of which one is kept. Reflection varies from hundredths in the middle of a fiber to all at its edges, and
/// with the inclination to which light leaves: with one alone few photons would carry most of the power.
constexpr uint32_t kByLobes = 4, kCandidates = kByLobes + 1;  // the last all round, for what the lobes hardly draw

/// Below this |cos theta_i| the cosine by which f |cos theta_i| is divided stays: less than its square of all light
/// that meets a fiber comes that near to its tangent.
constexpr float kLeastCosine = 1e-3f;

float cos_to_normal_plane(const Vec3& local) { return safe_sqrt(1 - local.x * local.x); }

/// One of what is offered, in proportion to what it brings.
class Choice {
public:
    explicit Choice(float u) : reservoir_(u) {}

    void offer(const LeavingPhoton& photon, float brings) {
        if (!(brings > 0 && std::isfinite(brings)) || !reservoir_.offer(brings)) return;
        kept_ = photon;
        kept_brings_ = brings;
    }
    /// Weighed for all that was offered.
    LeavingPhoton kept() const {
        LeavingPhoton photon = kept_;
        if (kept_brings_ > 0) photon.weight *= reservoir_.sum() / kept_brings_;
        return photon;
    }

private:
    Reservoir reservoir_;
    float kept_brings_ = 0;
    LeavingPhoton kept_;
};

}  // namespace

/// f is not reciprocal: wo is drawn as if the fiber were seen from wi, then weighed by f_R(wi, wo) as it is. Offsets
/// change sides, as where a ray is reflected: -h as seen from wi is h as seen from wo. Of these, spread over h, and one
/// all round, each is weighed by the sum of densities (balance heuristic: Veach 1997, ch. 9): where the tilt of the
/// scales turns a direction past the tangent, both ways of seeing the fiber differ much.
LeavingPhoton scatter_photon(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wi, const Rgb& color,
                             const Sampler& sampler, uint32_t dimension) {
    const float cos_i = glm::max(cos_to_normal_plane(wi), kLeastCosine);
    Choice choice(sampler.get(dimension + kSobolGroup));
    const auto offer = [&](const Vec3& wo, float h, float pdf) {
        const Rgb f_cos_i = evaluate(fiber, sigma_a, wo, wi, h).reflected;
        const float density = kByLobes * pdf + pdf_uniform_sphere();
        const LeavingPhoton photon{wo, h, f_cos_i * (cos_to_normal_plane(wo) / (cos_i * density))};
        choice.offer(photon, max_component(color * photon.weight));
    };
    const auto numbers = [&](uint32_t candidate) {
        return Sampler{sampler.key, sampler.index * kCandidates + candidate}.get4(dimension);
    };
    const float offset = sampler.get(dimension + kSobolGroup + 1);
    for (uint32_t i = 0; i < kByLobes; ++i) {
        const float h = 2 * (float(i) + offset) / kByLobes - 1;
        const FiberSample drawn = sample(fiber, sigma_a, wi, -h, numbers(i), FiberLobes::reflected);
        if (drawn.pdf > 0) offer(drawn.wi, h, drawn.pdf);
    }
    const glm::vec4 u = numbers(kByLobes);
    const Vec3 any = sample_uniform_sphere({u.x, u.y});
    const float h = 2 * u.z - 1;
    offer(any, h, evaluate_with_pdf(fiber, sigma_a, wi, any, -h, FiberLobes::reflected).pdf);
    return choice.kept();
}

}  // namespace tress
