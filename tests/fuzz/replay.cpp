// SPDX-License-Identifier: MIT
// Stands in for the fuzzer: gives its target each file of a folder, and every beginning of it, once.
#include <cstdio>
#include <filesystem>

#include "tests/fuzz/input_file.h"
#include "tools/check/support/folder.h"

int main(int argc, char** argv) {
    size_t inputs = 0;
    for (int i = 1; i < argc; ++i)
        for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
            const std::string bytes = tress::test::read_bytes(entry.path().string());
            for (size_t length = 0; length <= bytes.size(); ++length, ++inputs)
                LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), length);
        }
    std::printf("%zu inputs\n", inputs);
    return inputs > 0 ? 0 : 1;
}
