// SPDX-License-Identifier: MIT
#include "gather/projection/projected_light.h"

#include <algorithm>

#include "core/rng.h"
#include "gather/connection.h"
#include "gather/projection/viewpoints.h"
#include "gather/streams.h"

namespace tress {
namespace {

constexpr uint32_t kScatteringDimension = 0, kSkyDimension = kSobolGroup, kChoiceDimension = 2 * kSobolGroup;

/// Of the chance of a direction to become a ray: by what its cell lets through; the rest is even, for directions whose
/// cells are dark because of hair behind a polygon.
constexpr float kByTransmittance = 0.8f;

/// Where a ray is inside a box: [enter, exit]; empty where it misses.
struct Passage {
    float enter = kInfinity, exit = -kInfinity;
};

Passage passage(const Bounds& box, const Vec3& origin, const Vec3& direction) {
    float enter = 0, exit = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1 / direction[axis];
        const float a = (box.lo[axis] - origin[axis]) * inverse, b = (box.hi[axis] - origin[axis]) * inverse;
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return enter <= exit ? Passage{enter, exit} : Passage{};
}

/// Farther from the hair than it is wide: it covers little of what the point sees.
bool is_far(const Bounds& hair, const ShadingPoint& point) {
    if (point.fiber != kPolygon) return false;
    const Vec3 off = max(max(hair.lo - point.position, point.position - hair.hi), Vec3(0));
    return length(off) > 0.5f * max_component(hair.extent());
}

Rgb sky_radiance(const PreparedScene& prepared, const Plan& plan, const Vec3& direction) {
    Rgb sum(0);
    for (const uint32_t light : plan.environments) sum += radiance(*prepared.environment[light], direction);
    return sum;
}

}  // namespace

void ProjectedRays::clear() {
    rays.clear();
    point.clear();
    weight.clear();
    transmittance.clear();
    sky_share.clear();
}

void ProjectedLight::operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                                const Options& options, std::span<const ShadingPoint> points,
                                std::span<const Sampler> samplers, std::span<Rgb> radiance) {
    Context c{scene, prepared, plan, options, nullptr};
    for (const uint32_t light : plan.environments)
        if (!prepared.environment[light]->image.empty()) c.sky = &*prepared.environment[light];
    rays_.clear();
    far_.clear();
    sky_rays_.clear();
    sky_point_.clear();
    sky_radiance_.clear();
    for (uint32_t row = 0; row < points.size(); ++row) {
        if (is_far(prepared.projection.bounds, points[row]))
            far_.push_back(row);
        else
            project_point(c, points[row], row, stream_of(samplers[row], Stream::projection), radiance[row]);
    }
    receive(c, radiance);
    by_rays(c, points, samplers, radiance);
}

void ProjectedLight::project_point(const Context& c, const ShadingPoint& point, uint32_t row, const Sampler& sampler,
                                   Rgb& radiance) {
    const Viewpoint from = viewpoint_of(point, hash(sampler.key, sampler.index));
    project(c.prepared.projection, c.prepared.segments, from, unseen_from(point), c.options.isa, scratch_, cells_);
    draw_candidates(c, point, from, sampler);
    if (c.sky) add_bright_sky(c, point, from, sampler, row, radiance);
    if (!c.prepared.mesh.empty()) return send_rays(c, point, row, sampler.get(kChoiceDimension));
    for (const Candidate& candidate : candidates_)
        radiance += candidate.weight * candidate.transmittance * candidate.sky_share *
                    sky_radiance(c.prepared, c.plan, candidate.direction);
}

void ProjectedLight::draw_candidates(const Context& c, const ShadingPoint& point, const Viewpoint& from,
                                     const Sampler& sampler) {
    const uint32_t count = uint32_t(c.options.projection.directions);
    const float bright_share = float(c.bright_directions()) / float(count);
    candidates_.clear();
    for (uint32_t j = 0; j < count; ++j) {
        const Sampler own{sampler.key, sampler.index * count + j};
        const ScatteredDirection drawn = draw_scattering(c.scene, point, own.get4(kScatteringDimension));
        const float pdf = drawn.scattering.pdf;
        const Rgb weight = drawn.scattering.value() / (pdf * float(count));
        if (!is_finite(weight) || !(max_component(weight) > 0)) continue;
        const uint32_t cell = cell_of(c.prepared.projection.igloo, from.frame.to_local(drawn.direction));
        if (cell >= cells_.cells) continue;  // below a polygon's horizon, by rounding
        const float by_sky = c.sky ? bright_share * pdf_environment(*c.sky, drawn.direction) : 0;
        candidates_.push_back({drawn.direction, weight, cells_.transmittance(cell), pdf / (pdf + by_sky)});
    }
}

void ProjectedLight::add_bright_sky(const Context& c, const ShadingPoint& point, const Viewpoint& from,
                                    const Sampler& sampler, uint32_t row, Rgb& radiance) {
    const uint32_t count = c.bright_directions();
    const float drawn_by_scattering = float(c.options.projection.directions);
    for (uint32_t j = 0; j < count; ++j) {
        const Sampler own{sampler.key, sampler.index * count + j};
        const EnvironmentSample bright = sample_environment(*c.sky, own.get2(kSkyDimension));
        if (!(bright.pdf > 0)) continue;
        const uint32_t cell = cell_of(c.prepared.projection.igloo, from.frame.to_local(bright.direction));
        if (cell >= cells_.cells) continue;
        const Scattering scattered = scatter(c.scene, point, bright.direction);
        const float density = float(count) * bright.pdf + drawn_by_scattering * scattered.pdf;
        const Rgb light = bounded(scattered.value() * sky_radiance(c.prepared, c.plan, bright.direction) *
                                  cells_.transmittance(cell) / density);
        if (!is_finite(light) || !(max_component(light) > 0)) continue;
        if (c.prepared.mesh.empty()) {
            radiance += light;
            continue;
        }
        sky_rays_.add(point.position, bright.direction, kInfinity, point.excluded);
        sky_point_.push_back(row);
        sky_radiance_.push_back(light);
    }
}

/// Systematic resampling: one number for all rays, which are spread evenly over the sum of the chances.
void ProjectedLight::send_rays(const Context& c, const ShadingPoint& point, uint32_t row, float u) {
    const float count = float(c.options.projection.rays);
    float open = 0, all = 0;
    for (const Candidate& candidate : candidates_) {
        open += luminance(candidate.weight * candidate.transmittance);
        all += luminance(candidate.weight);
    }
    if (!(all > 0)) return;
    const float even = 1 / all * (open > 0 ? 1 - kByTransmittance : 1);
    const float by_open = open > 0 ? kByTransmittance / open : 0;
    float place = -u;
    for (const Candidate& candidate : candidates_) {
        const float chance =
            even * luminance(candidate.weight) + by_open * luminance(candidate.weight * candidate.transmittance);
        place += count * chance;
        if (!(place > 0)) continue;
        const float rays = std::ceil(place);
        place -= rays;
        rays_.rays.add(point.position, candidate.direction, kInfinity, point.excluded);
        rays_.point.push_back(row);
        rays_.weight.push_back(candidate.weight * (rays / (count * chance)));
        rays_.transmittance.push_back(candidate.transmittance);
        rays_.sky_share.push_back(candidate.sky_share);
    }
}

void ProjectedLight::receive(const Context& c, std::span<Rgb> radiance) {
    const size_t n = rays_.size();
    if (c.prepared.mesh.empty()) return;
    for (auto* floats : {&rays_.t, &rays_.u, &rays_.v}) floats->assign(n, kInfinity);
    rays_.polygon.assign(n, kNone);
    nearest_triangle(c.prepared.mesh, rays_.rays.for_mesh(), {rays_.t, rays_.polygon, rays_.u, rays_.v}, c.options.isa);
    short_rays_.clear();
    short_row_.clear();
    for (uint32_t i = 0; i < n; ++i) {
        const Vec3 direction = rays_.rays.direction(i), origin = rays_.rays.origin(i);
        if (rays_.polygon[i] == kNone) {
            radiance[rays_.point[i]] += rays_.weight[i] * rays_.transmittance[i] * rays_.sky_share[i] *
                                        sky_radiance(c.prepared, c.plan, direction);
            continue;
        }
        if (!c.plan.polygon_gather) continue;
        rays_.weight[i] *= polygon_radiance(c.scene, c.prepared.photons.irradiance, rays_.polygon[i],
                                            origin + rays_.t[i] * direction, direction);
        if (!(max_component(rays_.weight[i]) > 0)) continue;
        const Passage hair = passage(c.prepared.projection.bounds, origin, direction);
        if (rays_.t[i] <= hair.enter || rays_.t[i] >= hair.exit) {
            const bool before = rays_.t[i] <= hair.enter;
            radiance[rays_.point[i]] += rays_.weight[i] * (before ? Rgb(1) : rays_.transmittance[i]);
            continue;
        }
        short_rays_.add_from(rays_.rays, i);
        short_rays_.set_far(short_row_.size(), rays_.t[i]);
        short_row_.push_back(i);
    }
    short_through_.resize(short_row_.size());
    through_hair(c.prepared, short_rays_, c.options, short_through_);
    for (size_t i = 0; i < short_row_.size(); ++i)
        radiance[rays_.point[short_row_[i]]] += rays_.weight[short_row_[i]] * short_through_[i];

    occluded_.assign(sky_point_.size(), 0);
    occluded_triangle(c.prepared.mesh, sky_rays_.for_mesh(), occluded_, c.options.isa);
    for (size_t i = 0; i < sky_point_.size(); ++i)
        if (!occluded_[i]) radiance[sky_point_[i]] += sky_radiance_[i];
}

void ProjectedLight::by_rays(const Context& c, std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                             std::span<Rgb> radiance) {
    if (far_.empty()) return;
    far_points_.clear();
    far_samplers_.clear();
    for (const uint32_t row : far_) {
        far_points_.push_back(points[row]);
        far_samplers_.push_back(samplers[row]);
    }
    far_radiance_.assign(far_.size(), Rgb(0));
    Options options = c.options;
    options.gather.rays = options.projection.rays;
    far_sky_(c.scene, c.prepared, options, c.plan.environments, nullptr, far_points_, far_samplers_, far_radiance_);
    if (c.plan.polygon_gather) {
        make_gather_rays(c.scene, c.prepared, options, far_points_, far_samplers_, far_rays_);
        far_polygons_(c.scene, c.prepared, options, far_rays_, far_radiance_);
    }
    for (size_t i = 0; i < far_.size(); ++i) radiance[far_[i]] += far_radiance_[i];
}

}  // namespace tress
