// SPDX-License-Identifier: MIT
// Reads a binary file from front to back. Counts are checked against the length of the file before anything is
// allocated for them, and every message names the file and the byte.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tress {

class ByteReader {
public:
    /// Throws InputError where `path` is missing, not a plain file, or cannot be opened.
    explicit ByteReader(const std::string& path);

    const std::string& path() const { return path_; }
    uint64_t size() const { return size_; }
    uint64_t offset() const { return offset_; }
    uint64_t remaining() const { return size_ - offset_; }

    std::endian order = std::endian::little;  // of the numbers in the file

    /// Goes to a byte of the file; one past the end of it is the last allowed.
    void seek(uint64_t offset, const char* what);
    void skip(uint64_t count, uint64_t bytes_each, const char* what);

    /// Throws unless `count` things of `bytes_each` are left. The product is never formed: it might not fit.
    void need(uint64_t count, uint64_t bytes_each, const char* what) const;

    template <class T, size_t N>
    void read(std::span<T, N> out, const char* what) {
        static_assert(std::is_arithmetic_v<T>);
        need(out.size(), sizeof(T), what);
        read_bytes(out.data(), out.size_bytes(), what);
        if (sizeof(T) > 1 && order != std::endian::native)
            for (T& value : out) value = reversed(value);
    }
    template <class T>
    T read(const char* what) {
        T value{};
        read(std::span<T>(&value, 1), what);
        return value;
    }
    template <class T>
    std::vector<T> read_vector(uint64_t count, const char* what) {
        need(count, sizeof(T), what);
        std::vector<T> values(count);
        read(std::span<T>(values), what);
        return values;
    }
    /// All that is left of the file.
    std::string read_rest();

    [[noreturn]] void fail(const std::string& problem) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    template <class T>
    static T reversed(T value) {
        auto* bytes = reinterpret_cast<unsigned char*>(&value);
        std::reverse(bytes, bytes + sizeof(T));
        return value;
    }
    void read_bytes(void* out, size_t bytes, const char* what);

    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    uint64_t size_ = 0, offset_ = 0;
};

/// A whole text file; throws InputError where it is longer than `largest` bytes.
std::string read_text_file(const std::string& path, uint64_t largest);

}  // namespace tress
