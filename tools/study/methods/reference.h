// SPDX-License-Identifier: MIT
// The truth that a study holds pictures against: by paths, in two independent halves, kept for the next study.
#pragma once

#include <string>

#include "core/image.h"
#include "tools/study/study_log.h"
#include "tools/study/study_scene.h"

namespace tress {

struct Reference {
    LayeredImage picture;
    std::string file;  // of the picture
    Json line;         // {"line": "reference", "key", "spp", "seconds", "errors": {"whole": relMSE, ...}}
};

/// Those of `types` by paths for `seconds` in all, or what `folder` keeps of an earlier study of the same scene and
/// options: KEY.exr, and KEY.json with its figures. The halves are made in the folder `work`.
Reference make_reference(const StudyScene& scene, const TypeSet& types, double seconds, const std::string& folder,
                         const std::string& work);

/// Types that are on.
TypeSet types_on(const Options& options);

}  // namespace tress
