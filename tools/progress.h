// SPDX-License-Identifier: MIT
// How far a long piece of work is: a bar with the time left on a terminal, plain lines elsewhere, nothing when quiet.
#pragma once

#include <chrono>
#include <string>

namespace tress {

class Progress {
public:
    Progress(std::string what, bool quiet);
    /// `done` in [0, 1]; `note` stands behind the bar.
    void update(double done, const std::string& note);
    void finish(const std::string& note);

private:
    std::string what_;
    bool quiet_, terminal_;
    std::chrono::steady_clock::time_point start_;
    double last_shown_ = -1;
};

}  // namespace tress
