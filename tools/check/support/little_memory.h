// SPDX-License-Identifier: MIT
// Little memory to be had: as long as this lives, the process gets no more than some bytes of it. What asks for more
// throws std::bad_alloc, whether it would have touched the memory or not.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace tress::test {

class LittleMemory {
public:
    explicit LittleMemory(rlim_t more_bytes) {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        if (pages == 0 || getrlimit(RLIMIT_AS, &old_) != 0) throw std::runtime_error("memory in use cannot be read");
        const rlimit limit{pages * rlim_t(sysconf(_SC_PAGESIZE)) + more_bytes, old_.rlim_max};
        if (setrlimit(RLIMIT_AS, &limit) != 0) throw std::runtime_error("no limit of memory can be set");
    }
    ~LittleMemory() { setrlimit(RLIMIT_AS, &old_); }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;

private:
    rlimit old_{};
};

/// The most memory that this process has held so far, bytes.
inline double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * double(usage.ru_maxrss);
}

}  // namespace tress::test
