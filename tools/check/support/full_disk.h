// SPDX-License-Identifier: MIT
// A disk that is full: files of this process that grow beyond a few bytes are refused, as long as this lives.
#pragma once

#include <sys/resource.h>

#include <csignal>
#include <stdexcept>

namespace tress::test {

class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {  // an error of write, no signal
        if (getrlimit(RLIMIT_FSIZE, &old_) != 0) throw std::runtime_error("no limit of files' sizes can be read");
        const rlimit small{bytes, old_.rlim_max};
        if (setrlimit(RLIMIT_FSIZE, &small) != 0) throw std::runtime_error("no limit of files' sizes can be set");
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*old_handler_)(int);
    rlimit old_{};
};

}  // namespace tress::test
