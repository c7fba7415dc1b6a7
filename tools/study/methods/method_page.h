// SPDX-License-Identifier: MIT
// The page of a study of methods: tables and plots of its results.
#pragma once

#include "tools/study/methods/row_result.h"
#include "tools/study/page.h"

namespace tress {

struct MethodResults {
    Json header, reference;
    std::vector<Json> rows;  // row_result.h
    Json verdict;            // verdict.h
};

/// Without pictures.
Page make_method_page(const MethodResults& results, const std::vector<MeasuredRow>& rows);

}  // namespace tress
