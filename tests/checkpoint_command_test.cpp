// SPDX-License-Identifier: MIT
// Renders that are killed, told to stop, or run out of disk: what there was is kept, and goes on to the same pixels.
#include <doctest/doctest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/rng.h"
#include "io/exr_file.h"
#include "tests/run_command.h"
#include "tools/check/support/full_disk.h"

using namespace tress;
using namespace tress::test;
using namespace std::chrono_literals;

namespace {

const char* const kScene = TRESS_SOURCE_DIR "/tests/small_scene.json";

/// A render of small_scene.json in the folder; `more`: after the usual arguments.
std::vector<std::string> render(const Folder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",  kScene,   "-o",    folder.file("a.exr"),
                                       "--quiet", "--size", "48x48", "--set=photons.count=2000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::vector<std::vector<float>> pixels(const std::string& exr) {
    std::vector<std::vector<float>> data;
    for (const Layer& layer : read_exr(exr).layers) data.push_back(layer.data);
    return data;
}

bool exists(const std::string& path) { return std::filesystem::exists(path); }

/// Waits until a file is there; false after ten seconds.
bool wait_for(const std::string& path) {
    for (int i = 0; i < 10000; ++i, std::this_thread::sleep_for(1ms))
        if (exists(path)) return true;
    return false;
}

}  // namespace

TEST_CASE("a render that is killed again and again ends with the pixels of one that was not") {
    const Folder folder, other;
    const std::vector<std::string> samples{"--spp", "48"};
    const auto start = std::chrono::steady_clock::now();
    REQUIRE(run_tress(render(other, samples)).exit_code == 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;

    const std::vector<std::string> resumed = render(folder, {"--spp", "48", "--checkpoint", "0.001", "--resume"});
    int killed = 0, exit_code = -1;
    for (int run = 0; run < 200 && exit_code != 0; ++run) {
        RunningCommand running(resumed);
        if (run < 8) {
            std::this_thread::sleep_for(whole * (0.2 + 0.5 * double(random(7, uint64_t(run)))));
            running.send(SIGKILL);
        }
        const CommandResult result = running.wait();
        CAPTURE(result.error);
        exit_code = result.exit_code;
        REQUIRE((exit_code == 0 || exit_code == 128 + SIGKILL));
        killed += exit_code != 0;
    }
    CHECK(killed > 0);
    CHECK(exit_code == 0);
    CHECK(pixels(folder.file("a.exr")) == pixels(other.file("a.exr")));
    CHECK_FALSE(exists(folder.file("a.checkpoint")));  // of no more use
}

TEST_CASE("a signal to stop ends a render after its pass, with picture and checkpoint, and it goes on from there") {
    const Folder folder, other;
    for (const int signal : {SIGINT, SIGTERM}) {
        for (const char* file : {"a.exr", "a.png", "a.checkpoint"}) std::filesystem::remove(folder.file(file));
        RunningCommand running(render(folder, {"--spp", "4096", "--checkpoint", "0.001"}));
        REQUIRE(wait_for(folder.file("a.checkpoint")));
        running.send(signal);
        CHECK(running.wait().exit_code == 128 + signal);
        CHECK(exists(folder.file("a.exr")));
        CHECK(exists(folder.file("a.png")));
        CHECK(exists(folder.file("a.checkpoint")));
    }
    const std::string stats = folder.file("stats.json");
    REQUIRE(run_tress(render(folder, {"--spp", "4096", "--resume", "--time", "0.001", "--stats", stats})).exit_code ==
            0);
    const int spp =
        nlohmann::json::parse(read_bytes(stats))["spp"];  // time was up before: as many as it was stopped at
    CHECK(spp > 0);
    REQUIRE(run_tress(render(other, {"--spp", std::to_string(spp)})).exit_code == 0);
    CHECK(pixels(folder.file("a.exr")) == pixels(other.file("a.exr")));
}

TEST_CASE("a checkpoint of other options is refused in one line, and stays") {
    const Folder folder;
    RunningCommand running(render(folder, {"--spp", "4096", "--checkpoint", "0.001"}));
    REQUIRE(wait_for(folder.file("a.checkpoint")));
    running.send(SIGINT);
    running.wait();
    const CommandResult r = run_tress(render(folder, {"--spp", "100", "--resume"}));
    CHECK(r.exit_code == 2);
    CHECK(r.error.find("with spp=4096, expected spp=100") != std::string::npos);
    CHECK(std::count(r.error.begin(), r.error.end(), '\n') == 1);
    CHECK(exists(folder.file("a.checkpoint")));
}

TEST_CASE("where there is no checkpoint, --resume begins") {
    const Folder folder;
    CHECK(run_tress(render(folder, {"--spp", "1", "--resume"})).exit_code == 0);
    CHECK(exists(folder.file("a.exr")));
}

TEST_CASE("a full disk is said once, the render goes on, and the last checkpoint lives") {
    const Folder folder;
    const std::string checkpoint = folder.file("a.checkpoint");
    RunningCommand first(render(folder, {"--spp", "4096", "--checkpoint", "0.001"}));
    REQUIRE(wait_for(checkpoint));
    first.send(SIGKILL);
    first.wait();
    const std::string before = read_bytes(checkpoint);
    const size_t entries = folder.entries();  // the kill may have left a part of a file, named so
    const CommandResult r = [&] {
        const FullDisk full(10000);
        return run_tress(render(folder, {"--spp", "4096", "--resume", "--checkpoint", "0.001", "--time", "0.5"}));
    }();
    CAPTURE(r.error);
    CHECK(r.exit_code == 2);  // the picture could not be written either
    CHECK(std::count(r.error.begin(), r.error.end(), '\n') == 2);
    CHECK(r.error.find("a.checkpoint: cannot be written") != std::string::npos);
    CHECK(r.error.find("a.exr") != std::string::npos);
    CHECK(read_bytes(checkpoint) == before);
    CHECK(folder.entries() == entries);
}

TEST_CASE("a folder that vanishes is said in one line") {
    const Folder folder;
    const std::string place = folder.file("place");
    std::filesystem::create_directory(place);
    std::vector<std::string> arguments = render(folder, {"--spp", "4096", "--checkpoint", "0.001"});
    arguments[3] = place + "/a.exr";
    RunningCommand running(arguments);
    REQUIRE(wait_for(place + "/a.checkpoint"));
    std::filesystem::rename(place, folder.file("gone"));
    running.send(SIGTERM);
    const CommandResult r = running.wait();
    CHECK(r.exit_code == 2);
    CHECK(r.error.find("a.exr: cannot be written") != std::string::npos);
    CHECK(exists(folder.file("gone/a.checkpoint")));
}
