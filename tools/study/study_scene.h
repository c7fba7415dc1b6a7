// SPDX-License-Identifier: MIT
// What a study is of: a scene with options, and where and by what it is measured.
#pragma once

#include "core/scene.h"
#include "core/scene_description.h"
#include "tools/scene_arguments.h"
#include "tools/study/study_log.h"

namespace tress {

struct StudyScene {
    SceneArguments arguments;  // as a render of it is given them
    Options options;
    std::string name;       // the scene file's, or "the built-in scene"
    std::string signature;  // of all that the scene holds (scene_hash.h)
    uint64_t segments = 0, triangles = 0;
    int width = 0, height = 0;
    std::string isa, processor, compiler, program;
    int threads = 0;
};

/// Of a scene that is loaded; it need not stay so.
StudyScene study_scene(const SceneArguments& arguments, const SceneDescription& description, const Scene& scene);

/// The first line of the study's file.
Json header(const StudyScene& scene, const char* kind);

/// What was studied and by what, a line each, of that first line.
std::vector<std::string> facts(const Json& header);

}  // namespace tress
