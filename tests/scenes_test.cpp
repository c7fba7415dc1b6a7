// SPDX-License-Identifier: MIT
// The scenes of the project, on hair that others made. The data lie in the folder that TRESS_DATA names.
#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "io/exr_file.h"
#include "tests/run_command.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("every scene on real hair renders: over a million segments, finite, with hair in the picture") {
    const char* data = std::getenv("TRESS_DATA");
    if (!data || !*data) {
        MESSAGE("skipped whole: TRESS_DATA does not name a folder of hair data");
        return;
    }
    for (const char* name : {"straight", "harolongo", "sintel", "ponytail"}) {
        CAPTURE(name);
        const Folder folder;
        const std::string scene = std::string(TRESS_SOURCE_DIR) + "/scenes/" + name + ".json";
        const CommandResult r = run_tress({"render", scene, "-o", folder.file("a.exr"), "--size", "64x64", "--spp", "2",
                                           "--stats", folder.file("s.json"), "--quiet"});
        CAPTURE(r.error);
        REQUIRE(r.exit_code == 0);
        CHECK(nlohmann::json::parse(read_bytes(folder.file("s.json")))["segments"].get<uint64_t>() > 1000000);
        double covered = 0;
        for (const Layer& layer : read_exr(folder.file("a.exr")).layers) {
            for (const float v : layer.data) REQUIRE(std::isfinite(v));
            if (layer.name.empty())
                for (size_t i = 3; i < layer.data.size(); i += 4) covered += double(layer.data[i]);
        }
        CHECK(covered / (64 * 64) > 0.1);
    }
}
