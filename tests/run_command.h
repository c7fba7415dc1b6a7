// SPDX-License-Identifier: MIT
// Runs the tress command as a user would, and measures it.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

#include "tools/check/support/folder.h"

namespace tress::test {

struct CommandResult {
    int exit_code = -1;  // 128 + signal where one ended it
    std::string output, error;
    double cpu_seconds = 0;
    double peak_megabytes = 0;
};

/// The command while it runs. What it says goes to files.
class RunningCommand {
public:
    explicit RunningCommand(const std::vector<std::string>& arguments) {
        const std::string out = folder_.file("out"), err = folder_.file("err");
        child_ = fork();
        if (child_ != 0) return;
        dup2(open(out.c_str(), O_CREAT | O_WRONLY, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_CREAT | O_WRONLY, 0600), STDERR_FILENO);
        std::vector<char*> argv{const_cast<char*>(TRESS_COMMAND)};
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        execv(TRESS_COMMAND, argv.data());
        _exit(127);
    }
    ~RunningCommand() {
        if (child_ > 0) send(SIGKILL), wait();
    }
    RunningCommand(const RunningCommand&) = delete;
    RunningCommand& operator=(const RunningCommand&) = delete;

    void send(int signal) const { kill(child_, signal); }

    CommandResult wait() {
        int status = 0;
        rusage usage{};
        wait4(child_, &status, 0, &usage);
        child_ = 0;
        CommandResult result;
        result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        result.output = read_bytes(folder_.file("out"));
        result.error = read_bytes(folder_.file("err"));
        const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
        result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
        result.peak_megabytes = double(usage.ru_maxrss) / 1024;
        return result;
    }

private:
    Folder folder_;
    pid_t child_ = 0;
};

inline CommandResult run_tress(const std::vector<std::string>& arguments) { return RunningCommand(arguments).wait(); }

}  // namespace tress::test
