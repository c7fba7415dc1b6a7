// SPDX-License-Identifier: MIT
#include <cstdio>

#include "tests/fuzz/seeds.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
        return 2;
    }
    tress::fuzz::write_seeds(argv[1]);
    return 0;
}
