// SPDX-License-Identifier: MIT
// A row of a study: what it is called, and what options it sets over the scene's.
#pragma once

#include <string>
#include <vector>

#include "core/options.h"

namespace tress {

struct StudyRow {
    std::string name;                   // "RT / P / –, projection.cells=64"
    std::vector<std::string> settings;  // "key=value"
    double paper_seconds = 0;           // of the paper's table; 0: not in it
};

/// The paper's names of the methods of Types 1 to 3, and of 4 and 5 where they are on: RT ray tracing, DSM deep shadow
/// maps, P projection; ours: OSM opacity shadow maps, CD clustered densities, PT path tracing, PM photons; – off.
std::string method_name(const Options& options);

/// The six rows of the paper (Yuksel, Akleman, Keyser 2007, Table 1), with its times.
std::vector<StudyRow> paper_rows();

/// Every combination of methods of Types 1 to 3, but those of no type and those by paths.
std::vector<StudyRow> all_rows();

/// A row from words: "RT/P/-" (methods in the paper's names), "key=value". Throws InputError.
StudyRow parse_row(const std::string& text);

/// Each row at each point of the grid.
std::vector<StudyRow> across(const std::vector<StudyRow>& rows, const std::vector<std::vector<std::string>>& points);

/// `base` with the row's settings.
Options options_of(const StudyRow& row, Options base);

}  // namespace tress
