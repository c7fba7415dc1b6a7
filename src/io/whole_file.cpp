// SPDX-License-Identifier: MIT
#include "io/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/error.h"

namespace tress {
namespace {

constexpr int kNameAttempts = 100;  // temporary names tried: others may be left from processes that were killed
constexpr mode_t kNewFileMode = 0666, kPermissionBits = 07777;

/// The file that `path` stands for: links are followed, so that it is the linked file that is replaced.
std::string behind_links(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_symlink(path, error)) return path;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
    return error ? path : target.string();
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(path), target_(behind_links(path)) {
    if (path.empty()) throw InputError("output", "a file without a name, expected one");
    struct stat old {};
    const bool exists = stat(target_.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) throw InputError(path_, "a directory, expected a file to write");
    if (exists && !S_ISREG(old.st_mode)) throw InputError(path_, "not a plain file, expected a file to write");
    if (exists && access(target_.c_str(), W_OK) != 0) fail("cannot be written");

    int descriptor = -1;
    for (int attempt = 0; descriptor < 0 && attempt < kNameAttempts; ++attempt) {
        temporary_ = target_ + ".part" + std::to_string(getpid()) + "-" + std::to_string(attempt);
        descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
        if (descriptor < 0 && errno != EEXIST) break;
    }
    if (descriptor < 0) fail("cannot be written");
    if (exists) (void)!fchmod(descriptor, old.st_mode & kPermissionBits);  // as it was; failing does no harm
    file_ = fdopen(descriptor, "wb");
    if (file_) return;
    ::close(descriptor);
    unlink(temporary_.c_str());
    fail("cannot be written");
}

WholeFile::~WholeFile() {
    if (!file_) return;
    std::fclose(file_);
    unlink(temporary_.c_str());
}

void WholeFile::write(const void* data, size_t bytes) {
    if (bytes > 0 && std::fwrite(data, 1, bytes, file_) != bytes) fail("cannot be written");
}

void WholeFile::seek(uint64_t offset) {
    if (fseeko(file_, off_t(offset), SEEK_SET) != 0) fail("cannot be written");
}

uint64_t WholeFile::offset() {
    const off_t offset = ftello(file_);
    if (offset < 0) fail("cannot be written");
    return uint64_t(offset);
}

void WholeFile::commit() {
    // Some file systems cannot sync and say EINVAL; what they hold is then as safe as it gets.
    if (std::fflush(file_) != 0 || (fsync(fileno(file_)) != 0 && errno != EINVAL)) fail("cannot be written");
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) == 0 && std::rename(temporary_.c_str(), target_.c_str()) == 0) return;
    const int error = errno;
    unlink(temporary_.c_str());
    errno = error;
    fail("cannot be written");
}

void WholeFile::fail(const char* what) const {
    throw InputError(path_, std::string(what) + ": " + std::generic_category().message(errno));
}

void check_writable(const std::string& path) { WholeFile probe(path); }

void write_text_file(const std::string& path, std::string_view text) {
    WholeFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

}  // namespace tress
