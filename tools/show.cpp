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
    std::string picture, output;
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

void paste(const Image& panel, int left, Image& to) {
    for (int y = 0; y < panel.height; ++y)
        for (int x = 0; x < panel.width; ++x) to.at(left + x, y) = panel.at(x, y);
}

void show(ShowArguments arguments) {
    if (!(std::abs(arguments.exposure) <= kMostStops))
        throw InputError("--exposure", std::to_string(arguments.exposure) + ", expected a number from -40 to 40");
    check_writable(arguments.output);
    if (arguments.panels.empty()) arguments.panels = {""};
    const LayeredImage picture = read_exr(arguments.picture);
    Image all = make_image(picture.width * int(arguments.panels.size()), picture.height);
    for (size_t i = 0; i < arguments.panels.size(); ++i)
        paste(tone_map(panel_image(picture, arguments.panels[i], arguments.picture), arguments.exposure),
              picture.width * int(i), all);
    write_png(arguments.output, all);
}

}  // namespace

void add_show_command(CLI::App& app) {
    const auto arguments = std::make_shared<ShowArguments>();
    CLI::App* command = app.add_subcommand("show", "layers of a picture as a PNG, side by side");
    command->add_option("picture", arguments->picture, "OpenEXR file")->required();
    command->add_option("-o,--output", arguments->output, "the PNG")->required();
    command
        ->add_option("--panel", arguments->panels,
                     "a layer, or a sum of some: type1+type2; again for one more to the right; without: the beauty")
        ->expected(1)
        ->take_all();
    command->add_option("--exposure", arguments->exposure, "stops");
    command->callback([arguments] { show(*arguments); });
}

}  // namespace tress
