// SPDX-License-Identifier: MIT
// A study that is killed at any moment: what was measured stays, whole and as it was, and is not measured again.
#include <doctest/doctest.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "core/rng.h"
#include "io/exr_file.h"
#include "tests/run_command.h"

using namespace tress::test;
using Json = nlohmann::ordered_json;
using Seconds = std::chrono::duration<double>;

namespace {

constexpr int kRows = 12;  // the paper's six, with two values each
constexpr int kKills = 12;

std::vector<std::string> study(const std::string& out) {
    return {"study",
            "methods",
            TRESS_SOURCE_DIR "/tests/small_scene.json",
            "-o",
            out,
            "--sweep",
            "gather.rays=1,2",
            "--spp",
            "2",
            "--seeds",
            "1",
            "--reference-time",
            "0.1",
            "--size",
            "12x12",
            "--quiet",
            "--set",
            "photons.count=100"};
}

/// Lines that were measured, by key. Every line is whole.
std::map<std::string, std::string> measured(const std::string& out) {
    std::map<std::string, std::string> lines;
    std::istringstream in(read_bytes(out + "/study.jsonl"));
    for (std::string line; std::getline(in, line);) {
        const Json json = Json::parse(line);
        if (json.contains("key")) lines[json["key"]] = line;
    }
    return lines;
}

}  // namespace

TEST_CASE("a study of twelve rows that is killed again and again loses nothing that it measured") {
    const Folder folder;
    const std::string out = folder.file("study");
    const auto start = std::chrono::steady_clock::now();
    REQUIRE(run_tress(study(folder.file("whole"))).exit_code == 0);
    const Seconds whole = std::chrono::steady_clock::now() - start;

    std::map<std::string, std::string> seen;
    const auto check_kept = [&](const std::map<std::string, std::string>& now) {
        for (const auto& [key, line] : seen) {
            REQUIRE(now.contains(key));
            CHECK(now.at(key) == line);  // its times too: it was not measured again
        }
    };
    for (int kill = 0; kill < kKills; ++kill) {
        RunningCommand running(study(out));
        std::this_thread::sleep_for(whole * (double(tress::random(1, uint64_t(kill))) / 3));
        running.send(SIGKILL);
        running.wait();
        const auto now = measured(out);
        check_kept(now);
        seen = now;
        for (const auto& [key, line] : seen)
            if (const Json json = Json::parse(line); json["line"] == "run")
                CHECK(tress::read_exr(out + "/" + json["picture"].get<std::string>()).width == 12);
    }
    REQUIRE(run_tress(study(out)).exit_code == 0);
    const auto end = measured(out);
    check_kept(end);
    CHECK(end.size() == kRows + 1);  // and the reference
    CHECK(read_bytes(out + "/index.html").ends_with("</html>\n"));
    CHECK_FALSE(std::filesystem::exists(out + "/study.part"));
}
