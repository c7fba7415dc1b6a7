// SPDX-License-Identifier: MIT
// tress study as a user meets it: a folder with a page whose numbers are those of its lines, and no work done twice.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/run_command.h"

using namespace tress::test;
using Json = nlohmann::ordered_json;

namespace {

/// Lines of study.jsonl by kind, in order.
std::map<std::string, std::vector<Json>> lines_of(const std::string& text) {
    std::map<std::string, std::vector<Json>> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const Json json = Json::parse(line);
        lines[json["line"]].push_back(json);
    }
    return lines;
}

/// Each cell of the page shows the number of the line that it names; how many there are.
size_t check_cells(const std::string& page, const std::map<std::string, std::vector<Json>>& lines) {
    const std::regex cell("data-of=\"([a-z]+)\\.([0-9]+)(/[^\"]*)\" data-value=\"([^\"]*)\"");
    size_t cells = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), cell); i != std::sregex_iterator(); ++i, ++cells) {
        const Json& line = lines.at((*i)[1].str()).at(std::stoul((*i)[2].str()));
        CAPTURE(i->str());
        CHECK(line.at(Json::json_pointer((*i)[3].str())).dump() == (*i)[4].str());
    }
    return cells;
}

void check_asks_nothing(const std::string& page) {
    for (const char* outside : {"src=\"http", "href=\"http", "url(http", "@import"})
        CHECK(page.find(outside) == std::string::npos);
}

}  // namespace

TEST_CASE("a study's page holds the numbers of its lines, asks nothing of other places, and is not measured twice") {
    const Folder folder;
    const std::string scene = TRESS_SOURCE_DIR "/tests/small_scene.json", out = folder.file("study");
    const std::vector<std::string> command{"study",  "convergence",      scene, "-o",     out,       "--spp",
                                           "4",      "--seeds",          "2",   "--row",  "RT/RT/-", "--row",
                                           "RT/P/-", "--reference-time", "0.1", "--size", "16x16",   "--quiet"};
    const CommandResult first = run_tress(command);
    CAPTURE(first.error);
    REQUIRE(first.exit_code == 0);
    const std::string text = read_bytes(out + "/study.jsonl"), page = read_bytes(out + "/index.html");
    const auto lines = lines_of(text);
    REQUIRE(lines.at("row").size() == 2);
    CHECK(lines.at("run").size() == 4);
    CHECK(lines.at("run")[0]["points"].size() == 3);  // at 1, 2 and 4 samples a pixel
    CHECK(check_cells(page, lines) > 30);
    check_asks_nothing(page);
    CHECK(read_bytes(out + "/error-whole.svg").rfind("<svg", 0) == 0);

    REQUIRE(run_tress(command).exit_code == 0);
    CHECK(read_bytes(out + "/study.jsonl") == text);  // times too: nothing was rendered again
    CHECK(read_bytes(out + "/index.html") == page);
}

TEST_CASE("a study of trees has a line a tree and round, a page of their numbers, and is not measured twice") {
    const Folder folder;
    const std::string scene = TRESS_SOURCE_DIR "/tests/small_scene.json", out = folder.file("study");
    const std::vector<std::string> command{"study",          "accel",           scene, "-o",      out,      "--sweep",
                                           "accel.bins=4,8", "--rounds",        "2",   "--quiet", "--time", "0.02",
                                           "--row",          "accel.clip=false"};
    const CommandResult first = run_tress(command);
    CAPTURE(first.error);
    REQUIRE(first.exit_code == 0);
    const std::string text = read_bytes(out + "/study.jsonl"), page = read_bytes(out + "/index.html");
    const auto lines = lines_of(text);
    CHECK(lines.at("row").size() == 3);
    CHECK(lines.at("tree").size() == 6);
    for (const char* set : {"primary", "shadow", "gather"})
        CHECK(lines.at("row")[2]["rays"][set]["mrays_per_second"] > 0);
    CHECK(check_cells(page, lines) > 60);
    check_asks_nothing(page);
    CHECK(read_bytes(out + "/predicted.svg").rfind("<svg", 0) == 0);
    CHECK(read_bytes(out + "/rows.csv").rfind("line,row,", 0) == 0);

    REQUIRE(run_tress(command).exit_code == 0);
    CHECK(read_bytes(out + "/study.jsonl") == text);
    CHECK(read_bytes(out + "/index.html") == page);
}

TEST_CASE("a study that is asked for nonsense says so in one line") {
    const Folder folder;
    const CommandResult r = run_tress({"study", "methods", "-o", folder.file("s"), "--row", "RT/DSM/-"});
    CHECK(r.exit_code == 2);
    CHECK(r.error.find("'DSM' for type2") != std::string::npos);
    CHECK(std::count(r.error.begin(), r.error.end(), '\n') == 1);
}
