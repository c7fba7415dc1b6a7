// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Include {
    std::string file, text;
};

std::vector<Include> includes_below(const fs::path& folder) {
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);)
            if (line.rfind("#include", 0) == 0) found.push_back({entry.path().string(), line});
    }
    return found;
}

bool names(const std::string& include, const std::string& part) { return include.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("includes follow the arrows: tools -> io -> core, tools -> gather -> accel -> core") {
    const std::map<std::string, std::set<std::string>> may_use = {{"core", {"core"}},
                                                                  {"accel", {"core", "accel"}},
                                                                  {"gather", {"core", "accel", "gather"}},
                                                                  {"io", {"core", "io"}}};
    for (const auto& [module, allowed] : may_use) {
        const std::vector<Include> includes = includes_below(fs::path(TRESS_SOURCE_DIR) / "src" / module);
        CHECK_FALSE(includes.empty());
        for (const Include& include : includes) {
            for (const char* other : {"core", "accel", "gather", "io", "tools", "tests"}) {
                if (allowed.count(other)) continue;
                CAPTURE(include.file);
                CHECK_FALSE(names(include.text, std::string("\"").append(other).append("/")));
            }
        }
    }
}

TEST_CASE("file formats are known to io alone, and core, accel and gather need only TBB, GLM and Highway") {
    const fs::path source(TRESS_SOURCE_DIR);
    for (const char* module : {"core", "accel", "gather"})
        for (const Include& include : includes_below(source / "src" / module))
            for (const char* library : {"OpenEXR", "Imf", "png.h", "nlohmann", "tiny_obj", "CLI/", "doctest"}) {
                CAPTURE(include.file);
                CHECK_FALSE(names(include.text, library));
            }
    for (const Include& include : includes_below(source / "src" / "io")) {
        CAPTURE(include.file);
        const bool header = include.file.ends_with(".h");
        for (const char* library : {"OpenEXR", "Imf", "png.h", "nlohmann", "tiny_obj"})
            CHECK_FALSE((header && names(include.text, library)));
    }
}

TEST_CASE("no ray tracer of others is in the project") {
    for (const char* folder : {"src", "tools", "tests", "examples"})
        for (const Include& include : includes_below(fs::path(TRESS_SOURCE_DIR) / folder)) {
            CAPTURE(include.file);
            CHECK_FALSE(names(include.text, "embree"));
        }
}
