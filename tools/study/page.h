// SPDX-License-Identifier: MIT
// The page of a study: one HTML file that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "core/image.h"
#include "io/plot/svg_plot.h"
#include "tools/study/html.h"

namespace tress {

/// A picture for the page's viewer. The first of a page is the reference.
struct PagePicture {
    std::string name;
    LayeredImage layers;
};

struct PagePlot {
    Plot plot;
    std::string file;     // name of the SVG beside the page
    std::string caption;  // HTML
};

struct Page {
    std::string title;
    std::vector<std::string> facts;  // what was studied and by what, text
    std::string verdict;             // HTML; empty: none
    std::vector<std::string> notes;  // HTML, below the verdict
    std::vector<Table> tables;
    std::vector<PagePlot> plots;
    std::vector<PagePicture> pictures;
    float exposure = 0;  // stops, of the viewer at first
    bool plots_first = false;
};

std::string to_html(const Page& page);

/// Writes index.html and the plots into the folder.
void write_page(const Page& page, const std::string& folder);

}  // namespace tress
