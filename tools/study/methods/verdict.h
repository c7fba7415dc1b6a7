// SPDX-License-Identifier: MIT
// What the numbers of a study say, in a paragraph.
#pragma once

#include <vector>

#include "tools/study/study_log.h"

namespace tress {

/// {"line": "verdict", "text", "reference": {"whole": {"error", "smallest_shown", "share"}, ...},
/// "reference_is_enough"}: which rows are worth it, which are not and why, and the paper's comparisons beside ours. The
/// reference is enough where its error is at most a tenth of the smallest error shown, in every layer.
Json verdict_of(const std::vector<Json>& rows, const Json& reference);

}  // namespace tress
