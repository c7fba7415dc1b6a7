// SPDX-License-Identifier: MIT
// --set KEY=VALUE, as the command line has it: a line each.
#include <sstream>

#include "tests/fuzz/input_file.h"
#include "tools/scene_arguments.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    tress::Options options;
    std::istringstream lines(std::string(reinterpret_cast<const char*>(data), size));
    for (std::string line; std::getline(lines, line);) {
        try {
            tress::set_option(options, line);
        } catch (const tress::InputError&) {
        }
    }
    // What was taken is told again in the same words.
    tress::Options again;
    std::istringstream told(tress::options_text(options));
    for (std::string line; std::getline(told, line);) tress::set_option(again, line);
    if (tress::options_text(again) != tress::options_text(options)) std::abort();
    return 0;
}
