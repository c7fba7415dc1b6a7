// SPDX-License-Identifier: MIT
#include "gather/photons/photon_display.h"

#include "core/light_sample.h"

namespace tress {

void PhotonDisplay::show_on_fiber(const Scene& scene, const HairPhotons& photons, const ShadingPoint& point,
                                  LightByType& light) {
    hair_(photons, point.position);
    const std::span<const HairSearch::Beam> beams = hair_.found();
    wi_.clear();
    for (const HairSearch::Beam& beam : beams) wi_.push_back(point.frame.to_local(-photons.direction[beam.place]));
    scattered_.resize(wi_.size());
    evaluate(scene.fibers[point.fiber], point.color, point.wo, point.h, wi_, scattered_);
    const float forward = point.lobes == FiberLobes::all ? 1 : 0;
    for (size_t i = 0; i < wi_.size(); ++i)
        light[photons.type[beams[i].place]] +=
            min((scattered_[i].reflected + forward * scattered_[i].forward) * beams[i].light, Rgb(kLargestIrradiance));
}

void PhotonDisplay::show_on_polygons(const Scene& scene, const PreparedScene& prepared, const Options& options,
                                     std::span<const ShadingPoint> points, std::span<LightByType> light) {
    const PolygonPhotons& photons = prepared.photons.shown.polygons;
    surface_.clear();
    irradiance_.clear();
    radius_.clear();
    for (const uint32_t i : on_polygon_) {
        surface_.push_back(surface_point(points[i].on_surface, points[i].geometric_normal));
        disc_(photons, surface_.back());
        irradiance_.push_back(disc_.irradiance(photons));
        radius_.push_back(disc_.radius());
    }
    share_.resize(surface_.size());
    coverage_(prepared.mesh, scene.mesh, options.isa, surface_, radius_, share_);
    for (size_t p = 0; p < on_polygon_.size(); ++p) {
        const uint32_t i = on_polygon_[p];
        for (size_t type = 0; type < kPathTypes; ++type)
            light[i][type] +=
                min(points[i].color * (kInvPi / share_[p]) * irradiance_[p][type], Rgb(kLargestIrradiance));
    }
}

void PhotonDisplay::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                               std::span<const ShadingPoint> points, std::span<LightByType> light) {
    const ShownPhotons& photons = prepared.photons.shown;
    on_polygon_.clear();
    for (uint32_t i = 0; i < points.size(); ++i) {
        if (points[i].fiber == kPolygon) {
            if (photons.polygons.size() > 0) on_polygon_.push_back(i);
        } else if (!photons.hair.tree.empty()) {
            show_on_fiber(scene, photons.hair, points[i], light[i]);
        }
    }
    if (!on_polygon_.empty()) show_on_polygons(scene, prepared, options, points, light);
}

}  // namespace tress
