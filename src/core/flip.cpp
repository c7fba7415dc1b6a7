// SPDX-License-Identifier: MIT
#include "core/flip.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numbers>

#include "core/color_space.h"
#include "core/flip_filters.h"
#include "core/flip_tone_map.h"
#include "core/image_error.h"

namespace tress {
namespace {

// Andersson et al. 2020, sec. 4.1.3 and 4.2.
constexpr float kColorPower = 0.7f;                     // q_c
constexpr float kFeaturePower = 0.5f;                   // q_f
constexpr float kColorKnee = 0.4f, kKneeValue = 0.95f;  // p_c, p_t
constexpr int kRowsATask = 16;

/// Luminance below which HDR-FLIP does not look: a black reference has no exposure of its own.
constexpr float kDarkest = 1e-4f;
/// Display luminance that bounds the exposures (Andersson et al. 2021, sec. 3).
constexpr double kExposureTarget = 0.85;

struct DisplayLight {
    Rgb operator()(const Rgb& v) const { return glm::clamp(v, 0.0f, 1.0f); }
};
struct ToneMapped {
    float gain;
    Rgb operator()(const Rgb& v) const {
        return {flip::tone_map(gain * v.x), flip::tone_map(gain * v.y), flip::tone_map(gain * v.z)};
    }
};

template <class Body>
void for_rows(int height, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsATask), [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) body(y);
    });
}

/// A picture after every filter along rows.
struct RowFiltered {
    Plane achromatic, red_green, blue_yellow[2];  // of YCxCz
    Plane smooth, edge, point;                    // of Y scaled to [0, 1]
};

template <class Map>
RowFiltered filter_rows(const Image& image, const FlipFilters& filters, const Map& map) {
    const int width = image.width;
    const Plane blank = make_plane(width, image.height);
    RowFiltered out{blank, blank, {blank, blank}, blank, blank, blank};
    for_rows(image.height, [&](int y) {
        std::vector<float> luma(width), red_green(width), blue_yellow(width), padded;
        for (int x = 0; x < width; ++x) {
            const Vec3 opponent = xyz_to_ycxcz(rgb_to_xyz(map(image.at(x, y))));
            luma[x] = opponent.x;
            red_green[x] = opponent.y;
            blue_yellow[x] = opponent.z;
        }
        filter_along_row(luma, filters.achromatic.row, padded, out.achromatic.row(y));
        filter_along_row(red_green, filters.red_green.row, padded, out.red_green.row(y));
        for (int i = 0; i < 2; ++i)
            filter_along_row(blue_yellow, filters.blue_yellow[i].row, padded, out.blue_yellow[i].row(y));
        for (float& v : luma) v = (v + 16) / 116;
        filter_along_row(luma, filters.smooth, padded, out.smooth.row(y));
        filter_along_row(luma, filters.edge, padded, out.edge.row(y));
        filter_along_row(luma, filters.point, padded, out.point.row(y));
    });
    return out;
}

/// One row of what the eye makes of a picture.
struct Perceived {
    std::vector<float> channel[3];  // filtered YCxCz
    std::vector<float> edge_x, edge_y, point_x, point_y;

    explicit Perceived(int width) {
        for (std::vector<float>* row : {&channel[0], &channel[1], &channel[2], &edge_x, &edge_y, &point_x, &point_y})
            row->assign(size_t(width), 0.0f);
    }
};

Perceived filter_columns(const RowFiltered& in, const FlipFilters& filters, int y) {
    Perceived out(in.smooth.width);
    add_filtered_column(in.achromatic, filters.achromatic.column, y, out.channel[0]);
    add_filtered_column(in.red_green, filters.red_green.column, y, out.channel[1]);
    for (int i = 0; i < 2; ++i)
        add_filtered_column(in.blue_yellow[i], filters.blue_yellow[i].column, y, out.channel[2]);
    add_filtered_column(in.edge, filters.smooth, y, out.edge_x);
    add_filtered_column(in.smooth, filters.edge, y, out.edge_y);
    add_filtered_column(in.point, filters.smooth, y, out.point_x);
    add_filtered_column(in.smooth, filters.point, y, out.point_y);
    return out;
}

/// CIELAB with the Hunt effect: colours look stronger where it is bright.
Vec3 hunt_lab(const Rgb& rgb) {
    const Vec3 lab = xyz_to_lab(rgb_to_xyz(rgb));
    return {lab.x, 0.01f * lab.x * lab.y, 0.01f * lab.x * lab.z};
}

Vec3 perceived_color(const Perceived& p, size_t x) {
    const Vec3 xyz = ycxcz_to_xyz({p.channel[0][x], p.channel[1][x], p.channel[2][x]});
    return hunt_lab(glm::clamp(xyz_to_rgb(xyz), 0.0f, 1.0f));
}

/// HyAB distance to the power q_c: city block between lightness and chroma.
float color_distance(const Vec3& a, const Vec3& b) {
    const Vec3 d = a - b;
    return std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), kColorPower);
}

/// Distances up to the knee get most of [0, 1]; the largest there is, green to blue, becomes 1.
float color_difference(float distance, float largest) {
    const float knee = kColorKnee * largest;
    if (distance < knee) return kKneeValue / knee * distance;
    return std::min(1.0f, kKneeValue + (distance - knee) / (largest - knee) * (1 - kKneeValue));
}

float length(float x, float y) { return std::sqrt(x * x + y * y); }

float feature_difference(const Perceived& r, const Perceived& t, size_t x) {
    const float edge = std::abs(length(r.edge_x[x], r.edge_y[x]) - length(t.edge_x[x], t.edge_y[x]));
    const float point = std::abs(length(r.point_x[x], r.point_y[x]) - length(t.point_x[x], t.point_y[x]));
    static_assert(kFeaturePower == 0.5f);
    return std::min(1.0f, std::sqrt(std::max(edge, point) * float(1 / std::numbers::sqrt2)));
}

/// error = max(error, LDR-FLIP of the two pictures after `map`).
template <class Map>
void raise_to_flip(const Image& reference, const Image& test, const FlipFilters& filters, const Map& map,
                   std::vector<float>& error) {
    const RowFiltered reference_rows = filter_rows(reference, filters, map);
    const RowFiltered test_rows = filter_rows(test, filters, map);
    const float largest = color_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    const size_t width = size_t(reference.width);
    for_rows(reference.height, [&](int y) {
        const Perceived r = filter_columns(reference_rows, filters, y);
        const Perceived t = filter_columns(test_rows, filters, y);
        float* row = error.data() + size_t(y) * width;
        for (size_t x = 0; x < width; ++x) {
            const float distance = color_distance(perceived_color(r, x), perceived_color(t, x));
            const float color = color_difference(distance, largest);
            row[x] = std::max(row[x], std::pow(color, 1 - feature_difference(r, t, x)));
        }
    });
}

FlipResult finish(std::vector<float> error) {
    double sum = 0;
    for (float e : error) sum += double(e);
    const double mean = error.empty() ? 0 : sum / double(error.size());
    return {mean, std::move(error)};
}

}  // namespace

FlipResult ldr_flip(const Image& reference, const Image& test, double pixels_per_degree) {
    check_comparable(reference, test);
    std::vector<float> error(reference.pixel.size(), 0.0f);
    raise_to_flip(reference, test, make_flip_filters(pixels_per_degree), DisplayLight{}, error);
    return finish(std::move(error));
}

FlipExposures flip_exposures(const Image& reference) {
    if (reference.empty()) return {};
    std::vector<float> luminances;
    luminances.reserve(reference.pixel.size());
    for (const Rgb& v : reference.pixel) luminances.push_back(std::max(kDarkest, luminance(glm::max(v, Rgb(0)))));
    const float brightest = *std::max_element(luminances.begin(), luminances.end());
    const auto middle = luminances.begin() + std::ptrdiff_t(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());

    const double target = flip::inverse_tone_map(kExposureTarget);
    FlipExposures exposures;
    exposures.start = std::log2(target / double(brightest));
    exposures.stop = std::log2(target / double(*middle));
    exposures.count = std::max(2, int(std::ceil(exposures.stop - exposures.start)));
    return exposures;
}

HdrFlipResult hdr_flip(const Image& reference, const Image& test, double pixels_per_degree) {
    check_comparable(reference, test);
    const FlipExposures exposures = flip_exposures(reference);
    const FlipFilters filters = make_flip_filters(pixels_per_degree);
    std::vector<float> error(reference.pixel.size(), 0.0f);
    for (int i = 0; i < exposures.count; ++i)
        raise_to_flip(reference, test, filters, ToneMapped{float(std::exp2(exposures.at(i)))}, error);
    return {finish(std::move(error)), exposures};
}

}  // namespace tress
