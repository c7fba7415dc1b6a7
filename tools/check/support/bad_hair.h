// SPDX-License-Identifier: MIT
// Hair with segments of no length, and what `tress render` says of bad hair.
#pragma once

#include "core/scene_description.h"
#include "io/hair_file.h"
#include "tools/check/support/render_command.h"
#include "tools/check/support/tufts.h"

namespace tress::test {

/// Appends a strand of `count` points.
inline void add_strand(StrandSet& to, const Vec3* points, size_t count) {
    if (to.first.empty()) to.first.push_back(0);
    for (size_t i = 0; i < count; ++i) to.add_point(points[i]);
    to.first.push_back(uint32_t(to.points()));
}

/// `from` with every third point twice and, after every tenth strand, one whose points are all the same.
inline StrandSet with_no_lengths(const StrandSet& from) {
    StrandSet to;
    to.constant_radius = from.constant_radius;
    for (size_t s = 0; s < from.strands(); ++s) {
        std::vector<Vec3> points;
        for (uint32_t p = from.first[s]; p < from.first[s + 1]; ++p)
            points.insert(points.end(), p % 3 == 0 ? 2 : 1, from.point(p));
        add_strand(to, points.data(), points.size());
        if (s % 10 != 0) continue;
        const std::vector<Vec3> alike(4, points[points.size() / 2]);
        add_strand(to, alike.data(), alike.size());
    }
    return to;
}

inline size_t segments(const StrandSet& strands) { return strands.points() - strands.strands(); }

/// A scene of this hair alone, read from a file that is written into the folder.
inline SceneDescription scene_of_file(const StrandSet& strands, const Folder& folder) {
    HairFile file;
    file.strands = strands;
    write_hair_file(folder.file("a.hair"), file);
    SceneDescription description;
    description.hair.resize(1);
    description.hair[0].file = folder.file("a.hair");
    return description;
}

/// What `tress render` says of a file of hair and a lamp, under other options at their smallest.
inline CommandEnd render_file_of(const StrandSet& strands) {
    const Folder folder;
    HairFile file;
    file.strands = strands;
    write_hair_file(folder.file("a.hair"), file);
    const std::string scene = write_bytes(folder.file("scene.json"), R"({
        "camera": {"from": [0, 0, 8], "to": [0, 0, 0], "size": [16, 16]}, "hair": [{"file": "a.hair"}],
        "lights": [{"type": "point", "position": [1, 3, 4], "intensity": [12, 12, 12]}], "options": {"spp": 1}})");
    return run_render({scene, "-o", folder.file("a.exr")});
}

}  // namespace tress::test
