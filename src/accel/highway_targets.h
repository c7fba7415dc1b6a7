// SPDX-License-Identifier: MIT
// Which instruction sets vector code is compiled for. Sources that include hwy/foreach_target.h include this first, so
// that all of them are compiled for the same ones and kernel_index() (isa_targets.h) fits their tables.
//
// All targets, the scalar one too, so that each can be asked for. Without those whose vectors have no size known to
// the compiler, and without SSSE3, which no name stands for. TRESS_FEW_TARGETS: without AVX2 and AVX-512 too, where it
// does not matter how many lanes vectors have and compiling takes long (threads under a sanitizer).
#pragma once

#define HWY_COMPILE_ALL_ATTAINABLE
#ifdef TRESS_FEW_TARGETS
#define TRESS_WIDE_TARGETS (HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define TRESS_WIDE_TARGETS 0
#endif
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | TRESS_WIDE_TARGETS)
