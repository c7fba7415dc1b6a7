// SPDX-License-Identifier: MIT
// The page of a study of methods: tables and plots of its results.
#pragma once

#include "tools/study/page.h"
#include "tools/study/row_result.h"

namespace tress {

struct MethodResults {
    Json header, reference;
    std::vector<Json> rows;  // row_result.h
    Json verdict;            // verdict.h
};

struct MethodPage {
    Page page;                            // without pictures
    std::vector<std::string> plot_files;  // names, one a plot
};

MethodPage make_method_page(const MethodResults& results, const std::vector<MeasuredRow>& rows);

/// What was studied and by what, a line each.
std::vector<std::string> facts(const Json& header);

}  // namespace tress
