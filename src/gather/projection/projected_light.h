// SPDX-License-Identifier: MIT
// Light of Type 2 by projection: hair is projected onto cells about a point, and light is seen through them.
//
// Directions are drawn by the scattering at the point, so that lobes narrower than a cell are sampled inside it, and
// each is weighted with what hair leaves in its cell: no ray through hair. Where there are polygons, a few of the
// directions, drawn in proportion to what they may bring, go on as rays against polygons alone. A ray that ends on a
// polygon before it is past all hair cannot use its cell, which holds the hair behind the polygon too: what little lies
// before is asked of the hair tree. So nothing leaks through polygons, and cells need not know how far away they are.
#pragma once

#include <span>
#include <vector>

#include "core/plan.h"
#include "gather/direct_light.h"
#include "gather/polygon_light.h"
#include "gather/projection/hair_projection.h"

namespace tress {

/// Rays that leave points towards polygons or the sky. Rows belong together by index.
struct ProjectedRays {
    RayBuffer rays;
    std::vector<uint32_t> point;
    std::vector<Rgb> weight;         // of radiance that comes along the ray, but for hair
    std::vector<Rgb> transmittance;  // of the cell: of all hair along the ray
    std::vector<float> sky_share;    // of the sky's radiance that the ray may count (multiple importance sampling)
    std::vector<float> t, u, v;      // where it meets a polygon
    std::vector<uint32_t> polygon;   // kNone: none

    size_t size() const { return rays.size(); }
    void clear();
};

class ProjectedLight {
public:
    /// Adds to radiance[i] the light that points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                    std::span<const ShadingPoint> points, std::span<const Sampler> samplers, std::span<Rgb> radiance);

private:
    /// A direction that light may come from.
    struct Candidate {
        Vec3 direction;
        Rgb weight;         // f |cos| / density / their number
        Rgb transmittance;  // of its cell
        float sky_share;
    };
    struct Context {
        const Scene& scene;
        const PreparedScene& prepared;
        const Plan& plan;
        const Options& options;
        const EnvironmentSampler* sky;  // the one that is sampled by brightness; null: none has a picture

        /// Of the sky, a point.
        uint32_t bright_directions() const { return sky ? uint32_t(options.projection.directions + 1) / 2 : 0; }
    };

    void project_point(const Context& c, const ShadingPoint& point, uint32_t row, const Sampler& sampler,
                       Rgb& radiance);
    void draw_candidates(const Context& c, const ShadingPoint& point, const Viewpoint& from, const Sampler& sampler);
    void add_bright_sky(const Context& c, const ShadingPoint& point, const Viewpoint& from, const Sampler& sampler,
                        uint32_t row, Rgb& radiance);
    void send_rays(const Context& c, const ShadingPoint& point, uint32_t row, float u);
    void receive(const Context& c, std::span<Rgb> radiance);
    void by_rays(const Context& c, std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                 std::span<Rgb> radiance);

    ProjectionScratch scratch_;
    CellLight cells_;
    std::vector<Candidate> candidates_;
    ProjectedRays rays_;
    RayBuffer short_rays_;  // through hair, up to a polygon within it
    std::vector<uint32_t> short_row_;
    std::vector<Rgb> short_through_;
    RayBuffer sky_rays_;  // towards bright parts of the sky, against polygons
    std::vector<uint32_t> sky_point_;
    std::vector<Rgb> sky_radiance_;
    std::vector<uint8_t> occluded_;

    std::vector<uint32_t> far_;  // points so far from the hair that rays, most of which miss it, are better
    std::vector<ShadingPoint> far_points_;
    std::vector<Sampler> far_samplers_;
    std::vector<Rgb> far_radiance_;
    DirectLight far_sky_;
    GatherRays far_rays_;
    PolygonLight far_polygons_;
};

}  // namespace tress
