// SPDX-License-Identifier: MIT
// Bytes of a fuzzer as a file that a reader opens.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"

namespace tress::fuzz {

/// A file in memory, its bytes replaced as often as wished.
class InputFile {
public:
    /// `name`: for messages alone.
    explicit InputFile(const char* name) : descriptor_(memfd_create(name, 0)) {
        if (descriptor_ < 0) std::abort();
        path_ = "/proc/self/fd/" + std::to_string(descriptor_);
    }
    ~InputFile() { close(descriptor_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& set(const uint8_t* data, size_t size) const {
        if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, data, size, 0) != ssize_t(size)) std::abort();
        return path_;
    }

private:
    int descriptor_;
    std::string path_;
};

/// Has a reader read the bytes: it may refuse them, by an InputError whose message is one line, and nothing else.
template <class Read>
int try_file(const uint8_t* data, size_t size, const Read& read) {
    static const InputFile file("input");
    try {
        read(file.set(data, size));
    } catch (const InputError& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}

}  // namespace tress::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
