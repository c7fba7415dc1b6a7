// SPDX-License-Identifier: MIT
#include "io/ply_file.h"
#include "tests/fuzz/input_file.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return tress::fuzz::try_file(data, size, [](const std::string& path) { tress::read_ply_file(path); });
}
