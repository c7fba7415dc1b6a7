// SPDX-License-Identifier: MIT
#include "core/environment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/sampling.h"

namespace tress {
namespace {

constexpr double kPi64 = std::numbers::pi;

/// Share of a texel's own value, and of each neighbour's, in the mean over it of linear interpolation between centres.
constexpr double kOwnShare = 0.75, kNeighbourShare = 0.125;

bool is_radiance(const Rgb& v) { return is_finite(v) && min_component(v) >= 0; }

/// Multiplies by `factor`; what is no radiance then becomes black. Returns how many texels did.
uint64_t clean(Image& image, const Rgb& factor) {
    uint64_t bad = 0;
    for (Rgb& texel : image.pixel) {
        const Rgb product = texel * factor;
        const bool good = is_radiance(texel) && is_radiance(product);
        texel = good ? product : Rgb(0);
        bad += !good;
    }
    return bad;
}

/// Mean luminance of the interpolated picture along row y over texel x, before the interpolation between rows.
double row_mean(const Image& image, int x, int y) {
    const int left = x > 0 ? x - 1 : image.width - 1, right = x + 1 < image.width ? x + 1 : 0;
    const auto value = [&](int column) {
        const DVec3 texel(image.at(column, y));
        return 0.2126 * texel.x + 0.7152 * texel.y + 0.0722 * texel.z;
    };
    return kOwnShare * value(x) + kNeighbourShare * (value(left) + value(right));
}

double texel_mean(const Image& image, int x, int y) {
    const int above = std::max(y - 1, 0), below = std::min(y + 1, image.height - 1);
    return kOwnShare * row_mean(image, x, y) +
           kNeighbourShare * (row_mean(image, x, above) + row_mean(image, x, below));
}

/// Sums in place, scaled to end at exactly 1; returns the sum. `cdf[0]` is 0 and cdf[i + 1] is the weight of i.
double accumulate(double* cdf, size_t count) {
    for (size_t i = 1; i <= count; ++i) cdf[i] += cdf[i - 1];
    const double sum = cdf[count];
    if (!(sum > 0)) return 0;
    for (size_t i = 1; i < count; ++i) cdf[i] /= sum;
    cdf[count] = 1;
    return sum;
}

void build_distribution(EnvironmentSampler& e) {
    const int width = e.image.width, height = e.image.height;
    e.cos_edge.resize(size_t(height) + 1);
    for (int y = 0; y <= height; ++y) e.cos_edge[size_t(y)] = std::cos(kPi64 * y / height);
    e.row_cdf.assign(size_t(height) + 1, 0);
    e.cell_cdf.assign(size_t(height) * size_t(width + 1), 0);
    tbb::parallel_for(0, height, [&](int y) {
        double* row = e.cell_cdf.data() + size_t(y) * size_t(width + 1);
        for (int x = 0; x < width; ++x) row[x + 1] = texel_mean(e.image, x, y);
        const double solid_angle = 2 * kPi64 / width * (e.cos_edge[size_t(y)] - e.cos_edge[size_t(y) + 1]);
        e.row_cdf[size_t(y) + 1] = accumulate(row, size_t(width)) * solid_angle;
    });
    e.power = accumulate(e.row_cdf.data(), size_t(height));
}

/// Place in the picture: x in [0, width), y in [0, height], in texels from the top left corner.
struct Place {
    double x, y;
};

Place place_of(const EnvironmentSampler& e, const Vec3& direction) {
    const double x = e.cos_rotation * direction.x - e.sin_rotation * direction.z;
    const double z = e.sin_rotation * direction.x + e.cos_rotation * direction.z;
    const double theta = std::atan2(std::sqrt(x * x + z * z), double(direction.y));
    const double turn = 0.5 + std::atan2(x, -z) / (2 * kPi64);
    return {turn * e.image.width, theta / kPi64 * e.image.height};
}

/// atan2 ends at +pi as well as at -pi: both are the seam.
int wrap(int x, int width) { return x < 0 ? x + width : x >= width ? x - width : x; }

Rgb interpolate(const Image& image, const Place& place) {
    const double x = place.x - 0.5, y = glm::clamp(place.y - 0.5, 0.0, double(image.height - 1));
    const int x0 = int(std::floor(x)), upper = int(y);
    const int left = wrap(x0, image.width), right = wrap(left + 1, image.width);
    const int lower = std::min(upper + 1, image.height - 1);
    const float across = float(x - x0), down = float(y - upper);
    const Rgb above = glm::mix(image.at(left, upper), image.at(right, upper), across);
    const Rgb below = glm::mix(image.at(left, lower), image.at(right, lower), across);
    return glm::mix(above, below, down);
}

/// Share of the texel there, by its solid angle.
float cell_density(const EnvironmentSampler& e, const Place& place) {
    const int x = wrap(int(place.x), e.image.width);
    const size_t y = size_t(std::min(int(place.y), e.image.height - 1));
    const double* row = e.cell_cdf.data() + y * size_t(e.image.width + 1);
    const double share = (row[x + 1] - row[x]) * (e.row_cdf[y + 1] - e.row_cdf[y]);
    return float(share / (2 * kPi64 / e.image.width * (e.cos_edge[y] - e.cos_edge[y + 1])));
}

/// The interval of a distribution that holds u, which is rescaled to [0, 1] within it. Intervals of no weight are never
/// chosen.
int choose(const double* cdf, int count, double& u) {
    const double* above = std::upper_bound(cdf + 1, cdf + count, u);
    const double lower = *(above - 1), weight = *above - lower;
    u = weight > 0 ? std::clamp((u - lower) / weight, 0.0, 1.0) : 0.5;
    return int(above - cdf) - 1;
}

/// Unit direction in texel (x, y): shares of its width, and of its height in cosine.
Vec3 direction_in(const EnvironmentSampler& e, int x, int y, double across, double down) {
    const double upper = e.cos_edge[size_t(y)], lower = e.cos_edge[size_t(y) + 1];
    const double cos_theta = upper + down * (lower - upper);
    const double sin_theta = safe_sqrt((1 - cos_theta) * (1 + cos_theta));
    const double phi = 2 * kPi64 * ((x + across) / e.image.width - 0.5);
    const double local_x = sin_theta * std::sin(phi), local_z = -sin_theta * std::cos(phi);
    return Vec3(DVec3(e.cos_rotation * local_x + e.sin_rotation * local_z, cos_theta,
                      -e.sin_rotation * local_x + e.cos_rotation * local_z));
}

}  // namespace

EnvironmentSampler make_environment_sampler(Image image, const Rgb& factor, double rotation_degrees) {
    assert(image.pixel.size() == size_t(image.width) * size_t(image.height));
    EnvironmentSampler e;
    const double rotation = glm::radians(rotation_degrees);
    e.sin_rotation = std::sin(rotation);
    e.cos_rotation = std::cos(rotation);
    if (image.empty()) {
        e.constant = is_radiance(factor) ? factor : Rgb(0);
        e.power = 4 * kPi64 * double(luminance(e.constant));
        return e;
    }
    e.image = std::move(image);
    e.bad_texels = clean(e.image, factor);
    build_distribution(e);
    return e;
}

EnvironmentSampler make_environment_sampler(const EnvironmentLight& light) {
    return make_environment_sampler(light.image, light.radiance, light.rotation);
}

Rgb radiance(const EnvironmentSampler& e, const Vec3& direction) {
    return e.image.empty() ? e.constant : interpolate(e.image, place_of(e, direction));
}

float pdf_environment(const EnvironmentSampler& e, const Vec3& direction) {
    if (!(e.power > 0)) return 0;
    return e.image.empty() ? pdf_uniform_sphere() : cell_density(e, place_of(e, direction));
}

EnvironmentSample sample_environment(const EnvironmentSampler& e, const Vec2& u) {
    if (!(e.power > 0)) return {};
    if (e.image.empty()) return {sample_uniform_sphere(u), e.constant, pdf_uniform_sphere()};
    double across = double(u.x), down = double(u.y);
    const int y = choose(e.row_cdf.data(), e.image.height, down);
    const double* row = e.cell_cdf.data() + size_t(y) * size_t(e.image.width + 1);
    const int x = choose(row, e.image.width, across);
    const Vec3 direction = direction_in(e, x, y, across, down);
    const Place place = place_of(e, direction);
    return {direction, interpolate(e.image, place), cell_density(e, place)};
}

}  // namespace tress
