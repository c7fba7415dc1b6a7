// SPDX-License-Identifier: MIT
#include "tools/render.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <bit>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "accel/queries.h"
#include "core/error.h"
#include "core/layer_image.h"
#include "core/tone_map.h"
#include "gather/render.h"
#include "io/exr_file.h"
#include "io/load_scene.h"
#include "io/png_file.h"
#include "io/whole_file.h"
#include "tools/photon_report.h"
#include "tools/progress.h"
#include "tools/render_stats.h"
#include "tools/scene_arguments.h"

namespace tress {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct RenderArguments {
    SceneArguments scene;
    std::string output, stats;
    bool snapshots = false, quiet = false;
};

constexpr int kPasses = 50, kLongestPass = 8;  // progress shows at least this often; more samples a pass help caches

/// "a.exr" at 4 samples a pixel: "a-4.exr".
std::string snapshot_path(const std::string& exr, int samples) {
    const std::filesystem::path path(exr);
    return (path.parent_path() / (path.stem().string() + "-" + std::to_string(samples) + ".exr")).string();
}

std::string png_path(const std::string& exr) { return std::filesystem::path(exr).replace_extension(".png").string(); }

void check_outputs(const RenderArguments& arguments) {
    if (std::filesystem::path(arguments.output).extension() != ".exr")
        throw InputError(arguments.output, "expected a name that ends in .exr");
    check_writable(arguments.output);
    check_writable(png_path(arguments.output));
    if (!arguments.stats.empty()) check_writable(arguments.stats);
}

/// Samples of the next pass: no more than there were before, so that powers of two are met, and a short time is kept.
int next_pass(int samples, const Options& options) {
    const int longest = int(std::bit_floor(unsigned(std::clamp(options.spp / kPasses, 1, kLongestPass))));
    return std::min({longest, std::max(samples, 1), options.spp - samples});
}

/// All samples, or as many passes as begin before the time is up. `after_pass` is called after each.
template <class AfterPass>
void render_passes(RenderState& state, const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                   const Options& options, bool quiet, const AfterPass& after_pass) {
    Progress progress("render", quiet);
    while (state.samples < options.spp && (options.time == 0 || state.seconds < options.time || state.samples == 0)) {
        advance(state, scene, prepared, plan, options, next_pass(state.samples, options));
        after_pass();
        const double by_samples = double(state.samples) / options.spp;
        const double by_time = options.time > 0 ? state.seconds / options.time : 0;
        progress.update(std::max(by_samples, by_time), std::to_string(state.samples) + " spp");
    }
    char note[80];
    std::snprintf(note, sizeof note, "%d spp in %.2f s", state.samples, state.seconds);
    progress.finish(note);
}

void add_metadata(LayeredImage& picture, const RenderStats& stats, Options options) {
    picture.metadata.emplace_back("tress.version", TRESS_VERSION);
    picture.metadata.emplace_back("tress.samples", std::to_string(stats.spp));
    picture.metadata.emplace_back("tress.seconds.build", std::to_string(stats.build_seconds));
    picture.metadata.emplace_back("tress.seconds.render", std::to_string(stats.render_seconds));
    for (const OptionField& field : option_fields(options))
        picture.metadata.emplace_back("tress.options." + field.key, option_text(field));
}

/// "light: type1 61.2 ± 0.1 %, type2 …"
void print(const char* what, const std::vector<TypeShare>& types) {
    std::string line;
    for (const TypeShare& share : types) {
        char text[64];
        std::snprintf(text, sizeof text, "%s%s %.2f ± %.2f %%", line.empty() ? "" : ", ", type_name(share.type),
                      share.percent, share.percent_error);
        line += text;
    }
    if (!line.empty()) std::fprintf(stderr, "%s: %s\n", what, line.c_str());
}

/// Of the stages that bear this name, times the threads.
double core_seconds(const RenderStats& stats, const char* name) {
    double sum = 0;
    for (const StageCost& cost : stats.stages)
        if (cost.name == name) sum += cost.seconds * stats.threads;
    return sum;
}

/// What `type1: auto` expected, beside what it took.
void print_lamp_estimate(const RenderStats& stats, const Plan& plan) {
    const LampCost& cost = *plan.lamp_cost;
    const char* maps = stage::kShadowMaps[int(MapKind::deep)];
    if (plan.lamp_maps && cost.build == 0)
        std::fprintf(stderr, "type 1: by %s that type 3 asks too, estimated %.1f core seconds, took %.1f\n", maps,
                     cost.maps, core_seconds(stats, stage::kType1));
    else if (plan.lamp_maps)
        std::fprintf(stderr, "type 1: by %s, estimated %.1f core seconds and %.1f to make them, took %.1f and %.1f\n",
                     maps, cost.maps, cost.build, core_seconds(stats, stage::kType1), core_seconds(stats, maps));
    else
        std::fprintf(stderr, "type 1: by shadow rays, estimated %.1f core seconds, took %.1f\n", cost.rays,
                     core_seconds(stats, stage::kType1));
}

/// What `type2: auto` expected, beside what it took. Gather rays are type 3's too, and in neither figure.
void print_gather_estimate(const RenderStats& stats, const Plan& plan) {
    const GatherCost& cost = *plan.gather_cost;
    if (plan.projection)
        std::fprintf(stderr,
                     "type 2: by projection, estimated %.1f core seconds and %.1f to prepare it, took %.1f and %.1f\n",
                     cost.projection, cost.build, core_seconds(stats, stage::kProjection),
                     core_seconds(stats, stage::kProjectedHair));
    else
        std::fprintf(stderr, "type 2: by rays, estimated %.1f core seconds, took %.1f\n", cost.rays,
                     core_seconds(stats, stage::kSky) + core_seconds(stats, stage::kPolygonGather));
}

void print(const ProjectionReport& report) {
    if (report.error.points == 0) return;
    std::fprintf(stderr,
                 "projection: light of type 2 at %d points of hair is off by %.2f %% (rms; mean %+.2f %%), gap %.2f\n",
                 report.error.points, 100 * report.error.rms, 100 * report.error.bias, double(report.gap));
}

void run(const RenderArguments& arguments) {
    const auto start = Clock::now();
    const SceneDescription description = describe(arguments.scene);
    const Options& options = description.options;
    check_outputs(arguments);
    const Isa isa = used_isa(options.isa);
    const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(threads));

    RenderStats stats;
    const LoadedScene loaded = load_scene(description);
    const Scene& scene = loaded.scene;
    stats.load_seconds = seconds_since(start);
    const Plan plan = make_plan(scene, options);
    const auto build_start = Clock::now();
    const PreparedScene prepared = prepare(scene, plan, options);
    stats.build_seconds = seconds_since(build_start);
    RenderState state = make_state(scene, plan);
    render_passes(state, scene, prepared, plan, options, arguments.quiet, [&] {
        if (!arguments.snapshots || !std::has_single_bit(unsigned(state.samples))) return;
        const std::string file = snapshot_path(arguments.output, state.samples);
        write_exr(file, develop(state.film));
        stats.snapshots.push_back({state.samples, state.seconds, file});
    });

    stats.render_seconds = state.seconds;
    stats.stages = prepared.costs;
    for (StageCost& cost : loop_costs(state, prepared, plan)) stats.stages.push_back(std::move(cost));
    stats.left_out = plan.left_out;
    stats.types = type_shares(state.film, ShareOf::picture);
    stats.types_on_hair = type_shares(state.film, ShareOf::hair);
    stats.photons = prepared.photon_statistics;
    stats.lamp_cost = plan.lamp_cost;
    stats.gather_cost = plan.gather_cost;
    if (plan.projection) stats.projection = {prepared.projection.options.gap, prepared.projection.error};
    stats.threads = threads;
    if (!arguments.quiet) {
        for (const std::string& line : photon_lines(stats.photons, scene)) std::fprintf(stderr, "%s\n", line.c_str());
        print("light", stats.types);
        print("light on hair", stats.types_on_hair);
        if (plan.lamp_cost) print_lamp_estimate(stats, plan);
        if (plan.gather_cost) print_gather_estimate(stats, plan);
        if (stats.projection) print(*stats.projection);
    }
    stats.spp = state.samples;
    stats.isa = isa_name(isa);
    stats.segments = scene.segments.point.size();
    stats.dropped_segments = scene.segments.dropped;
    if (stats.dropped_segments && !arguments.quiet)
        std::fprintf(stderr, "dropped %llu bad segments\n", static_cast<unsigned long long>(stats.dropped_segments));

    LayeredImage picture = develop(state.film);
    add_metadata(picture, stats, options);
    write_exr(arguments.output, picture);
    write_png(png_path(arguments.output), tone_map(layer_image(picture, "", arguments.output), options.film.exposure));
    stats.total_seconds = seconds_since(start);
    if (!arguments.stats.empty()) write_text_file(arguments.stats, to_json(stats, options).dump(2) + "\n");
}

}  // namespace

void add_render_command(CLI::App& app) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "renders a scene to an EXR with layers and a PNG beside it");
    add_scene_arguments(*command, arguments->scene);
    command->add_option("-o,--output", arguments->output, "the EXR; the PNG lies beside it")->required();
    command->add_option("--stats", arguments->stats, "JSON file for times, memory and what was left out");
    command->add_flag("--snapshots", arguments->snapshots,
                      "also keeps the picture at each power of two of samples a pixel: NAME-1.exr, NAME-2.exr ...");
    command->add_flag("--quiet", arguments->quiet, "no progress");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace tress
