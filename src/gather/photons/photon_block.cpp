// SPDX-License-Identifier: MIT
#include "gather/photons/photon_block.h"

#include "core/sampling.h"
#include "gather/photons/fiber_photon.h"
#include "gather/shading_point.h"

namespace tress {
namespace {

/// Chance of going on at most: light that nothing absorbs, as in a closed white room, must end too.
constexpr float kMostSurvival = 0.99f;

/// Dimensions: three groups a ray, after that of the start.
struct Dimensions {
    uint32_t flight, scattering;

    explicit Dimensions(uint32_t rays)
        : flight(kSobolGroup * (1 + 3 * rays)), scattering(kSobolGroup * (2 + 3 * rays)) {}
};

}  // namespace

void PhotonBlock::start(const PhotonRange& range) {
    const uint64_t key = photon_key(c_.options.seed);
    for (uint32_t i = range.first; i < range.last; ++i) {
        const Sampler sampler{key, i};
        const StartingPhoton from = start_photon(c_.source, c_.scene, c_.prepared, sampler);
        LightPhotons& figures = out_->statistics.lights[from.share];
        ++figures.emitted;
        const Emission& e = from.emission;
        if (!(max_component(e.power) > 0)) continue;
        figures.power += double(luminance(e.power));
        photons_.push_back({sampler, e.power, from.share, from.source, 0, 0, false});
        rays_.add(e.position, e.direction, kInfinity, {});
    }
}

void PhotonBlock::advance() {
    trace();
    next_photons_.clear();
    next_rays_.clear();
    for (size_t row = 0; row < photons_.size(); ++row)
        if (!ends_in_hair(row) && polygon_id_[row] != kNone) arrive_at_polygon(photons_[row], row);
    std::swap(photons_, next_photons_);
    std::swap(rays_, next_rays_);
}

/// Polygons first; hair then only up to them, and no farther than the first crossing that the photon does not get past.
void PhotonBlock::trace() {
    const size_t n = rays_.size();
    for (auto* floats : {&polygon_t_, &polygon_u_, &polygon_v_}) floats->resize(n);
    polygon_id_.assign(n, kNone);
    if (!c_.prepared.mesh.empty()) {
        nearest_triangle(c_.prepared.mesh, rays_.for_mesh(), {polygon_t_, polygon_id_, polygon_u_, polygon_v_},
                         c_.options.isa);
        for (size_t row = 0; row < n; ++row) rays_.set_far(row, polygon_t_[row]);
    }
    if (c_.prepared.hair.empty()) return;
    cutoff_.resize(n);
    for (size_t row = 0; row < n; ++row)
        cutoff_[row] = 1 - photons_[row].sampler.get(Dimensions(photons_[row].rays).flight);  // in (0, 1]
    flights(c_.prepared.hair, rays_.for_hair(), c_.prepared.attenuation, cutoff_, flights_, c_.options.isa);
}

/// The chance of getting past crossing k is P(k), the largest component of the transmittance with it: the photon is
/// stopped at the first with P(k) below a uniform number, thus with chance P(k - 1) - P(k) there.
bool PhotonBlock::ends_in_hair(size_t row) {
    if (c_.prepared.hair.empty()) return false;
    const size_t first = flights_.crossings.first[row], end = flights_.crossings.first[row + 1];
    for (size_t k = first; k < end; ++k) arrive_at_fiber(photons_[row], row, k);
    if (first == end) return false;
    const float past = max_component(flights_.after[end - 1]);
    if (!(past < cutoff_[row])) return false;
    scatter_at_fiber(photons_[row], row, end - 1, max_component(flights_.before[end - 1]) - past);
    return true;
}

/// What gets as far as a crossing by roulette has V / P of its power there.
void PhotonBlock::arrive_at_fiber(Photon& photon, size_t row, size_t k) {
    const Rgb& before = flights_.before[k];
    const Rgb power = photon.power * (before / max_component(before));
    CrossingShare& share = out_->statistics.hair_at(photon.source, photon.reflections);
    ++share.crossings;
    share.power += double(luminance(power));
    if (!photon.met_hair) ++out_->statistics.lights[photon.light].met_hair;
    photon.met_hair = true;

    const PathType type = path_type(photon.source, photon.reflections);
    if (!c_.plan.photon_display[size_t(index_of(type))]) return;
    const SegmentView& segments = c_.prepared.segments;
    const uint32_t segment = flights_.crossings.id[k];
    const Vec3 start = segments.start(segment), end = segments.end(segment), direction = rays_.direction(row);
    const Vec3 on_axis = mix(start, end, flights_.crossings.u[k]), tangent(normalize(DVec3(end) - DVec3(start)));
    const float cosine = safe_sqrt(1 - square(dot(direction, tangent)));
    add(out_->in_hair, {on_axis, direction, power, type}, cosine);
}

void PhotonBlock::scatter_at_fiber(Photon photon, size_t row, size_t k, float chance) {
    const Crossings& c = flights_.crossings;
    const ShadingPoint point =
        fiber_point(c_.scene, c_.prepared, rays_.direction(row), {c.t[k], c.id[k], c.u[k], c.h[k]});
    const Rgb event = flights_.before[k] / chance;
    const LeavingPhoton out = scatter_photon(c_.scene.fibers[point.fiber], point.color, point.wo, photon.power * event,
                                             photon.sampler, Dimensions(photon.rays).scattering);
    if (!(max_component(out.weight) > 0)) return;
    const Vec3 leaving = point.frame.to_world(out.wo);
    const Vec3 origin = fiber_point(c_.scene, c_.prepared, -leaving, {c.t[k], c.id[k], c.u[k], out.h}).position;
    ++photon.reflections;
    go_on(photon, event * out.weight, origin, leaving, point.excluded);
}

void PhotonBlock::arrive_at_polygon(Photon photon, size_t row) {
    const Vec3 direction = rays_.direction(row);
    // It got there with chance P, which hair up to here has made of V: the last of its crossings tells.
    if (!c_.prepared.hair.empty()) {
        const size_t first = flights_.crossings.first[row], end = flights_.crossings.first[row + 1];
        if (first < end) photon.power *= flights_.after[end - 1] / max_component(flights_.after[end - 1]);
    }
    const ShadingPoint point =
        polygon_point(c_.scene, direction, {polygon_t_[row], polygon_id_[row], polygon_u_[row], polygon_v_[row]});
    const PathType type = path_type(photon.source, photon.reflections);
    if (c_.plan.polygon_gather || c_.plan.photon_display[size_t(index_of(type))]) {
        add(out_->on_polygons, {point.on_surface, direction, photon.power, type}, point.geometric_normal);
        ++out_->statistics.lights[photon.light].on_polygons;
    }
    // From here on light is of Type 2 or 5 wherever it gets.
    if (!c_.plan.polygon_gather && !c_.plan.photon_display[index_of(PathType::type5)]) return;
    const Vec2 u(photon.sampler.get2(Dimensions(photon.rays).scattering));
    const Vec3 leaving = frame_about(point.geometric_normal).to_world(sample_cosine_hemisphere(u));
    photon.source = LightSource::elsewhere;
    photon.reflections = 0;
    go_on(photon, point.color, point.position, leaving, point.excluded);
}

/// Roulette on what is left of the largest component of its power, so that powers stay near equal.
void PhotonBlock::go_on(Photon photon, const Rgb& weight, const Vec3& origin, const Vec3& direction,
                        const Excluded& excluded) {
    const Rgb left = photon.power * weight;
    const float survival = glm::min(max_component(left) / max_component(photon.power), kMostSurvival);
    const float u = photon.sampler.get(Dimensions(photon.rays).flight + 1);
    if (!(u < survival)) return;
    photon.power = min(left / survival, Rgb(kLargestPower));
    ++photon.rays;
    next_photons_.push_back(photon);
    next_rays_.add(origin, direction, kInfinity, excluded);
}

}  // namespace tress
