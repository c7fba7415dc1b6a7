// SPDX-License-Identifier: MIT
// Some photons followed together, one ray of each after another, until all have ended.
#pragma once

#include <vector>

#include "core/sampler.h"
#include "gather/photons/photon_source.h"
#include "gather/photons/photon_tracing.h"
#include "gather/ray_buffer.h"

namespace tress {

struct PhotonContext {
    const Scene& scene;
    const PreparedScene& prepared;
    const Plan& plan;
    const Options& options;
    const PhotonSource& source;
};

/// Photons [first, last).
struct PhotonRange {
    uint32_t first, last;
};

class PhotonBlock {
public:
    explicit PhotonBlock(const PhotonContext& context) : c_(context) {}

    /// Adds to `out`, and calls on_stored(bytes) as photons are stored.
    template <class OnStored>
    void operator()(const PhotonRange& range, TracedPhotons& out, const OnStored& on_stored) {
        out_ = &out;
        start(range);
        while (!photons_.empty()) {
            const size_t before = stored_bytes();
            advance();
            on_stored(stored_bytes() - before);
        }
    }

private:
    /// A photon on the ray of the same row.
    struct Photon {
        Sampler sampler;
        Rgb power;
        uint32_t light;      // its place in the source
        LightSource source;  // of its light since the last surface
        int reflections;     // R events since then
        uint32_t rays;       // before this one
        bool met_hair;
    };

    size_t stored_bytes() const {
        return out_->on_polygons.size() * kPolygonPhotonBytes + out_->in_hair.size() * kPhotonBytes;
    }
    void start(const PhotonRange& range);
    void advance();
    void trace();
    bool ends_in_hair(size_t row);
    void arrive_at_fiber(Photon& photon, size_t row, size_t crossing);
    void scatter_at_fiber(Photon photon, size_t row, size_t crossing, float chance);
    void arrive_at_polygon(Photon photon, size_t row);
    void go_on(Photon photon, const Rgb& weight, const Vec3& origin, const Vec3& direction, const Excluded& excluded);

    PhotonContext c_;
    TracedPhotons* out_ = nullptr;
    std::vector<Photon> photons_, next_photons_;
    RayBuffer rays_, next_rays_;
    std::vector<float> cutoff_, polygon_t_, polygon_u_, polygon_v_;
    std::vector<uint32_t> polygon_id_;
    Flights flights_;
};

}  // namespace tress
