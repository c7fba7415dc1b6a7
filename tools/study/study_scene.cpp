// SPDX-License-Identifier: MIT
#include "tools/study/study_scene.h"

#include <tbb/info.h>

#include "accel/isa_targets.h"
#include "core/scene_hash.h"
#include "tools/machine.h"
#include "tools/number_text.h"
#include "tools/render_stats.h"
#include "tools/signature.h"

namespace tress {

StudyScene study_scene(const SceneArguments& arguments, const SceneDescription& description, const Scene& scene) {
    StudyScene s;
    s.arguments = arguments;
    s.options = description.options;
    s.name = arguments.scene.empty() ? "the built-in scene" : arguments.scene;
    s.signature = hexadecimal(scene_hash(scene));
    s.segments = scene.segments.point.size();
    s.triangles = scene.mesh.triangles();
    s.width = scene.camera.width;
    s.height = scene.camera.height;
    s.isa = isa_name(used_isa(s.options.isa));
    s.threads = s.options.threads > 0 ? s.options.threads : tbb::info::default_concurrency();
    s.processor = processor_name();
    s.compiler = compiler_name();
    s.program = program_signature();
    return s;
}

Json header(const StudyScene& s, const char* kind) {
    return {{"line", "study"},
            {"kind", kind},
            {"scene", s.name},
            {"scene_signature", s.signature},
            {"segments", s.segments},
            {"triangles", s.triangles},
            {"width", s.width},
            {"height", s.height},
            {"processor", s.processor},
            {"threads", s.threads},
            {"isa", s.isa},
            {"compiler", s.compiler},
            {"version", TRESS_VERSION},
            {"program", s.program},
            {"seed", s.options.seed},
            {"options", option_texts(s.options)}};
}

std::vector<std::string> facts(const Json& h) {
    const auto text = [&](const char* key) { return h[key].get<std::string>(); };
    const auto count = [&](const char* key) { return grouped(h[key].get<unsigned long long>()); };
    return {text("scene") + ": " + count("segments") + " hair segments, " + count("triangles") + " triangles, " +
                h["width"].dump() + " × " + h["height"].dump() + " pixels",
            text("processor") + ", " + h["threads"].dump() + " threads, " + text("isa") + "; " + text("compiler") +
                "; tress " + text("version") + "; seed " + h["seed"].dump()};
}

}  // namespace tress
