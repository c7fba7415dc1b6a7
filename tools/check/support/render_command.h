// SPDX-License-Identifier: MIT
// `tress render` as a user runs it, but in this process.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "core/error.h"
#include "tools/check/support/folder.h"
#include "tools/render.h"

namespace tress::test {

/// What is written to stderr while it lives.
class SaidOnStderr {
public:
    SaidOnStderr() : before_(dup(STDERR_FILENO)), file_(std::tmpfile()) {
        if (before_ < 0 || !file_) throw std::runtime_error("stderr cannot be kept");
        std::fflush(stderr);
        dup2(fileno(file_), STDERR_FILENO);
    }
    ~SaidOnStderr() {
        dup2(before_, STDERR_FILENO);
        close(before_);
        std::fclose(file_);
    }
    SaidOnStderr(const SaidOnStderr&) = delete;
    SaidOnStderr& operator=(const SaidOnStderr&) = delete;

    std::string text() const {
        std::fflush(stderr);
        std::string said(size_t(lseek(fileno(file_), 0, SEEK_END)), '\0');
        if (pread(fileno(file_), said.data(), said.size(), 0) < 0) throw std::runtime_error("stderr cannot be read");
        return said;
    }

private:
    int before_;
    std::FILE* file_;
};

struct CommandEnd {
    int exit_code = 0;
    std::string error;  // what it said on stderr

    size_t lines_with(const std::string& part) const {
        std::istringstream lines(error);
        size_t found = 0;
        for (std::string line; std::getline(lines, line);) found += line.find(part) != std::string::npos;
        return found;
    }
};

/// "render" and `arguments`; exit codes are those of main().
inline CommandEnd run_render(std::vector<std::string> arguments) {
    constexpr int kBadInput = 2;
    CLI::App app("", "tress");
    add_render_command(app);
    arguments.insert(arguments.begin(), "render");
    std::reverse(arguments.begin(), arguments.end());  // as CLI::App::parse takes them
    const SaidOnStderr said;
    CommandEnd end;
    try {
        app.parse(arguments);
    } catch (const InputError& error) {
        end = {kBadInput, error.what()};
    }
    end.error = said.text() + end.error;
    return end;
}

}  // namespace tress::test
