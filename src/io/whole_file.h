// SPDX-License-Identifier: MIT
// A file that is written whole or not at all: bytes go to a file beside the target, which takes the target's place
// only once everything is on the disk. Until then, and after any failure, the target is as it was.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace tress {

class WholeFile {
public:
    /// Throws InputError where a file cannot be made at `path`.
    explicit WholeFile(const std::string& path);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    void write(const void* data, size_t bytes);
    void seek(uint64_t offset);
    uint64_t offset();

    /// Puts the file in its place. Nothing may be written after it.
    void commit();

private:
    [[noreturn]] void fail(const char* what) const;

    std::string path_, target_, temporary_;  // as named by the user; behind links; beside the target
    std::FILE* file_ = nullptr;
};

/// Throws InputError where WholeFile could not write `path`: to be called before long work whose result goes there.
void check_writable(const std::string& path);

void write_text_file(const std::string& path, std::string_view text);

}  // namespace tress
