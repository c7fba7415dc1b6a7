// SPDX-License-Identifier: MIT
#include "tools/study/methods/rendering.h"

#include <filesystem>

#include "core/error.h"
#include "tools/study/methods/child_process.h"

namespace tress {
namespace {

/// The scene's arguments with every option said outright, so that nothing else decides.
std::vector<std::string> words_of(const StudyScene& scene, Options options, const Budget& budget) {
    SceneArguments arguments = scene.arguments;
    arguments.flags.clear();
    arguments.sets.clear();
    arguments.reference = false;
    options.seed = budget.seed;
    options.time = budget.seconds;
    options.spp = budget.samples > 0 ? budget.samples : kMostSamples;
    for (const OptionField& field : option_fields(options))
        arguments.sets.push_back(field.key + "=" + option_text(field));
    std::vector<std::string> words{"render"};
    for (std::string& word : to_command_line(arguments)) words.push_back(std::move(word));
    return words;
}

}  // namespace

Json render(const StudyScene& scene, Options options, const Budget& budget, const std::string& picture,
            bool snapshots) {
    const std::string stats = picture + ".json";
    std::vector<std::string> words = words_of(scene, options, budget);
    words.insert(words.end(), {"--quiet", "--output=" + picture, "--stats=" + stats});
    if (snapshots) words.push_back("--snapshots");
    const ChildResult result = run_self(words);
    std::filesystem::remove(std::filesystem::path(picture).replace_extension(".png"));
    if (result.exit_code != 0)
        throw InputError("a render of the study", result.error.empty()
                                                      ? "ended with exit code " + std::to_string(result.exit_code)
                                                      : result.error);
    Json figures = read_json(stats);
    std::filesystem::remove(stats);
    return figures;
}

}  // namespace tress
