// SPDX-License-Identifier: MIT
#include "tools/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tress {
namespace {

constexpr int kBarWidth = 30;
constexpr double kLineStep = 0.1;  // a plain line every tenth

std::string clock_text(double seconds) {
    char text[32];
    const long whole = long(std::min(seconds, 1e9) + 0.5);
    if (whole >= 3600)
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    return text;
}

}  // namespace

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

void Progress::update(double done, const std::string& note) {
    if (quiet_) return;
    done = std::clamp(done, 0.0, 1.0);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const std::string left = done > 0 ? clock_text(elapsed * (1 - done) / done) + " left, " : "";
    if (terminal_) {
        const int filled = int(done * kBarWidth);
        const std::string bar = std::string(size_t(filled), '=') + std::string(size_t(kBarWidth - filled), ' ');
        std::fprintf(stderr, "\r%s [%s] %3.0f %%  %s%s\033[K", what_.c_str(), bar.c_str(), 100 * done, left.c_str(),
                     note.c_str());
        std::fflush(stderr);
    } else if (done - last_shown_ >= kLineStep) {
        last_shown_ = done;
        std::fprintf(stderr, "%s: %.0f %%, %s%s\n", what_.c_str(), 100 * done, left.c_str(), note.c_str());
    }
}

void Progress::finish(const std::string& note) {
    if (quiet_) return;
    std::fprintf(stderr, "%s%s: %s%s\n", terminal_ ? "\r" : "", what_.c_str(), note.c_str(), terminal_ ? "\033[K" : "");
}

}  // namespace tress
