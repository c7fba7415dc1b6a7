// SPDX-License-Identifier: MIT
#include "tools/plan.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/plan.h"
#include "io/load_scene.h"
#include "tools/scene_arguments.h"

namespace tress {
namespace {

using Json = nlohmann::ordered_json;

struct PlanArguments {
    SceneArguments scene;
    bool json = false;
};

Json to_json(const std::vector<PlanItem>& items) {
    Json list = Json::array();
    for (const PlanItem& item : items) list.push_back({{"name", item.name}, {"why", item.why}});
    return list;
}

void print(const char* title, const std::vector<PlanItem>& items) {
    size_t widest = 0;
    for (const PlanItem& item : items) widest = std::max(widest, item.name.size());
    std::printf("%s\n", title);
    for (const PlanItem& item : items) std::printf("  %-*s  %s\n", int(widest), item.name.c_str(), item.why.c_str());
}

void run(const PlanArguments& arguments) {
    const SceneDescription description = describe(arguments.scene);
    const Plan plan = make_plan(load_scene(description).scene, description.options);
    if (arguments.json) {
        const Json json{{"stages", to_json(plan.stages)}, {"left_out", to_json(plan.left_out)}};
        std::printf("%s\n", json.dump(2).c_str());
        return;
    }
    print("built and run", plan.stages);
    print("left out", plan.left_out);
}

}  // namespace

void add_plan_command(CLI::App& app) {
    auto arguments = std::make_shared<PlanArguments>();
    CLI::App* command = app.add_subcommand("plan", "what would be built, what is left out, and why");
    add_scene_arguments(*command, arguments->scene);
    command->add_flag("--json", arguments->json, "as JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace tress
