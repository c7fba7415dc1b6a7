// SPDX-License-Identifier: MIT
// Runs the tress command as a user would, and measures it.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "tests/folder.h"

namespace tress::test {

struct CommandResult {
    int exit_code = -1;  // 128 + signal where one ended it
    std::string output, error;
    double cpu_seconds = 0;
    double peak_megabytes = 0;
};

inline CommandResult run_tress(const std::vector<std::string>& arguments) {
    const Folder folder;
    const std::string out = folder.file("out"), err = folder.file("err");
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(out.c_str(), O_CREAT | O_WRONLY, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_CREAT | O_WRONLY, 0600), STDERR_FILENO);
        std::vector<char*> argv{const_cast<char*>(TRESS_COMMAND)};
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        execv(TRESS_COMMAND, argv.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    CommandResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.output = read_bytes(out);
    result.error = read_bytes(err);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    result.peak_megabytes = double(usage.ru_maxrss) / 1024;
    return result;
}

}  // namespace tress::test
