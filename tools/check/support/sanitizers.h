// SPDX-License-Identifier: MIT
// Whether this is compiled for a sanitizer. Then the memory and the time of a process say little: what is freed is kept
// back for a while, and all memory has shadows.
#pragma once

namespace tress::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // GCC
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)  // Clang
inline constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace tress::test
