// SPDX-License-Identifier: MIT
#include "core/film.h"

#include <algorithm>
#include <limits>

#include "core/error.h"

namespace tress {
namespace {

using Sums = std::vector<glm::dvec3>;

/// Rounds to float without ever becoming infinite.
float narrow(double value) {
    constexpr double largest = std::numeric_limits<float>::max();
    return float(glm::clamp(value, -largest, largest));
}

void append(std::vector<float>& data, const glm::dvec3& value) {
    data.insert(data.end(), {narrow(value.x), narrow(value.y), narrow(value.z)});
}

Layer mean_layer(const Film& film, const char* name, const Sums& sums) {
    Layer layer{name, {"R", "G", "B"}, {}};
    layer.data.reserve(3 * sums.size());
    for (size_t i = 0; i < sums.size(); ++i) append(layer.data, sums[i] / double(glm::max(1u, film.samples[i])));
    return layer;
}

Layer beauty_layer(const Film& film) {
    Layer layer{"", {"R", "G", "B", "A"}, {}};
    layer.data.reserve(4 * film.beauty.size());
    for (size_t i = 0; i < film.beauty.size(); ++i) {
        const double n = glm::max(1u, film.samples[i]);
        append(layer.data, film.beauty[i] / n);
        layer.data.push_back(float(film.hits[i] / n));
    }
    return layer;
}

/// Unbiased variance of the mean of n samples: (sum of squares - (sum)^2 / n) / (n (n - 1)).
Layer variance_layer(const Film& film) {
    Layer layer{"variance", {"R", "G", "B"}, {}};
    layer.data.reserve(3 * film.beauty.size());
    for (size_t i = 0; i < film.beauty.size(); ++i) {
        const double n = film.samples[i];
        const glm::dvec3 spread = film.squares[i] - film.beauty[i] * film.beauty[i] / n;
        append(layer.data, max(spread, glm::dvec3(0)) / (n * (n - 1)));
    }
    return layer;
}

Layer depth_layer(const Film& film) {
    Layer layer{"depth", {"Z"}, {}};
    layer.data.reserve(film.depth.size());
    for (size_t i = 0; i < film.depth.size(); ++i)
        layer.data.push_back(narrow(film.depth[i] / glm::max(1u, film.hits[i])));
    return layer;
}

}  // namespace

void check_film_size(int width, int height) {
    constexpr int64_t most_pixels = int64_t(1) << 26;  // 8192 x 8192: up to 17 GB of sums
    if (width < 1 || height < 1 || int64_t(width) * height > most_pixels)
        throw InputError("size", std::to_string(width) + "x" + std::to_string(height) +
                                     " pixels, expected at least 1x1 and at most 2^26 in all");
}

Film make_film(int width, int height, const Plan& plan) {
    const size_t n = size_t(width) * size_t(height);
    Film film{width, height, {}, {}, {}, {}, {}, {}, {}, {}};
    for (Sums* sums : {&film.beauty, &film.squares, &film.albedo}) sums->assign(n, glm::dvec3(0));
    for (int t = 0; t < kPathTypes; ++t)
        if (plan.types[t]) film.types[t] = {Sums(n, glm::dvec3(0)), std::vector<double>(n, 0)};
    film.depth.assign(n, 0);
    film.hits.assign(n, 0);
    film.hair_hits.assign(n, 0);
    film.samples.assign(n, 0);
    return film;
}

void add(Film& film, size_t pixel, const FilmSample& sample) {
    glm::dvec3 beauty(sample.background);
    for (const Rgb& light : sample.light) beauty += glm::dvec3(light);
    film.beauty[pixel] += beauty;
    film.squares[pixel] += beauty * beauty;
    for (int t = 0; t < kPathTypes; ++t) {
        TypeSums& sums = film.types[t];
        if (sums.light.empty()) continue;
        sums.light[pixel] += glm::dvec3(sample.light[t]);
        sums.squares[pixel] += square(double(luminance(sample.light[t])));
    }
    ++film.samples[pixel];
    if (!sample.hit) return;
    film.albedo[pixel] += glm::dvec3(sample.albedo);
    film.depth[pixel] += double(sample.depth);
    ++film.hits[pixel];
    film.hair_hits[pixel] += sample.on_hair;
}

size_t bytes(const Film& film) {
    size_t total = 0;
    for_each_array(film, [&](const auto& array) { total += array.capacity() * sizeof(array[0]); });
    return total;
}

LayeredImage develop(const Film& film) {
    LayeredImage image{film.width, film.height, {beauty_layer(film)}, {}};
    for (int t = 0; t < kPathTypes; ++t)
        if (!film.types[t].light.empty())
            image.layers.push_back(mean_layer(film, type_name(PathType(t)), film.types[t].light));
    const uint32_t most = film.samples.empty() ? 0 : *std::max_element(film.samples.begin(), film.samples.end());
    if (most > 1) image.layers.push_back(variance_layer(film));
    image.layers.push_back(depth_layer(film));
    image.layers.push_back(mean_layer(film, "albedo", film.albedo));
    return image;
}

}  // namespace tress
