// SPDX-License-Identifier: MIT
#include "tools/scene_arguments.h"

#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "core/builtin_scene.h"
#include "core/error.h"
#include "core/film.h"
#include "io/read_fiber.h"
#include "io/scene_file.h"

namespace tress {
namespace {

constexpr int kLargestSide = 32768;

void set_size(Camera& camera, const std::string& text) {
    const char* const end = text.data() + text.size();
    int width = 0, height = 0;
    const auto [x, width_error] = std::from_chars(text.data(), end, width);
    const bool has_x = width_error == std::errc() && x != end && *x == 'x';
    const auto [rest, height_error] = std::from_chars(has_x ? x + 1 : end, end, height);
    const auto in_range = [](int side) { return side >= 1 && side <= kLargestSide; };
    if (!has_x || height_error != std::errc() || rest != end || !in_range(width) || !in_range(height))
        throw InputError("--size", "'" + text + "', expected WIDTHxHEIGHT, each from 1 to 32768");
    camera.width = width;
    camera.height = height;
}

}  // namespace

void add_scene_arguments(CLI::App& command, SceneArguments& arguments) {
    command.add_option("scene", arguments.scene, "scene file (JSON); without: the built-in scene");
    command.add_option("--size", arguments.size, "picture size, WIDTHxHEIGHT");
    command.add_option("--data", arguments.data, "folder that ${TRESS_DATA} stands for in scene files");
    command
        .add_option("--fiber", arguments.fiber,
                    "a key of the scene file's fiber, for all hair: eumelanin=0.2, color=0.8,0.5,0.2, beta_m=0.3 ...")
        ->allow_extra_args(false);
    command.add_flag("--reference", arguments.reference, "every type by path, where nothing else is said: the truth");
    Options defaults;
    for (const OptionField& field : option_fields(defaults)) {
        if (field.key.find('.') != std::string::npos) continue;
        const auto keep = [&arguments, key = field.key](const std::string& text) { arguments.flags[key] = text; };
        command.add_option_function<std::string>(
            "--" + field.key, keep, std::string(field.help) + ": " + accepted(field) + " [" + option_text(field) + "]");
    }
    std::string help = "any option, key=value:";
    for (const OptionField& field : option_fields(defaults))
        help += "\n  " + field.key + "=" + option_text(field) + "  " + std::string(field.help);
    command.add_option("--set", arguments.sets, help)->allow_extra_args(false);
}

std::vector<std::string> to_command_line(const SceneArguments& arguments) {
    std::vector<std::string> words;
    const auto add = [&](const std::string& flag, const std::string& value) {
        words.push_back(flag + "=" + value);  // one word: a value may begin with a dash
    };
    if (!arguments.scene.empty()) words.push_back(arguments.scene);
    if (!arguments.size.empty()) add("--size", arguments.size);
    if (!arguments.data.empty()) add("--data", arguments.data);
    for (const std::string& key : arguments.fiber) add("--fiber", key);
    if (arguments.reference) words.push_back("--reference");
    for (const std::string& assignment : arguments.sets) add("--set", assignment);
    for (const auto& [key, text] : arguments.flags) add("--" + key, text);
    return words;
}

void set_option(Options& options, const std::string& assignment) {
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw InputError("--set", "'" + assignment + "', expected key=value");
    set_option(options, "--set", assignment.substr(0, equals), assignment.substr(equals + 1));
}

SceneDescription describe(const SceneArguments& arguments) {
    if (!arguments.data.empty())  // relative to where the command runs, not to the scene file
        setenv("TRESS_DATA", std::filesystem::absolute(arguments.data).c_str(), 1);
    SceneDescription scene = arguments.scene.empty() ? builtin_scene() : read_scene_file(arguments.scene);
    if (!arguments.fiber.empty())
        for (HairDescription& hair : scene.hair) hair.fiber = read_fiber(arguments.fiber, "--fiber", hair.fiber);
    if (arguments.reference) use_paths(scene.options);
    for (const std::string& assignment : arguments.sets) set_option(scene.options, assignment);
    for (const auto& [key, text] : arguments.flags) set_option(scene.options, "--" + key, key, text);
    if (arguments.flags.contains("time") && !arguments.flags.contains("spp")) scene.options.spp = kMostSamples;
    if (!arguments.size.empty()) set_size(scene.camera, arguments.size);
    check_film_size(scene.camera.width, scene.camera.height);
    return scene;
}

}  // namespace tress
