// SPDX-License-Identifier: MIT
#include "gather/tree_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/light_reach.h"
#include "core/rng.h"
#include "gather/camera_points.h"
#include "gather/gather_rays.h"
#include "gather/light_rays.h"
#include "gather/visibility.h"

namespace tress {
namespace {

constexpr size_t kMostWays = 16;  // from one point towards one light, and of gather rays: more would be much alike

/// Of the i-th of `all`: exactly `kept` of them are, evenly.
bool is_kept(size_t i, size_t all, size_t kept) { return i * kept / all != (i + 1) * kept / all; }

/// Bits of x and y in turn: numbers next to each other are tiles near each other (Morton order).
uint64_t morton(uint32_t x, uint32_t y) {
    uint64_t code = 0;
    for (uint32_t bit = 0; bit < 32; ++bit)
        code |= uint64_t(x >> bit & 1) << (2 * bit) | uint64_t(y >> bit & 1) << (2 * bit + 1);
    return code;
}

/// Some tiles of the picture, spread evenly over it; ascending.
std::vector<int> some_tiles(const Camera& camera, size_t count, uint64_t seed) {
    std::vector<std::pair<uint64_t, int>> all;
    for (int i = 0; i < tile_count(camera); ++i) {
        const Tile tile = tile_of(camera, i);
        all.push_back({morton(uint32_t(tile.x0 / kTileSize), uint32_t(tile.y0 / kTileSize)), i});
    }
    std::sort(all.begin(), all.end());
    const double start = double(random(hash(seed, 0), 0)), step = double(all.size()) / double(count);
    std::vector<int> tiles;
    for (size_t k = 0; k < count; ++k)
        tiles.push_back(all[std::min(size_t((double(k) + start) * step), all.size() - 1)].second);
    std::sort(tiles.begin(), tiles.end());
    return tiles;
}

/// Which tiles, and how many samples of their pixels, give some more than `most` rays.
struct Sampling {
    std::vector<int> tiles;
    uint32_t samples;
};
Sampling sampling_for(const Camera& camera, uint64_t seed, size_t most) {
    const size_t tiles = size_t(tile_count(camera)), pixels = size_t(camera.width) * size_t(camera.height);
    const auto ceil_of = [](size_t a, size_t b) { return (a + b - 1) / b; };
    return {some_tiles(camera, std::min(tiles, ceil_of(most * tiles, pixels)), seed), uint32_t(ceil_of(most, pixels))};
}

/// One sample of a tile: its camera rays, and the points of hair that they see.
struct TileSample {
    RayBuffer primary;
    std::vector<ShadingPoint> points;
    std::vector<Sampler> samplers;

    void add(const ShadingPoint& point, const Sampler& sampler) {
        points.push_back(point);
        samplers.push_back(sampler);
    }
};

/// How the rays of a set are shared among points.
struct Share {
    size_t points;      // that rays start from
    uint32_t ways = 1;  // from each, towards each light
};
Share share_of(size_t points, size_t lights, size_t most) {
    if (points == 0 || lights == 0) return {0};
    const size_t used = std::min(points, std::max<size_t>(most / lights, 1));
    return {used, uint32_t(std::clamp<size_t>(most / (used * lights), 1, kMostWays))};
}

void append(const RayBuffer& from, RayBuffer& to) {
    for (size_t ray = 0; ray < from.size(); ++ray) to.add_from(from, ray);
}

class RayMaker {
public:
    RayMaker(const Scene& scene, const Plan& plan, const PreparedScene& prepared, const Options& options, size_t most)
        : scene_(scene), prepared_(prepared), options_(options), most_(most) {
        lights_ = plan.lamps.empty() ? plan.environments : plan.lamps;
        const Sampling sampling = sampling_for(scene.camera, options.seed, most);
        samples_.resize(sampling.tiles.size() * sampling.samples);
        tbb::parallel_for(size_t(0), samples_.size(), [&](size_t i) {
            samples_[i] = look(sampling.tiles[i / sampling.samples], uint32_t(i % sampling.samples));
        });
        first_point_.push_back(0);
        for (const TileSample& s : samples_) first_point_.push_back(first_point_.back() + s.points.size());
    }

    RayBuffer primary() const {
        size_t all = 0, i = 0;
        for (const TileSample& s : samples_) all += s.primary.size();
        const size_t kept = std::min(all, most_);
        RayBuffer rays;
        for (const TileSample& s : samples_)
            for (size_t ray = 0; ray < s.primary.size(); ++ray)
                if (is_kept(i++, all, kept)) rays.add_from(s.primary, ray);
        return rays;
    }

    RayBuffer shadow() const {
        return from_points(lights_.size(), [&](const TileSample& from, uint32_t ways, RayBuffer& to) {
            LightRays drawn;
            OpenRays open;
            for (const uint32_t light : lights_) {
                make_light_rays(scene_, prepared_, light, ways, from.points, from.samplers, drawn);
                find_open_rays(prepared_, drawn.to.rays, options_.isa, open);
                append(open.rays, to);
            }
        });
    }

    RayBuffer gather() const {
        return from_points(1, [&](const TileSample& from, uint32_t ways, RayBuffer& to) {
            Options options = options_;
            options.gather.rays = int(ways);
            GatherRays drawn;
            make_gather_rays(scene_, prepared_, options, from.points, from.samplers, drawn);
            append(drawn.rays, to);
        });
    }

private:
    TileSample look(int tile, uint32_t sample) const {
        TileSample made;
        CameraPoints seen;
        make_camera_rays(scene_, camera_frame(scene_.camera), options_, tile_of(scene_.camera, tile), sample, seen);
        made.primary = seen.rays;  // before they are cut to what they hit
        find_nearest(prepared_, options_.isa, seen.rays, seen.hits);
        make_points(scene_, prepared_, seen);
        for (size_t i = 0; i < seen.points.size(); ++i)
            if (seen.points[i].fiber != kPolygon) made.add(seen.points[i], seen.point_samplers[i]);
        return made;
    }

    /// Calls draw(points, ways, to) for each sample of a tile with the points that are kept; all rays in order.
    template <class Draw>
    RayBuffer from_points(size_t lights, const Draw& draw) const {
        const size_t all = first_point_.back();
        const Share share = share_of(all, lights, most_);
        RayBuffer rays;
        if (share.points == 0) return rays;
        std::vector<RayBuffer> parts(samples_.size());
        tbb::parallel_for(size_t(0), samples_.size(), [&](size_t k) {
            const TileSample& s = samples_[k];
            TileSample kept;
            for (size_t i = 0; i < s.points.size(); ++i)
                if (is_kept(first_point_[k] + i, all, share.points)) kept.add(s.points[i], s.samplers[i]);
            draw(kept, share.ways, parts[k]);
        });
        for (const RayBuffer& part : parts) append(part, rays);
        return rays;
    }

    const Scene& scene_;
    const PreparedScene& prepared_;
    const Options& options_;
    size_t most_;
    std::vector<uint32_t> lights_;
    std::vector<TileSample> samples_;
    std::vector<size_t> first_point_;  // of each sample of a tile, and all
};

}  // namespace

Plan plan_tree_rays(const Scene& scene) {
    Plan plan;
    plan.hair_tree = !scene.segments.point.empty();
    plan.mesh_tree = scene.mesh.triangles() > 0;
    for (uint32_t i = 0; i < scene.lights.size(); ++i) {
        if (!why_unseen(scene.lights[i], scene.bounds).empty()) continue;
        const bool environment = std::holds_alternative<EnvironmentLight>(scene.lights[i]);
        (environment ? plan.environments : plan.lamps).push_back(i);
    }
    if (!plan.lamps.empty()) plan.environments.clear();
    return plan;
}

std::vector<TreeRays> make_tree_rays(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                                     const Options& options, size_t most) {
    const RayMaker make(scene, plan, prepared, options, most);
    return {{"primary", HairQuery::nearest, make.primary()},
            {"shadow", HairQuery::transmittance, make.shadow()},
            {"gather", HairQuery::transmittance, make.gather()}};
}

}  // namespace tress
