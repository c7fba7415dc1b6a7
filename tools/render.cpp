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
#include "tools/checkpoints.h"
#include "tools/interrupt.h"
#include "tools/render_passes.h"
#include "tools/render_report.h"
#include "tools/render_stats.h"
#include "tools/scene_arguments.h"

namespace tress {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct RenderArguments {
    SceneArguments scene;
    std::string output, stats;
    double checkpoint = 0;  // seconds between checkpoints; 0: none
    bool resume = false, snapshots = false, quiet = false;
};

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

void add_metadata(LayeredImage& picture, const RenderStats& stats, Options options) {
    picture.metadata.emplace_back("tress.version", TRESS_VERSION);
    picture.metadata.emplace_back("tress.samples", std::to_string(stats.spp));
    picture.metadata.emplace_back("tress.seconds.build", std::to_string(stats.build_seconds));
    picture.metadata.emplace_back("tress.seconds.render", std::to_string(stats.render_seconds));
    for (const OptionField& field : option_fields(options))
        picture.metadata.emplace_back("tress.options." + field.key, option_text(field));
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
    RenderState state = make_state(scene, plan);
    std::optional<Checkpoints> checkpoints;
    if (arguments.checkpoint > 0 || arguments.resume)
        checkpoints.emplace(arguments.output, arguments.checkpoint, scene, options);
    if (arguments.resume && checkpoints->resume(state) && !arguments.quiet)
        std::fprintf(stderr, "goes on after %d spp\n", state.samples);

    const auto build_start = Clock::now();
    const PreparedScene prepared = prepare(scene, plan, options);
    stats.build_seconds = seconds_since(build_start);
    const PassLimits limits{arguments.checkpoint, arguments.quiet};
    const int signal = render_passes(state, scene, prepared, plan, options, limits, [&] {
        if (checkpoints) checkpoints->after_pass(state);
        if (!arguments.snapshots || !std::has_single_bit(unsigned(state.samples))) return;
        const std::string file = snapshot_path(arguments.output, state.samples);
        write_exr(file, develop(state.film));
        stats.snapshots.push_back({state.samples, state.seconds, file});
    });

    if (signal && checkpoints) checkpoints->write(state);

    stats.render_seconds = state.seconds;
    stats.stages = prepared.costs;
    for (StageCost& cost : loop_costs(state, prepared, plan)) stats.stages.push_back(std::move(cost));
    stats.left_out = plan.left_out;
    stats.types = type_shares(state.film, ShareOf::picture);
    stats.types_on_hair = type_shares(state.film, ShareOf::hair);
    stats.photons = prepared.photon_statistics;
    stats.lamp_cost = plan.lamp_cost;
    stats.gather_cost = plan.gather_cost;
    if (plan.projection) stats.projection = {prepared.projection.at_hair, prepared.projection.at_polygons};
    stats.threads = threads;
    stats.spp = state.samples;
    stats.isa = isa_name(isa);
    stats.segments = scene.segments.point.size();
    stats.dropped_segments = scene.segments.dropped;
    if (!arguments.quiet) print_report(stats, plan, scene);

    LayeredImage picture = develop(state.film);
    add_metadata(picture, stats, options);
    write_exr(arguments.output, picture);
    write_png(png_path(arguments.output), tone_map(layer_image(picture, "", arguments.output), options.film.exposure));
    stats.total_seconds = seconds_since(start);
    if (!arguments.stats.empty()) write_text_file(arguments.stats, to_json(stats, options).dump(2) + "\n");
    if (signal) throw Interrupted{signal};
    if (checkpoints) checkpoints->remove();
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
    command
        ->add_option("--checkpoint", arguments->checkpoint,
                     "seconds: as often NAME.checkpoint is written, from which --resume goes on")
        ->check(CLI::Range(1e-3, 1e9));
    command->add_flag("--resume", arguments->resume, "goes on from NAME.checkpoint, if there is one");
    command->add_flag("--quiet", arguments->quiet, "no progress");
    command->footer(
        "SIGINT and SIGTERM end it after the pass that runs, with the picture (and the checkpoint) of what there is.");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace tress
