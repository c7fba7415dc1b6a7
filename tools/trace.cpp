// SPDX-License-Identifier: MIT
#include "tools/trace.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "accel/build.h"
#include "accel/queries.h"
#include "accel/statistics.h"
#include "core/error.h"
#include "io/trace_files.h"
#include "tools/scene_arguments.h"

namespace tress {
namespace {

constexpr size_t kBatch = 1024;  // rays

struct TraceCommand {
    std::string segments, rays, query = "nearest", isa = "auto", out;
    std::vector<std::string> set;
    float transmission = 0.7f, cutoff = 1e-3f;
    int threads = 0, passes = 5, stride = 1;
    bool json = false;
};

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

Options options_of(const TraceCommand& command) {
    Options options;
    set_option(options, "--isa", "isa", command.isa);
    for (const std::string& assignment : command.set) {
        if (!assignment.starts_with("accel."))
            throw InputError("--set", "'" + assignment + "', expected accel.key=value");
        set_option(options, assignment);
    }
    return options;
}

KdTree build(const TraceSegments& s, const AccelOptions& options) {
    SegmentView view;
    view.x = s.x, view.y = s.y, view.z = s.z;
    view.radius = s.radius;
    view.point = s.point;
    view.linked = false;
    return build_segment_tree(view, options);
}

/// Answers to both queries, one a ray.
struct Answers {
    std::vector<float> t, u, h, transmittance;
    std::vector<uint32_t> id, crossings;

    explicit Answers(size_t rays) : t(rays), u(rays), h(rays), transmittance(rays), id(rays), crossings(rays) {}
};

class Tracer {
public:
    Tracer(const KdTree& tree, const TraceRays& rays, const TraceCommand& command, Isa isa, Answers& answers)
        : tree_(tree), rays_(rays), command_(command), isa_(isa), answers_(answers) {}

    size_t batches() const { return (rays_.size() + kBatch - 1) / kBatch; }

    void nearest(size_t batch) const {
        const auto [first, count] = range(batch);
        const NearestHits hits{part(answers_.t, first, count), part(answers_.id, first, count),
                               part(answers_.u, first, count), part(answers_.h, first, count)};
        nearest_segment(tree_, ray_batch(first, count), hits, isa_);
    }
    void transmittance(size_t batch) const {
        const auto [first, count] = range(batch);
        transmittance_constant(tree_, ray_batch(first, count), command_.transmission, command_.cutoff,
                               part(answers_.transmittance, first, count), part(answers_.crossings, first, count),
                               isa_);
    }
    void query(size_t batch) const { command_.query == "nearest" ? nearest(batch) : transmittance(batch); }

    std::pair<size_t, size_t> range(size_t batch) const {
        const size_t first = batch * kBatch;
        return {first, std::min(kBatch, rays_.size() - first)};
    }

private:
    template <class T>
    static std::span<T> part(std::vector<T>& values, size_t first, size_t count) {
        return std::span<T>(values).subspan(first, count);
    }
    RayBatch ray_batch(size_t first, size_t count) const {
        const TraceRays& r = rays_;
        return RayBatch{r.ox, r.oy, r.oz, r.dx, r.dy, r.dz, r.t_near, r.t_far, {}, {}}.part(first, count);
    }

    const KdTree& tree_;
    const TraceRays& rays_;
    const TraceCommand& command_;
    Isa isa_;
    Answers& answers_;
};

nlohmann::json spread_of(std::vector<double> rates) {
    if (rates.empty()) rates.push_back(0);
    std::sort(rates.begin(), rates.end());
    return {{"min", rates.front()}, {"median", rates[rates.size() / 2]}, {"max", rates.back()}};
}

/// Every stride-th batch, once to warm up and then once a pass; adds what was met to the report. The stride is made
/// odd, so that it does not step along the tiles of a picture.
void time_passes(const Tracer& tracer, const TraceCommand& command, const Answers& answers, nlohmann::json& report) {
    const size_t stride = size_t(command.stride) | 1, timed = (tracer.batches() + stride - 1) / stride;
    size_t rays = 0, hits = 0;
    for (size_t k = 0; k < timed; ++k) rays += tracer.range(k * stride).second;
    std::vector<double> rates, processor_rates;
    for (int pass = 0; pass <= command.passes; ++pass) {
        const double wall = wall_seconds(), processor = processor_seconds();
        tbb::parallel_for(size_t(0), timed, [&](size_t k) { tracer.query(k * stride); });
        if (pass == 0) continue;
        rates.push_back(1e-6 * double(rays) / (wall_seconds() - wall));
        processor_rates.push_back(1e-6 * double(rays) / (processor_seconds() - processor));
    }
    double sum_t = 0, crossings = 0, sum_transmittance = 0;
    for (size_t k = 0; k < timed; ++k) {
        const auto [first, count] = tracer.range(k * stride);
        for (size_t i = first; i < first + count; ++i) {
            if (answers.id[i] != kNone) sum_t += double(answers.t[i]);
            hits += answers.id[i] != kNone;
            crossings += double(answers.crossings[i]);
            sum_transmittance += double(answers.transmittance[i]);
        }
    }
    report["rays"] = rays;
    report["mrays_per_second"] = spread_of(rates);
    report["mrays_per_processor_second"] = spread_of(processor_rates);
    const bool nearest = command.query == "nearest";  // figures of the other query are null
    const auto of = [](bool asked, double value) { return asked ? nlohmann::json(value) : nlohmann::json(); };
    report["hits"] = nearest ? nlohmann::json(hits) : nlohmann::json();
    report["sum_t"] = of(nearest, sum_t);
    report["mean_hits"] = of(!nearest, rays ? crossings / double(rays) : 0.0);
    report["sum_transmittance"] = of(!nearest, sum_transmittance);
}

void write_hits(const Tracer& tracer, const std::string& path, const Answers& answers) {
    tbb::parallel_for(size_t(0), tracer.batches(), [&](size_t batch) {
        tracer.nearest(batch);
        tracer.transmittance(batch);
    });
    write_trace_hits(path, {answers.t, answers.transmittance, answers.id, answers.crossings});
}

void print(const nlohmann::json& report, bool as_json) {
    if (as_json) {
        std::printf("%s\n", report.dump(2).c_str());
        return;
    }
    for (const auto& [key, value] : report.items()) std::printf("%-28s %s\n", key.c_str(), value.dump().c_str());
}

void run(const TraceCommand& command) {
    const Options options = options_of(command);
    used_isa(options.isa);  // refused before any work where the machine cannot run it
    const size_t threads = size_t(command.threads > 0 ? command.threads : int(std::thread::hardware_concurrency()));
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const TraceSegments segments = read_trace_segments(command.segments);
    const TraceRays rays = read_trace_rays(command.rays);

    const double start = wall_seconds();
    const KdTree tree = build(segments, options.accel);
    const double build_seconds = wall_seconds() - start;
    const TreeStatistics s = statistics(tree, segments.size(), options.accel);
    nlohmann::json report{{"build_seconds", build_seconds},
                          {"bytes", s.bytes},
                          {"nodes", s.nodes},
                          {"leaves", s.leaves},
                          {"depth", s.depth},
                          {"references_per_segment", s.references_per_primitive},
                          {"sah_cost", s.sah_cost},
                          {"segments", segments.size()}};
    Answers answers(rays.size());
    const Tracer tracer(tree, rays, command, options.isa, answers);
    time_passes(tracer, command, answers, report);
    if (!command.out.empty()) write_hits(tracer, command.out, answers);
    print(report, command.json);
}

}  // namespace

void add_trace_command(CLI::App& app) {
    const auto command = std::make_shared<TraceCommand>();
    CLI::App* sub = app.add_subcommand("trace", "The hair tree alone, on files of segments and rays");
    sub->add_option("--segments", command->segments, "file of segments (TRSEG001)")->required();
    sub->add_option("--rays", command->rays, "file of rays (TRRAY001)")->required();
    sub->add_option("--query", command->query, "what is timed")
        ->check(CLI::IsMember({"nearest", "transmittance"}))
        ->capture_default_str();
    sub->add_option("--transmission", command->transmission, "what one crossing lets through")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    sub->add_option("--cutoff", command->cutoff, "transmittance below which a ray stops")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    sub->add_option("--threads", command->threads, "0: as many as the machine has")->check(CLI::Range(0, 4096));
    sub->add_option("--isa", command->isa, "instruction set: auto, scalar, sse4, avx2, avx512");
    sub->add_option("--passes", command->passes, "timed passes over the rays")->check(CLI::Range(1, 1000));
    sub->add_option("--stride", command->stride, "trace every K-th block of 1024 rays only")
        ->check(CLI::Range(1, 1 << 20));
    sub->add_option("--set", command->set, "accel.key=value");
    sub->add_option("--out", command->out, "file of hits (TRHIT001): both queries, all rays");
    sub->add_flag("--json", command->json, "print JSON");
    sub->callback([command] { run(*command); });
}

}  // namespace tress
