// SPDX-License-Identifier: MIT
// What `render` and `plan` are told of a scene and its options on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/scene_description.h"

namespace tress {

struct SceneArguments {
    std::string scene;                         // empty: the built-in scene
    std::string size;                          // "WxH" or empty
    std::string data;                          // what ${TRESS_DATA} stands for in scene files; empty: the environment's
    std::map<std::string, std::string> flags;  // option key -> text, of the flags given
    std::vector<std::string> sets;             // "key=value"
    bool reference = false;                    // every type by path
    std::vector<std::string> fiber;            // "key=value", of the fiber of all hair
};

/// Adds SCENE, --size, --data, --fiber, --reference, --set and a flag for every option outside a group (--spp, --type1
/// …).
void add_scene_arguments(CLI::App& command, SceneArguments& arguments);

/// The scene as its file and the command line say it; the command line wins. --time without --spp: as many samples as
/// the time allows.
SceneDescription describe(const SceneArguments& arguments);

/// The arguments again, as a command line has them: what a child process is given.
std::vector<std::string> to_command_line(const SceneArguments& arguments);

/// Sets an option from "key=value".
void set_option(Options& options, const std::string& assignment);

}  // namespace tress
