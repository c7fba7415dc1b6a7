// SPDX-License-Identifier: MIT
#include "tools/study/rendering.h"

#include <filesystem>

#include "core/error.h"
#include "tools/study/child_process.h"

namespace tress {
namespace {

/// The scene's arguments with every option said outright, so that nothing else decides.
std::vector<std::string> words_of(const StudyScene& scene, Options options, const RenderJob& job,
                                  const std::string& stats) {
    SceneArguments arguments = scene.arguments;
    arguments.flags.clear();
    arguments.sets.clear();
    arguments.reference = false;
    options.seed = job.seed;
    options.time = job.seconds;
    options.spp = job.samples > 0 ? job.samples : kMostSamples;
    for (const OptionField& field : option_fields(options))
        arguments.sets.push_back(field.key + "=" + option_text(field));
    std::vector<std::string> words{"render"};
    for (std::string& word : to_command_line(arguments)) words.push_back(std::move(word));
    for (const std::string& word : {std::string("--quiet"), "--output=" + job.picture, "--stats=" + stats})
        words.push_back(word);
    if (job.snapshots) words.push_back("--snapshots");
    return words;
}

}  // namespace

Json render(const StudyScene& scene, Options options, const RenderJob& job) {
    const std::string stats = job.picture + ".json";
    const ChildResult result = run_self(words_of(scene, options, job, stats));
    std::filesystem::remove(std::filesystem::path(job.picture).replace_extension(".png"));
    if (result.exit_code != 0)
        throw InputError("a render of the study", result.error.empty()
                                                      ? "ended with exit code " + std::to_string(result.exit_code)
                                                      : result.error);
    Json figures = read_json(stats);
    std::filesystem::remove(stats);
    return figures;
}

}  // namespace tress
