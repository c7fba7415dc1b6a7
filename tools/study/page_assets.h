// SPDX-License-Identifier: MIT
// page/page.css and the scripts beside it as text in the program: cmake/PageAssets.cmake writes the source.
#pragma once

namespace tress {
extern const char* const kPageCss;
extern const char* const kPageScript;
}  // namespace tress
