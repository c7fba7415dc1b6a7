// SPDX-License-Identifier: MIT
#include "tools/study/study.h"

#include <memory>

#include "tools/study/accel/accel_study.h"
#include "tools/study/methods/method_study.h"

namespace tress {
namespace {

void add_method_study(CLI::App& study, const char* name, const char* help, MethodStudyKind kind) {
    const auto a = std::make_shared<MethodStudyArguments>();
    CLI::App* command = study.add_subcommand(name, help);
    add_scene_arguments(*command, a->scene);
    command->add_option("-o,--output", a->output, "folder for the page, its pictures and its figures")->required();
    command
        ->add_option(
            "--row", a->rows,
            "a row: methods of Types 1 to 3 in the paper's names (RT, DSM, P, -; OSM, CD, PT), then key=value: "
            "\"RT/P/- projection.cells=64\"; methods: after the paper's six; convergence: in their place")
        ->allow_extra_args(false);
    command->add_option("--sweep", a->sweeps, "key=value,value,...: each row with each of them; more: their grid")
        ->allow_extra_args(false);
    command->add_flag("--all", a->all, "every combination of methods of Types 1 to 3");
    command->add_option("--seeds", a->seeds, "runs a row [3; quick: 1]")->check(CLI::Range(1, 1000));
    command
        ->add_option("--reference-time", a->reference_seconds, "seconds of the reference, both halves [600; quick: 24]")
        ->check(CLI::Range(1e-3, 1e7));
    command->add_option("--references", a->references, "folder that keeps references [OUTPUT/reference]");
    command->add_flag("--quick", a->quick, "a first page in under two minutes: small, one run of 3 s a row");
    command->add_flag("--quiet", a->quiet, "no progress");
    command->footer(
        "--time: seconds of rendering a run [20; quick: 3]; --spp: samples a run instead. --size: [the scene's "
        "shape, 160 pixels; quick: 96].\nWhat OUTPUT holds already of the same study is not done again.");
    command->callback([a, kind] { run_method_study(*a, kind); });
}

void add_accel_study(CLI::App& study) {
    const auto a = std::make_shared<AccelStudyArguments>();
    CLI::App* command = study.add_subcommand(
        "accel", "options of the tree of hair: cost predicted, build, memory, and speed on the rays of a render");
    add_scene_arguments(*command, a->scene);
    command->add_option("-o,--output", a->output, "folder for the page and its figures")->required();
    command->add_option("--row", a->rows, "a tree: \"accel.key=value ...\" [a list that goes through all options]")
        ->allow_extra_args(false);
    command
        ->add_option("--sweep", a->sweeps,
                     "accel.key=value,value,...: each row, or the scene's tree, with each of them; more: their grid")
        ->allow_extra_args(false);
    command->add_option("--rounds", a->rounds, "times that all is measured [3; quick: 1]")->check(CLI::Range(1, 1000));
    command->add_flag("--quick", a->quick, "a first page in under two minutes: a short list, one round");
    command->add_flag("--quiet", a->quiet, "no progress");
    command->footer(
        "--time: seconds of tracing a set of rays [1; quick: 0.4]. Rays are those of a picture of the scene's size.\n"
        "What OUTPUT holds already of the same study is not done again.");
    command->callback([a] { run_accel_study(*a); });
}

}  // namespace

void add_study_command(CLI::App& app) {
    CLI::App* study = app.add_subcommand("study", "error against run time: tables, plots and a page");
    study->require_subcommand(1);
    add_method_study(*study, "methods", "the paper's table of methods, measured here: time, bias and noise a row",
                     MethodStudyKind::methods);
    add_method_study(*study, "convergence", "error against time, for chosen methods and options",
                     MethodStudyKind::convergence);
    add_accel_study(*study);
}

}  // namespace tress
