// SPDX-License-Identifier: MIT
// Whether this is compiled for a sanitizer. Then the memory and the time of a process say little: what is freed is kept
// back for a while, and all memory has shadows.
#pragma once

namespace tress::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace tress::test
