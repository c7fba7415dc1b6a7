// SPDX-License-Identifier: MIT
// How many gather rays a second the renderer takes through hair, against the hair tree alone on the very same rays.
//     gather_bench [SCENE] [--size N] [--spp N] [--rounds N] [--threads N] [--write PREFIX]
// Timed in turn, a round each: the stages of the pixel loop on tiles, one sample of a pixel after another; then all
// rays in batches of 1024 in the order of the tiles, as `tress trace` reads them, at a constant transmission of 0.7
// and a cutoff of 1e-3 (its defaults), and in colour. --write makes PREFIX.segments and PREFIX.rays for `tress trace`.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "core/builtin_scene.h"
#include "core/error.h"
#include "gather/camera_points.h"
#include "gather/crossing_light.h"
#include "gather/direct_light.h"
#include "gather/gather_rays.h"
#include "gather/render.h"
#include "gather/visibility.h"
#include "io/load_scene.h"
#include "io/scene_file.h"
#include "io/trace_files.h"
#include "tests/bench_support.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr int kTile = 32;        // pixels a side, as in the pixel loop
constexpr size_t kBatch = 1024;  // rays, as in `tress trace`
constexpr float kTransmission = 0.7f, kTraceCutoff = 1e-3f;

struct Arguments {
    std::string scene, write;
    int size = 256, spp = 4, rounds = 7, threads = 0;
};

Arguments read_arguments(int count, char** values) {
    Arguments a;
    a.scene = read_flags(count, values, [&](const std::string& name, const std::string& value) {
        const auto set = [&](const char* known, int& to) {
            if (name == known) to = std::max(std::atoi(value.c_str()), 1);
        };
        set("--size", a.size), set("--spp", a.spp), set("--rounds", a.rounds), set("--threads", a.threads);
        if (name == "--write") a.write = value;
    });
    return a;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// What the eye sees in one tile at one sample.
struct TilePoints {
    std::vector<ShadingPoint> points;
    std::vector<Sampler> samplers;
};

struct Bench {
    const Scene& scene;
    const PreparedScene& prepared;
    const Plan& plan;
    const Options& options;
};

TilePoints tile_points(const Bench& b, int x0, int y0, uint32_t sample) {
    const Camera& camera = b.scene.camera;
    const Tile tile{x0, y0, std::min(x0 + kTile, camera.width), std::min(y0 + kTile, camera.height)};
    CameraPoints seen;
    find_camera_points(b.scene, b.prepared, camera_frame(camera), b.options, tile, sample, seen);
    return {std::move(seen.points), std::move(seen.point_samplers)};
}

std::vector<TilePoints> all_points(const Bench& b, int spp) {
    std::vector<TilePoints> tiles;
    for (int y = 0; y < b.scene.camera.height; y += kTile)
        for (int x = 0; x < b.scene.camera.width; x += kTile)
            for (int s = 0; s < spp; ++s) tiles.push_back(tile_points(b, x, y, uint32_t(s)));
    return tiles;
}

/// Rays of all tiles one after another, as arrays, with what they skip.
struct FlatRays {
    TraceRays rays;
    std::vector<uint32_t> skip_first, skip_last;

    void add(const RayBatch& b) {
        const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
        append(rays.ox, b.ox), append(rays.oy, b.oy), append(rays.oz, b.oz);
        append(rays.dx, b.dx), append(rays.dy, b.dy), append(rays.dz, b.dz);
        append(rays.t_near, b.t_near), append(rays.t_far, b.t_far);
        append(skip_first, b.skip_first), append(skip_last, b.skip_last);
    }
    size_t size() const { return rays.size(); }
    size_t batches() const { return (size() + kBatch - 1) / kBatch; }
    RayBatch batch(size_t k) const {
        const size_t first = k * kBatch, count = std::min(kBatch, size() - first);
        const TraceRays& r = rays;
        return RayBatch{r.ox, r.oy, r.oz, r.dx, r.dy, r.dz, r.t_near, r.t_far, skip_first, skip_last}.part(first,
                                                                                                           count);
    }
};

struct Scratch {
    GatherRays gather;
    CrossingLight crossing_light;
    DirectLight direct;
    VisibilityQuery visibility_query;
    std::vector<Rgb> color, radiance;
    std::vector<float> scalar;
    std::vector<uint32_t> count;
    Flights flights;
    std::vector<float> cutoff;
};

/// Seconds of each stage, of one round, wall time.
struct Round {
    double draw, draw_no_mesh, hair, constant, colored, flights, type3, type1;
};

class Rounds {
public:
    Rounds(const Bench& b, const std::vector<TilePoints>& tiles) : b_(b), tiles_(tiles) {
        kept_.resize(tiles.size());
        for (size_t k = 0; k < tiles.size(); ++k) {
            make_gather_rays(b.scene, b.prepared, b.options, tiles[k].points, tiles[k].samplers, kept_[k]);
            flat_.add(kept_[k].rays.for_hair());
        }
    }
    const FlatRays& rays() const { return flat_; }

    Round operator()() {
        Round r{};
        r.draw = over(tiles_.size(), [&](Scratch& s, size_t k) {
            make_gather_rays(b_.scene, b_.prepared, b_.options, tiles_[k].points, tiles_[k].samplers, s.gather);
        });
        r.draw_no_mesh = over(tiles_.size(), [&](Scratch& s, size_t k) {
            make_gather_rays(b_.scene, without_mesh_, b_.options, tiles_[k].points, tiles_[k].samplers, s.gather);
        });
        r.hair = over(tiles_.size(), [&](Scratch& s, size_t k) {
            s.color.resize(kept_[k].size());
            transmittance(b_.prepared.hair, kept_[k].rays.for_hair(), b_.prepared.attenuation, b_.options.cutoff,
                          s.color, b_.options.isa);
        });
        r.constant = over(flat_.batches(), [&](Scratch& s, size_t k) {
            RayBatch batch = flat_.batch(k);
            batch.skip_first = batch.skip_last = {};
            s.scalar.resize(batch.size()), s.count.resize(batch.size());
            transmittance_constant(b_.prepared.hair, batch, kTransmission, kTraceCutoff, s.scalar, s.count,
                                   b_.options.isa);
        });
        r.colored = over(flat_.batches(), [&](Scratch& s, size_t k) {
            const RayBatch batch = flat_.batch(k);
            s.color.resize(batch.size());
            transmittance(b_.prepared.hair, batch, b_.prepared.attenuation, b_.options.cutoff, s.color, b_.options.isa);
        });
        r.flights = over(flat_.batches(), [&](Scratch& s, size_t k) {
            const RayBatch batch = flat_.batch(k);
            s.cutoff.assign(batch.size(), b_.options.cutoff);
            flights(b_.prepared.hair, batch, b_.prepared.attenuation, s.cutoff, s.flights, b_.options.isa);
        });
        r.type3 = over(tiles_.size(), [&](Scratch& s, size_t k) {
            s.radiance.assign(tiles_[k].points.size(), Rgb(0));
            s.crossing_light(b_.scene, b_.prepared, b_.options, b_.plan.lamps, nullptr, kept_[k], s.radiance);
        });
        r.type1 = over(tiles_.size(), [&](Scratch& s, size_t k) {
            s.radiance.assign(tiles_[k].points.size(), Rgb(0));
            s.direct(b_.scene, b_.prepared, b_.options, b_.plan.lamps, nullptr, tiles_[k].points, tiles_[k].samplers,
                     s.radiance);
        });
        return r;
    }

private:
    template <class Work>
    double over(size_t n, const Work& work) {
        const double start = seconds();
        tbb::parallel_for(size_t(0), n, [&](size_t k) { work(scratch_.local(), k); });
        return seconds() - start;
    }

    const Bench& b_;
    const std::vector<TilePoints>& tiles_;
    std::vector<GatherRays> kept_;
    FlatRays flat_;
    PreparedScene without_mesh_;
    tbb::enumerable_thread_specific<Scratch> scratch_;
};

void print(const std::vector<Round>& rounds, size_t rays, const char* threads) {
    const auto of = [&](double Round::*stage) {
        std::vector<double> values;
        for (const Round& r : rounds) values.push_back(r.*stage);
        return median(values);
    };
    const auto ratio = [&](auto above, double Round::*below) {
        std::vector<double> values;
        for (const Round& r : rounds) values.push_back(above(r) / (r.*below));
        return median(values);
    };
    const auto line = [&](const char* name, double t) {
        std::printf("  %-58s %8.3f s %8.3f Mrays/s\n", name, t, 1e-6 * double(rays) / t);
    };
    std::printf("%s, medians of %zu rounds, %zu rays\n", threads, rounds.size(), rays);
    line("renderer: rays drawn (no polygons)", of(&Round::draw_no_mesh));
    line("renderer: rays drawn, nearest polygon", of(&Round::draw));
    line("renderer: hair, tile by tile, in colour", of(&Round::hair));
    line("hair tree alone: constant, as tress trace", of(&Round::constant));
    line("hair tree alone: in colour", of(&Round::colored));
    line("hair tree alone: flights (crossings in order)", of(&Round::flights));
    line("type 3, rays drawn before", of(&Round::type3));
    line("type 1, all lamps, same points", of(&Round::type1));
    std::printf(
        "  times: renderer's hair / constant %.3f; / in colour %.3f; draw + polygon + hair / constant %.3f; "
        "flights / in colour %.3f; type 3 with its rays / type 1 %.3f\n",
        ratio([](const Round& r) { return r.hair; }, &Round::constant),
        ratio([](const Round& r) { return r.hair; }, &Round::colored),
        ratio([](const Round& r) { return r.draw + r.hair; }, &Round::constant),
        ratio([](const Round& r) { return r.flights; }, &Round::colored),
        ratio([](const Round& r) { return r.draw + r.type3; }, &Round::type1));
}

/// The hair of the scene as `tress trace` reads it: round ends, and no skipped segments.
TraceSegments trace_segments(const SegmentView& view) {
    TraceSegments s;
    for (size_t i = 0; i < view.size(); ++i) {
        s.point.push_back(uint32_t(s.x.size()));
        for (const auto& [p, radius] :
             {std::pair(view.start(i), view.start_radius(i)), std::pair(view.end(i), view.end_radius(i))}) {
            s.x.push_back(p.x), s.y.push_back(p.y), s.z.push_back(p.z);
            s.radius.push_back(radius);
        }
    }
    return s;
}

void run(const Arguments& arguments) {
    SceneDescription description = arguments.scene.empty() ? builtin_scene() : read_scene_file(arguments.scene);
    description.camera.width = description.camera.height = arguments.size;
    const Scene scene = load_scene(description).scene;
    const Options& options = description.options;
    const Plan plan = make_plan(scene, options);
    const PreparedScene prepared = prepare(scene, plan, options);
    const Bench bench{scene, prepared, plan, options};
    const std::vector<TilePoints> tiles = all_points(bench, arguments.spp);
    Rounds rounds(bench, tiles);
    if (!arguments.write.empty()) {
        write_trace_segments(arguments.write + ".segments", trace_segments(prepared.segments));
        write_trace_rays(arguments.write + ".rays", rounds.rays().rays);
    }
    std::vector<int> threads{1, int(std::thread::hardware_concurrency())};
    if (arguments.threads > 0) threads = {arguments.threads};
    for (const int n : threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(n));
        rounds();  // warms up
        std::vector<Round> timed;
        for (int k = 0; k < arguments.rounds; ++k) timed.push_back(rounds());
        print(timed, rounds.rays().size(), (std::to_string(n) + (n == 1 ? " thread" : " threads")).c_str());
    }
}

}  // namespace

int main(int count, char** values) {
    try {
        run(read_arguments(count, values));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gather_bench: %s\n", error.what());
        return 2;
    }
}
