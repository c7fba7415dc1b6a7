// SPDX-License-Identifier: MIT
#include "tools/show.h"

#include <cmath>
#include <memory>
#include <sstream>

#include "core/error.h"
#include "core/layer_image.h"
#include "core/tone_map.h"
#include "io/exr_file.h"
#include "io/png_file.h"
#include "io/whole_file.h"

namespace tress {
namespace {

constexpr float kMostStops = 40;

struct ShowArguments {
    std::vector<std::string> pictures;
    std::string output;
    std::vector<std::string> panels;  // each: names of layers with + between; empty: the beauty
    float exposure = 0;
};

/// The sum of layers "type1+type2".
Image panel_image(const LayeredImage& picture, const std::string& names, const std::string& where) {
    Image sum = make_image(picture.width, picture.height);
    std::istringstream list(names.empty() ? "+" : names);
    for (std::string name; std::getline(list, name, '+');) {
        const Image layer = layer_image(picture, name, where);
        for (size_t i = 0; i < sum.pixel.size(); ++i) sum.pixel[i] += layer.pixel[i];
    }
    return sum;
}

/// From left to right, as high as the highest.
Image side_by_side(const std::vector<Image>& panels) {
    int width = 0, height = 0;
    for (const Image& panel : panels) width += panel.width, height = std::max(height, panel.height);
    Image all = make_image(width, height);
    int left = 0;
    for (const Image& panel : panels) {
        for (int y = 0; y < panel.height; ++y)
            for (int x = 0; x < panel.width; ++x) all.at(left + x, y) = panel.at(x, y);
        left += panel.width;
    }
    return all;
}

void show(ShowArguments arguments) {
    if (!(std::abs(arguments.exposure) <= kMostStops))
        throw InputError("--exposure", std::to_string(arguments.exposure) + ", expected a number from -40 to 40");
    check_writable(arguments.output);
    if (arguments.panels.empty()) arguments.panels = {""};
    std::vector<Image> panels;
    for (const std::string& name : arguments.pictures) {
        const LayeredImage picture = read_exr(name);
        for (const std::string& panel : arguments.panels)
            panels.push_back(tone_map(panel_image(picture, panel, name), arguments.exposure));
    }
    write_png(arguments.output, side_by_side(panels));
}

}  // namespace

void add_show_command(CLI::App& app) {
    const auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand("show", "layers of pictures as a PNG, side by side");
    command->add_option("picture", arguments->pictures, "OpenEXR files")->required();
    command->add_option("-o,--output", arguments->output, "the PNG")->required();
    command
        ->add_option("--panel", arguments->panels,
                     "a layer, or a sum of some: type1+type2; again for one more to the right; without: the beauty")
        ->allow_extra_args(false);
    command->add_option("--exposure", arguments->exposure, "stops");
    command->callback([arguments] { show(*arguments); });
}

}  // namespace tress
