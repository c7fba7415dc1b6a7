// SPDX-License-Identifier: MIT
#include "tools/study/methods/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace tress {
namespace {

constexpr const char* kThisProgram = "/proc/self/exe";
constexpr int kNoProgram = 127;

std::string last_line(const std::string& text) {
    const size_t end = text.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const size_t before = text.rfind('\n', end);
    return text.substr(before == std::string::npos ? 0 : before + 1,
                       end - (before == std::string::npos ? 0 : before + 1) + 1);
}

/// Of the child, between fork and exec: only what is safe there.
[[noreturn]] void become(char* const* arguments, int error_pipe, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(kNoProgram);  // it ended before the line above
    dup2(error_pipe, STDERR_FILENO);
    execv(kThisProgram, arguments);
    _exit(kNoProgram);
}

std::string read_all(int descriptor) {
    constexpr size_t kKept = 1 << 16;
    std::string text;
    char buffer[4096];
    for (;;) {
        const ssize_t count = read(descriptor, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(buffer, size_t(count));
        if (text.size() > 2 * kKept) text.erase(0, text.size() - kKept);
    }
}

}  // namespace

ChildResult run_self(const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>(kThisProgram)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    int error_pipe[2];
    if (pipe2(error_pipe, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a process of its own");
    const pid_t parent = getpid(), child = fork();
    if (child == 0) become(words.data(), error_pipe[1], parent);
    close(error_pipe[1]);
    const std::string said = child > 0 ? read_all(error_pipe[0]) : "";
    close(error_pipe[0]);
    if (child < 0) throw std::runtime_error("no process of its own");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), last_line(said)};
}

}  // namespace tress
