// SPDX-License-Identifier: MIT
#include "core/aligned_array.h"

#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace tress {
namespace {
constexpr size_t kCacheLine = 64, kHugePage = size_t(2) << 20;
}

void* allocate_aligned(size_t bytes) {
    const size_t alignment = bytes >= kHugePage ? kHugePage : kCacheLine;
    const size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == kHugePage) madvise(memory, rounded, MADV_HUGEPAGE);  // advice: failing is harmless
#endif
    std::memset(memory, 0, rounded);
    return memory;
}

void free_aligned(void* memory) { std::free(memory); }

}  // namespace tress
