// SPDX-License-Identifier: MIT
#include "io/checkpoint_file.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/seeds.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return tress::fuzz::try_file(data, size, [](const std::string& path) {
        tress::Film film = tress::fuzz::checkpoint_film();
        tress::read_checkpoint(path, tress::fuzz::kCheckpointMadeBy, film);
    });
}
