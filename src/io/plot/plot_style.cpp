// SPDX-License-Identifier: MIT
#include "io/plot/plot_style.h"

namespace tress::svg {
namespace {

struct Palette {
    const char *ground, *ink, *quiet, *grid;
    std::array<const char*, kColors> series;
};
// After Okabe and Ito, spread in lightness so that colour-blind people can tell them apart; at least 3:1 with the
// ground.
constexpr Palette kLight = {"#ffffff",
                            "#22262b",
                            "#5b636d",
                            "#e3e6ea",
                            {"#352fca", "#fa2f00", "#009178", "#805e96", "#739b30", "#286ccd", "#3a3a3a", "#4a1169"}};
constexpr Palette kDark = {"#16191e",
                           "#e6e9ed",
                           "#a3abb5",
                           "#2c323a",
                           {"#7c66ff", "#e05e07", "#20f58b", "#bf5894", "#f7d903", "#6fa3fa", "#f2f2f2", "#a3835c"}};

/// Rules of one theme. No character here means anything to HTML or XML.
std::string theme(const Palette& colors) {
    const std::string ground = colors.ground, ink = colors.ink, quiet = colors.quiet, grid = colors.grid;
    std::string css = ".plot .ground{fill:" + ground + "}.plot text{fill:" + ink + "}.plot .tick{fill:" + quiet +
                      "}.plot .grid{stroke:" + grid + "}.plot .axis{stroke:" + quiet + "}.plot .mark{stroke:" + ground +
                      "}.plot .hollow{fill:" + ground + ";stroke:currentColor}\n";
    for (size_t c = 0; c < kColors; ++c) css += ".plot .s" + std::to_string(c) + "{color:" + colors.series[c] + '}';
    return css + '\n';
}

}  // namespace

std::string style() {
    return "<style>\n"
           ".plot text{font:11px system-ui,\"Segoe UI\",Roboto,\"Helvetica Neue\",Arial,sans-serif}"
           ".plot .title{font-size:15px;font-weight:600}.plot .sup{font-size:8px}.plot .empty{font-size:15px}\n"
           ".plot .grid,.plot .axis{fill:none;stroke-width:1}"
           ".plot .line,.plot .curve,.plot .bar,.plot .floor{fill:none;stroke:currentColor;stroke-linejoin:round}\n"
           ".plot .line{stroke-width:2}.plot .curve{stroke-width:1.1}.plot .bar{stroke-width:1.2}"
           ".plot .floor{stroke-width:1.1;stroke-dasharray:5 4}"
           ".plot .d1{stroke-dasharray:7 3}.plot .d2{stroke-dasharray:2 2.5}.plot .d3{stroke-dasharray:8 2 2 2}\n"
           ".plot .mark{fill:currentColor;stroke-width:.8}.plot .hollow{stroke-width:1.5}"
           ".plot .hit{fill:none;pointer-events:all}\n"
           ".plot .legend{cursor:pointer}.plot .series.off{display:none}.plot .legend.off{opacity:.35}\n" +
           theme(kLight) + "@media (prefers-color-scheme:dark){\n" + theme(kDark) + "}\n@media print{\n" +
           theme(kLight) + "}\n</style>\n";
}

}  // namespace tress::svg
