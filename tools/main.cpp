// SPDX-License-Identifier: MIT
// The tress command: one subcommand a file. Exit code 0: done; 1: a check failed, or the program is wrong; 2: bad usage
// or bad input, said in one line; 128 + a signal: told to stop by it, and what there was is written.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "core/error.h"
#include "tools/check/check.h"
#include "tools/compare.h"
#include "tools/groom.h"
#include "tools/info.h"
#include "tools/interrupt.h"
#include "tools/plan.h"
#include "tools/render.h"
#include "tools/show.h"
#include "tools/study/study.h"
#include "tools/trace.h"

namespace {

constexpr int kBadInput = 2, kInternal = 1, kSignalled = 128;

int fail(int code, const std::string& message) {
    std::fprintf(stderr, "tress: %s\n", message.substr(0, message.find('\n')).c_str());
    return code;
}

int run(int argc, char** argv) {
    CLI::App app("Renders hair with global illumination on any CPU.", "tress");
    app.require_subcommand(1);
    app.set_version_flag("--version", TRESS_VERSION);
    app.failure_message([](const CLI::App*, const CLI::Error& error) { return std::string(error.what()); });
    tress::add_render_command(app);
    tress::add_plan_command(app);
    tress::add_info_command(app);
    tress::add_groom_command(app);
    tress::add_compare_command(app);
    tress::add_show_command(app);
    tress::add_study_command(app);
    tress::add_trace_command(app);
    tress::add_check_command(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        return app.exit(help_or_version);
    } catch (const CLI::RuntimeError& ended) {  // a command's own exit code; all is said
        return ended.get_exit_code();
    } catch (const CLI::ParseError& error) {
        return fail(kBadInput, error.what());
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const tress::InputError& error) {
        return fail(kBadInput, error.what());
    } catch (const tress::Interrupted& interrupted) {
        return kSignalled + interrupted.signal;
    } catch (const std::bad_alloc&) {
        return fail(kInternal, "out of memory");
    } catch (const std::exception& error) {
        return fail(kInternal, std::string("internal error: ") + error.what());
    }
}
