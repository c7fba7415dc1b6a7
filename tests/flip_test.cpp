// SPDX-License-Identifier: MIT
#include "core/flip.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <functional>

#include "core/color_space.h"
#include "core/colormap.h"
#include "core/error.h"
#include "core/rng.h"
#include "core/tone_map.h"

using namespace tress;

namespace {

Image noise(int width, int height, uint64_t key, float scale = 1) {
    Image image = make_image(width, height);
    for (size_t i = 0; i < image.pixel.size(); ++i) {
        const uint64_t pixel = hash(key, i);
        image.pixel[i] = scale * Rgb(random(pixel, 0), random(pixel, 1), random(pixel, 2));
    }
    return image;
}

Image flat(int width, int height, const Rgb& value) {
    Image image = make_image(width, height);
    for (Rgb& v : image.pixel) v = value;
    return image;
}

/// Soft stripes: something with edges and lines that is not noise.
Image stripes(int width, int height) {
    Image image = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float wave = 0.5f + 0.5f * std::sin(0.4f * float(x) + 0.15f * float(y));
            image.at(x, y) = Rgb(0.8f * wave, 0.5f * wave * wave, 0.3f + 0.1f * wave);
        }
    return image;
}

Image mixed(const Image& a, const Image& b, float amount) {
    Image out = a;
    for (size_t i = 0; i < out.pixel.size(); ++i) out.pixel[i] = glm::mix(a.pixel[i], b.pixel[i], amount);
    return out;
}

// LDR-FLIP once more, slowly: in double, by direct two-dimensional convolution, straight from the paper's formulas.
namespace slow {

using Field = std::vector<double>;
using Weight = std::function<double(double, double)>;

struct Size {
    int width, height;
};

Field convolve(const Field& in, Size size, int radius, const Field& weights) {
    Field out(in.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double sum = 0;
            for (int j = -radius; j <= radius; ++j)
                for (int i = -radius; i <= radius; ++i) {
                    const int from_x = std::clamp(x + i, 0, size.width - 1);
                    const int from_y = std::clamp(y + j, 0, size.height - 1);
                    sum += weights[size_t((j + radius) * (2 * radius + 1) + i + radius)] *
                           in[size_t(from_y * size.width + from_x)];
                }
            out[size_t(y * size.width + x)] = sum;
        }
    return out;
}

Field sample(int radius, const Weight& weight) {
    Field weights;
    for (int j = -radius; j <= radius; ++j)
        for (int i = -radius; i <= radius; ++i) weights.push_back(weight(i, j));
    double positive = 0, negative = 0;
    for (double w : weights) (w > 0 ? positive : negative) += w;
    for (double& w : weights) w = w > 0 ? w / positive : -w / (negative < 0 ? negative : -1);
    return weights;
}

double root(double t) { return t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29; }

const glm::dmat3 kToXyz = color::make_rgb_to_xyz();

DVec3 hunt_lab(const DVec3& rgb) {
    const DVec3 t = kToXyz * rgb / (kToXyz * DVec3(1));
    const double l = 116 * root(t.y) - 16, a = 500 * (root(t.x) - root(t.y)), b = 200 * (root(t.y) - root(t.z));
    return {l, 0.01 * l * a, 0.01 * l * b};
}

double distance(const DVec3& a, const DVec3& b) {
    return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

struct Seen {
    Field channel[3], edge_x, edge_y, point_x, point_y;
};

Seen see(const Image& image, double ppd) {
    const Size size{image.width, image.height};
    Field opponent[3], luma;
    for (const Rgb& v : image.pixel) {
        const DVec3 t = kToXyz * DVec3(v) / (kToXyz * DVec3(1));
        opponent[0].push_back(116 * t.y - 16);
        opponent[1].push_back(500 * (t.x - t.y));
        opponent[2].push_back(200 * (t.y - t.z));
        luma.push_back(t.y);
    }
    const double pi = std::acos(-1.0);
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    const double parameters[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    Seen seen;
    for (int c = 0; c < 3; ++c) {
        const double* p = parameters[c];
        seen.channel[c] = convolve(opponent[c], size, radius, sample(radius, [&](double x, double y) {
                                       const double d2 = (x * x + y * y) / (ppd * ppd);
                                       return p[0] * std::sqrt(pi / p[1]) * std::exp(-pi * pi * d2 / p[1]) +
                                              p[2] * std::sqrt(pi / p[3]) * std::exp(-pi * pi * d2 / p[3]);
                                   }));
    }
    const double sd = 0.5 * 0.082 * ppd;
    const int feature_radius = int(std::ceil(3 * sd));
    const auto feature = [&](const Weight& weight) {
        return convolve(luma, size, feature_radius, sample(feature_radius, [&](double x, double y) {
                            return weight(x, y) * std::exp(-(x * x + y * y) / (2 * sd * sd));
                        }));
    };
    seen.edge_x = feature([](double x, double) { return -x; });
    seen.edge_y = feature([](double, double y) { return -y; });
    seen.point_x = feature([&](double x, double) { return x * x / (sd * sd) - 1; });
    seen.point_y = feature([&](double, double y) { return y * y / (sd * sd) - 1; });
    return seen;
}

Field flip(const Image& reference, const Image& test, double ppd) {
    const Seen r = see(reference, ppd), t = see(test, ppd);
    const double largest = distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), knee = 0.4 * largest;
    const glm::dmat3 to_rgb = glm::inverse(kToXyz);
    const auto lab = [&](const Seen& s, size_t i) {
        const double y = (s.channel[0][i] + 16) / 116;
        const DVec3 relative(y + s.channel[1][i] / 500, y, y - s.channel[2][i] / 200);
        return hunt_lab(glm::clamp(to_rgb * (relative * (kToXyz * DVec3(1))), 0.0, 1.0));
    };
    Field error;
    for (size_t i = 0; i < reference.pixel.size(); ++i) {
        const double d = distance(lab(r, i), lab(t, i));
        const double color = d < knee ? 0.95 * d / knee : 0.95 + 0.05 * (d - knee) / (largest - knee);
        const double edge = std::abs(std::hypot(r.edge_x[i], r.edge_y[i]) - std::hypot(t.edge_x[i], t.edge_y[i]));
        const double point = std::abs(std::hypot(r.point_x[i], r.point_y[i]) - std::hypot(t.point_x[i], t.point_y[i]));
        error.push_back(std::pow(color, 1 - std::sqrt(std::max(edge, point) / std::sqrt(2.0))));
    }
    return error;
}

}  // namespace slow

}  // namespace

TEST_CASE("LDR-FLIP equals direct convolution in double") {
    // Single precision knows filtered values to about 1e-6 of their range. The feature difference is a square root, so
    // where features are nearly equal it may be off by 1e-3; elsewhere errors are of the order of 1e-5.
    const double densities[] = {67, 30};
    for (double ppd : densities) {
        CAPTURE(ppd);
        const Image reference = stripes(31, 23), test = mixed(reference, noise(31, 23, 5), 0.3f);
        const FlipResult fast = ldr_flip(reference, test, ppd);
        const slow::Field expected = slow::flip(reference, test, ppd);
        double mean = 0, worst = 0;
        for (size_t i = 0; i < expected.size(); ++i) {
            mean += expected[i] / double(expected.size());
            worst = std::max(worst, std::abs(expected[i] - double(fast.error[i])));
        }
        CHECK(worst < 1e-3);
        CHECK(fast.mean == doctest::Approx(mean).epsilon(1e-4));
        CHECK(mean > 0.05);
    }
}

TEST_CASE("equal pictures differ nowhere") {
    const Image image = noise(40, 30, 1, 3);
    CHECK(ldr_flip(image, image).mean == 0);
    const HdrFlipResult hdr = hdr_flip(image, image);
    CHECK(hdr.flip.mean == 0);
    CHECK(hdr.exposures.count >= 2);
    const Image black = make_image(8, 8);
    CHECK(hdr_flip(black, black).flip.mean == 0);
}

TEST_CASE("black against white is 0.967 and green against blue is 1") {
    // L differs by 100: 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m) with m = 203.3^0.7, the distance of green and blue.
    const Image black = flat(24, 24, Rgb(0)), white = flat(24, 24, Rgb(1));
    CHECK(ldr_flip(black, white).mean == doctest::Approx(0.967).epsilon(1e-3));
    CHECK(ldr_flip(flat(24, 24, {0, 1, 0}), flat(24, 24, {0, 0, 1})).mean == doctest::Approx(1).epsilon(1e-5));
}

TEST_CASE("LDR-FLIP is symmetric and lies in [0, 1]") {
    const Image a = noise(33, 20, 2), b = stripes(33, 20);
    const FlipResult ab = ldr_flip(a, b), ba = ldr_flip(b, a);
    CHECK(ab.error == ba.error);
    for (float e : hdr_flip(noise(33, 20, 2, 50), noise(33, 20, 3, 50)).flip.error) {
        CHECK(e >= 0);
        CHECK(e <= 1);
    }
}

TEST_CASE("FLIP grows with noise and does not depend on threads") {
    const Image reference = stripes(64, 48), other = noise(64, 48, 9);
    double last_ldr = 0, last_hdr = 0;
    for (float amount : {0.02f, 0.1f, 0.3f, 0.8f}) {
        const Image test = mixed(reference, other, amount);
        const double ldr = ldr_flip(reference, test).mean, hdr = hdr_flip(reference, test).flip.mean;
        CHECK(ldr > last_ldr);
        CHECK(hdr > last_hdr);
        last_ldr = ldr;
        last_hdr = hdr;
    }
    const FlipResult many = hdr_flip(reference, other).flip;
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(hdr_flip(reference, other).flip.error == many.error);
}

TEST_CASE("HDR-FLIP follows the reference's exposure") {
    const Image reference = noise(32, 32, 4), test = noise(32, 32, 6);
    const double mean = hdr_flip(reference, test).flip.mean;
    Image bright_reference = reference, bright_test = test;
    for (Image* image : {&bright_reference, &bright_test})
        for (Rgb& v : image->pixel) v *= 64.0f;
    const FlipExposures low = flip_exposures(reference), high = flip_exposures(bright_reference);
    CHECK(high.start == doctest::Approx(low.start - 6));
    CHECK(high.stop == doctest::Approx(low.stop - 6));
    CHECK(hdr_flip(bright_reference, bright_test).flip.mean == doctest::Approx(mean).epsilon(1e-4));
    // A difference that only shows in the dark is seen by HDR-FLIP in spite of a bright spot.
    Image spot = flat(32, 32, Rgb(0.001f)), spot_test = flat(32, 32, Rgb(0.002f));
    spot.at(3, 3) = spot_test.at(3, 3) = Rgb(1e5f);
    CHECK(hdr_flip(spot, spot_test).flip.mean > 4 * ldr_flip(spot, spot_test).mean);
}

TEST_CASE("extreme pictures stay finite and bad ones are refused") {
    Image huge = flat(8, 8, Rgb(1e30f)), negative = flat(8, 8, Rgb(-1));
    huge.at(1, 1) = Rgb(std::numeric_limits<float>::max());
    CHECK(std::isfinite(hdr_flip(huge, negative).flip.mean));
    CHECK(std::isfinite(hdr_flip(negative, huge).flip.mean));
    huge.at(2, 3).z = std::numeric_limits<float>::infinity();
    CHECK_THROWS_WITH_AS(hdr_flip(negative, huge), doctest::Contains("(2, 3)"), InputError);
    CHECK_THROWS_AS(ldr_flip(make_image(2, 2), make_image(2, 3)), InputError);
    CHECK(hdr_flip(make_image(0, 0), make_image(0, 0)).flip.mean == 0);
    CHECK(std::isfinite(ldr_flip(flat(1, 1, Rgb(0)), flat(1, 1, Rgb(1))).mean));
}

TEST_CASE("colour spaces turn back and know white") {
    CHECK(xyz_to_lab(rgb_to_xyz(Rgb(1))).x == doctest::Approx(100).epsilon(1e-5));
    CHECK(rgb_to_xyz(Rgb(1)).y == doctest::Approx(1).epsilon(1e-6));
    for (uint64_t i = 0; i < 100; ++i) {
        const Rgb rgb(random(i, 0), random(i, 1), random(i, 2));
        const Rgb back = xyz_to_rgb(ycxcz_to_xyz(xyz_to_ycxcz(rgb_to_xyz(rgb))));
        for (int c = 0; c < 3; ++c) {
            CHECK(back[c] == doctest::Approx(rgb[c]).epsilon(1e-5));
            CHECK(srgb_to_linear(linear_to_srgb(rgb[c])) == doctest::Approx(rgb[c]).epsilon(1e-5));
        }
    }
}

TEST_CASE("the heat colours grow in luminance and clamp") {
    float last = -1;
    for (int i = 0; i <= 64; ++i) {
        const float now = luminance(heat_color(float(i) / 64));
        CHECK(now > last);
        last = now;
    }
    CHECK(heat_color(-1) == heat_color(0));
    CHECK(heat_color(2) == heat_color(1));
    CHECK(heat_color(std::nanf("")) == heat_color(0));
}

TEST_CASE("the display curve keeps mid-grey, grows, keeps order of channels and never leaves [0, 1]") {
    CHECK(tone_map(Rgb(0.18f), 0).x == doctest::Approx(0.18f));
    CHECK(tone_map(Rgb(0.09f), 1).x == doctest::Approx(0.18f));
    float last = -1;
    for (int i = -40; i <= 40; ++i) {
        const Rgb mapped = tone_map(std::exp2(0.25f * float(i)) * Rgb(1, 0.5f, 0.2f), 0);
        CHECK(mapped.x > mapped.y);
        CHECK(mapped.y > mapped.z);
        CHECK(mapped.z > last);
        CHECK(mapped.x <= 1);
        last = mapped.z;
    }
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(tone_map(Rgb(std::nanf(""), -1, 0.1f), 0) == Rgb(0, 0, 0.1f));
    CHECK(tone_map(Rgb(infinity), 0).x == doctest::Approx(1));
    CHECK(is_finite(tone_map(Rgb(infinity, 0, 1), 200)));
    const Image image = noise(5, 4, 1, 4);
    CHECK(tone_map(image, 0.5f).at(3, 2) == tone_map(image.at(3, 2), 0.5f));
}
