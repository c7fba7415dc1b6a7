// SPDX-License-Identifier: MIT
// Time that threads spend in the stages of the pixel loop.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace tress {

enum class LoopStage : size_t {
    camera_rays,
    type1,
    sky,
    projection,
    gather_rays,
    polygon_gather,
    crossing_gather,
    photon_display,
    paths,
    count
};

/// Nanoseconds summed over threads, one a stage.
struct StageClocks {
    std::array<std::atomic<uint64_t>, size_t(LoopStage::count)> nanoseconds{};
};

/// Books the time of its own life.
class StageTimer {
public:
    StageTimer(StageClocks& clocks, LoopStage stage)
        : sum_(clocks.nanoseconds[size_t(stage)]), start_(std::chrono::steady_clock::now()) {}
    ~StageTimer() {
        const auto life = std::chrono::steady_clock::now() - start_;
        sum_ += uint64_t(std::chrono::duration_cast<std::chrono::nanoseconds>(life).count());
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    std::atomic<uint64_t>& sum_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace tress
