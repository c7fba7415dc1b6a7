// SPDX-License-Identifier: MIT
#include "tools/groom.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "core/groom.h"
#include "io/hair_file.h"
#include "io/whole_file.h"

namespace tress {
namespace {

struct GroomArguments {
    std::string name, output;
    uint64_t segments = 1000000, seed = 0;
};

std::string known_names() {
    std::string names;
    for (const std::string_view name : groom_names()) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

void write_groom(const GroomArguments& arguments) {
    HairFile hair;
    check_writable(arguments.output);
    hair.strands = make_groom(arguments.name, arguments.segments, arguments.seed);
    hair.info = "tress groom " + arguments.name + " --segments " + std::to_string(arguments.segments) + " --seed " +
                std::to_string(arguments.seed);
    write_hair_file(arguments.output, hair);
    const size_t strands = hair.strands.strands();
    std::cout << arguments.output << ": " << strands << " strands, " << hair.strands.points() - strands
              << " segments\n";
}

}  // namespace

void add_groom_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("groom", "Grow procedural hair on a head and write it as a .hair file");
    const auto arguments = std::make_shared<GroomArguments>();
    command->add_option("name", arguments->name, "one of: " + known_names())->required();
    command->add_option("-o,--output", arguments->output, "the .hair file to write")->required();
    command->add_option("--segments", arguments->segments, "about so many")->capture_default_str();
    command->add_option("--seed", arguments->seed, "another seed is another hair")->capture_default_str();
    command->callback([arguments] { write_groom(*arguments); });
}

}  // namespace tress
