// SPDX-License-Identifier: MIT
#include "io/byte_reader.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/error.h"

namespace tress {
namespace {

std::string last_error() { return std::generic_category().message(errno); }

}  // namespace

ByteReader::ByteReader(const std::string& path) : path_(path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) throw InputError(path, "no such file");
    if (std::filesystem::is_directory(status)) throw InputError(path, "a directory, expected a file");
    if (!error && !std::filesystem::is_regular_file(status)) throw InputError(path, "not a plain file");
    if (!error) size_ = std::filesystem::file_size(path, error);
    if (error) throw InputError(path, "cannot be read: " + error.message());
    file_.reset(std::fopen(path.c_str(), "rb"));
    if (!file_) throw InputError(path, "cannot be opened: " + last_error());
}

void ByteReader::seek(uint64_t offset, const char* what) {
    if (offset > size_)
        fail(std::string(what) + " at byte " + std::to_string(offset) + ", expected a place within the file's " +
             std::to_string(size_) + " bytes");
    if (fseeko(file_.get(), off_t(offset), SEEK_SET) != 0) fail("cannot go to " + std::string(what));
    offset_ = offset;
}

void ByteReader::skip(uint64_t count, uint64_t bytes_each, const char* what) {
    need(count, bytes_each, what);
    seek(offset_ + count * bytes_each, what);
}

void ByteReader::need(uint64_t count, uint64_t bytes_each, const char* what) const {
    if (bytes_each == 0 || count <= remaining() / bytes_each) return;
    fail(std::to_string(count) + " x " + std::to_string(bytes_each) + " bytes of " + what +
         ", expected no more than the " + std::to_string(remaining()) + " that are left");
}

void ByteReader::read_bytes(void* out, size_t bytes, const char* what) {
    if (bytes == 0) return;
    const size_t got = std::fread(out, 1, bytes, file_.get());
    offset_ += got;
    if (got != bytes) fail(std::string("cannot read ") + what);
}

std::string ByteReader::read_rest() {
    std::string text(remaining(), '\0');
    read_bytes(text.data(), text.size(), "text");
    return text;
}

void ByteReader::fail(const std::string& problem) const {
    throw InputError(path_ + ": byte " + std::to_string(offset_), problem);
}

std::string read_text_file(const std::string& path, uint64_t largest) {
    ByteReader in(path);
    if (in.size() > largest)
        throw InputError(path, std::to_string(in.size()) + " bytes, expected at most " + std::to_string(largest));
    return in.read_rest();
}

}  // namespace tress
