// SPDX-License-Identifier: MIT
#include "tools/check/check.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "accel/isa_targets.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "tools/check/check_report.h"
#include "tools/check/check_rows.h"
#include "tools/machine.h"

namespace tress {
namespace {

constexpr int kRowFailed = 1;  // exit code

struct CheckArguments {
    std::vector<std::string> only;
    std::string isa = "auto";
    int threads = 0;
    bool json = false, markdown = false;
};

std::vector<CheckRow> chosen(const std::vector<std::string>& only) {
    std::vector<CheckRow> rows = check_rows();
    for (const std::string& id : only)
        if (std::none_of(rows.begin(), rows.end(), [&](const CheckRow& row) { return row.id == id; }))
            throw InputError("--only", "no row '" + id + "', expected one of D1 to " + rows.back().id);
    if (!only.empty())
        std::erase_if(rows,
                      [&](const CheckRow& row) { return std::find(only.begin(), only.end(), row.id) == only.end(); });
    return rows;
}

CheckedRow measured(const CheckRow& row, const CheckSettings& settings) {
    const auto start = std::chrono::steady_clock::now();
    CheckedRow checked{row, {}, {}, 0};
    try {
        checked.outcome = row.measure(settings);
    } catch (const std::exception& error) {
        checked.thrown = error.what();
    }
    checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return checked;
}

void run(const CheckArguments& arguments) {
    Options options;
    set_option(options, "--isa", "isa", arguments.isa);
    const CheckSettings settings{used_isa(options.isa)};
    const auto threads = arguments.threads > 0
                             ? size_t(arguments.threads)
                             : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CheckReport report{processor_name(), compiler_name(), std::string(isa_name(settings.isa)), int(threads), {}};
    for (const CheckRow& row : chosen(arguments.only)) {
        report.rows.push_back(measured(row, settings));
        if (!arguments.json && !arguments.markdown)
            std::fputs(to_text(report.rows.back()).c_str(), stdout), std::fflush(stdout);
    }
    if (arguments.json) std::printf("%s\n", to_json(report).dump(2).c_str());
    if (arguments.markdown) std::fputs(to_markdown(report).c_str(), stdout);
    if (!arguments.json && !arguments.markdown) std::printf("%s\n", summary(report).c_str());
    if (!passes(report)) throw CLI::RuntimeError(kRowFailed);
}

}  // namespace

void add_check_command(CLI::App& app) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand("check", "stiff and extreme cases, each measured here against its bound");
    command->add_option("--only", arguments->only, "one row, such as D6; may be given again")->allow_extra_args(false);
    command->add_option("--isa", arguments->isa, "instruction set: auto, scalar, sse4, avx2, avx512");
    command->add_option("--threads", arguments->threads, "[all]")->check(CLI::Range(0, 1024));
    command->add_flag("--json", arguments->json, "as JSON");
    command->add_flag("--markdown", arguments->markdown, "as the table of docs/extremes.md")->excludes("--json");
    command->footer("Exit code 1 where a row fails.");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace tress
