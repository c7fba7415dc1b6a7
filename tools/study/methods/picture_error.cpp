// SPDX-License-Identifier: MIT
#include "tools/study/methods/picture_error.h"

#include <algorithm>

#include "core/error.h"
#include "core/layer_image.h"
#include "core/path_type.h"
#include "tools/comparison.h"

namespace tress {
namespace {

std::string file_layer(const std::string& name) { return name == kWhole ? "" : name; }

}  // namespace

bool has_layer(const LayeredImage& picture, const std::string& name) {
    return std::any_of(picture.layers.begin(), picture.layers.end(),
                       [&](const Layer& layer) { return layer.name == file_layer(name); });
}

std::vector<std::string> study_layers(const LayeredImage& picture) {
    std::vector<std::string> names{kWhole};
    for (int type = 0; type < kPathTypes; ++type)
        if (has_layer(picture, type_name(PathType(type)))) names.push_back(type_name(PathType(type)));
    return names;
}

Image study_layer(const LayeredImage& picture, const std::string& name, const std::string& where) {
    return layer_image(picture, file_layer(name), where);
}

Json picture_errors(const LayeredImage& reference, const LayeredImage& picture, const std::string& where) {
    Json errors = Json::object();
    for (const std::string& name : study_layers(reference)) {
        if (!has_layer(picture, name)) continue;
        const Image truth = study_layer(reference, name, "reference"), test = study_layer(picture, name, where);
        const Comparison comparison = compare(truth, test, "the reference", where);
        const ImageError& error = comparison.error;
        errors[name] = {{"relmse", error.relmse},
                        {"relmse_trimmed", error.relmse_trimmed},
                        {"mean_ratio", json_number(error.mean_ratio)},
                        {"flip", comparison.flip.flip.mean}};
    }
    return errors;
}

LayeredImage mean_of(const LayeredImage& a, const LayeredImage& b) {
    if (a.width != b.width || a.height != b.height || a.layers.size() != b.layers.size())
        throw InputError("reference", "two halves that do not belong together, expected pictures of one study");
    LayeredImage mean = a;
    for (size_t l = 0; l < mean.layers.size(); ++l) {
        if (a.layers[l].data.size() != b.layers[l].data.size())
            throw InputError("reference", "two halves that do not belong together, expected pictures of one study");
        for (size_t i = 0; i < mean.layers[l].data.size(); ++i)
            mean.layers[l].data[i] = 0.5f * (a.layers[l].data[i] + b.layers[l].data[i]);
    }
    return mean;
}

Json error_of_mean(const LayeredImage& a, const LayeredImage& b) {
    const LayeredImage mean = mean_of(a, b);
    Json errors = Json::object();
    // a differs from the mean by half of what the halves differ by: its relMSE is a quarter of theirs.
    for (const std::string& name : study_layers(mean))
        errors[name] = image_error(study_layer(mean, name, "reference"), study_layer(a, name, "half")).relmse;
    return errors;
}

}  // namespace tress
