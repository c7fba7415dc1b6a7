// SPDX-License-Identifier: MIT
// Photons in hair, and points spread evenly over the hair, which tell how much of it lies about a point: photons shown
// by their own density among such points are as bright in a thin lock as in a dense one. Photons meet a fiber in
// proportion to cos theta_i; with that divided out, each speaks for the light about it, whatever way its fiber ran.
#pragma once

#include "core/segments.h"
#include "gather/photons/photon_kernel.h"
#include "gather/photons/photon_list.h"

namespace tress {

/// In the order of their trees.
struct HairPhotons {
    PointTree tree;
    std::vector<Vec3> direction;  // of travel
    std::vector<Rgb> power;       // W, over cos theta_i where it arrived
    std::vector<uint8_t> type;
    PointTree area_points;
    float area = 0;  // of hair (diameter x length) that each of area_points stands for
    RadiusBounds radius;
    size_t nearest = 0;  // that an estimate takes
};

/// The given rows of `list`.
HairPhotons make_hair_photons(const PhotonList& list, std::span<const uint32_t> rows, const SegmentView& segments,
                              const PhotonOptions& options);
size_t bytes(const HairPhotons& photons);

/// Photons about a point in hair.
class HairSearch {
public:
    void operator()(const HairPhotons& photons, const Vec3& about);

    /// Light of one direction at the point, as photons tell it: `light` = power / cos theta_i x cone / integral of the
    /// cone over the hair (diameter x length) about the point, so that what a fiber sends out is the sum of
    /// f |cos theta_i| x light.
    struct Beam {
        uint32_t place;  // in the photons' arrays
        Rgb light;
    };
    std::span<const Beam> found() const { return beams_; }

private:
    std::vector<NearPoint> near_;
    std::vector<Beam> beams_;
};

}  // namespace tress
