// SPDX-License-Identifier: MIT
#include "tools/compare.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/layer_image.h"
#include "io/exr_file.h"
#include "io/png_file.h"
#include "tools/comparison.h"

namespace tress {
namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
    std::string reference, test, layer, diff;
    bool json = false;
};

Json to_json(const Comparison& c) {
    Json exposures = Json::array();
    for (int i = 0; i < c.flip.exposures.count; ++i) exposures.push_back(c.flip.exposures.at(i));
    return {{"relmse", c.error.relmse},
            {"relmse_trimmed", c.error.relmse_trimmed},
            {"rmse", c.error.rmse},
            {"psnr", json_number(c.error.psnr)},
            {"peak", c.error.peak},
            {"mean_ratio", json_number(c.error.mean_ratio)},
            {"flip", c.flip.flip.mean},
            {"exposures", exposures},
            {"pixels_per_degree", kFlipPixelsPerDegree}};
}

void print_text(const Comparison& c) {
    const FlipExposures& exposures = c.flip.exposures;
    std::printf("relMSE      %.6g\n", c.error.relmse);
    std::printf("  trimmed   %.6g   without the worst 0.01 %% of pixels\n", c.error.relmse_trimmed);
    std::printf("RMSE        %.6g\n", c.error.rmse);
    std::printf("PSNR        %.2f dB   peak %.6g\n", c.error.psnr, c.error.peak);
    std::printf("mean ratio  %.6f   test / reference\n", c.error.mean_ratio);
    std::printf("HDR-FLIP    %.6f   %d exposures from %+.2f to %+.2f stops, %g pixels a degree\n", c.flip.flip.mean,
                exposures.count, exposures.start, exposures.stop, kFlipPixelsPerDegree);
}

void run(const CompareArguments& arguments) {
    const Image reference = layer_image(read_exr(arguments.reference), arguments.layer, arguments.reference);
    const Image test = layer_image(read_exr(arguments.test), arguments.layer, arguments.test);
    const Comparison comparison = compare(reference, test, arguments.reference, arguments.test);
    if (!arguments.diff.empty()) write_png(arguments.diff, flip_picture(comparison, reference.width, reference.height));
    if (arguments.json)
        std::printf("%s\n", to_json(comparison).dump(2).c_str());
    else
        print_text(comparison);
}

}  // namespace

void add_compare_command(CLI::App& app) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command =
        app.add_subcommand("compare", "How far a picture is from a reference: relMSE, RMSE, PSNR, FLIP");
    command->add_option("reference", arguments->reference, "OpenEXR file to compare with")->required();
    command->add_option("test", arguments->test, "OpenEXR file to judge")->required();
    command->add_option("--layer", arguments->layer, "layer to compare, such as type1; without it, the beauty");
    command->add_option("--diff", arguments->diff,
                        "PNG to write: the FLIP error of every pixel, black 0, pale yellow 1");
    command->add_flag("--json", arguments->json, "print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace tress
