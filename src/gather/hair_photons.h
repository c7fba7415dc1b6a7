// SPDX-License-Identifier: MIT
// Photons in hair, and points spread evenly over the hair, which tell how much of it lies about a point: photons shown
// by their own density among such points are as bright in a thin lock as in a dense one.
#pragma once

#include "core/segments.h"
#include "gather/photon_kernel.h"
#include "gather/photon_list.h"

namespace tress {

/// In the order of their trees.
struct HairPhotons {
    PointTree tree;
    std::vector<Vec3> direction;  // of travel
    std::vector<Rgb> power;
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

    /// Places, the same in the photons' arrays, and for each the flux that it brings a fiber at the point, per area
    /// diameter x length: power x cone / integral of the cone over the hair about the point.
    struct Flux {
        uint32_t place;
        Rgb flux;
    };
    std::span<const Flux> found() const { return flux_; }

private:
    std::vector<NearPoint> near_;
    std::vector<Flux> flux_;
};

}  // namespace tress
