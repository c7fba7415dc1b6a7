// SPDX-License-Identifier: MIT
// The steps of FLIP, one by one, against numbers reckoned by hand from the published formulas (Andersson et al. 2020,
// sec. 4; 2021, sec. 3), with the matrix of sRGB and the filters as sums over two dimensions.
#include <doctest/doctest.h>

#include "core/color_space.h"
#include "core/flip.h"
#include "core/flip_filters.h"
#include "core/flip_tone_map.h"

using namespace tress;

namespace {

void check_vector(const Vec3& value, double x, double y, double z, double tolerance) {
    CHECK(std::abs(double(value.x) - x) < tolerance);
    CHECK(std::abs(double(value.y) - y) < tolerance);
    CHECK(std::abs(double(value.z) - z) < tolerance);
}

Image flat(int width, int height, const Rgb& value) {
    Image image = make_image(width, height);
    for (Rgb& v : image.pixel) v = value;
    return image;
}

/// Weight of a pair of one-dimensional kernels at (x, y) from their middles; 0 beyond their ends.
double weight(const Kernel& row, const Kernel& column, int x, int y) {
    const auto at = [](const Kernel& k, int i) {
        return std::abs(i) <= k.radius() ? double(k.weight[size_t(k.radius() + i)]) : 0.0;
    };
    return at(row, x) * at(column, y);
}

}  // namespace

TEST_CASE("colours in XYZ, YCxCz and CIELAB are those reckoned by hand") {
    // The published matrix has a white D65 whose Z differs by 1.5e-4 from that of the chromaticities used here.
    struct Row {
        Rgb rgb;
        double xyz[3], opponent[3], lab[3];
    };
    const Row rows[] = {
        {{1, 0, 0}, {0.41239, 0.21264, 0.01933}, {8.6659, 110.6293, 38.9769}, {53.2369, 80.0935, 67.2005}},
        {{0, 1, 0}, {0.35759, 0.71518, 0.1192}, {66.9612, -169.4703, 121.1435}, {87.7362, -86.1787, 83.1826}},
        {{0, 0, 1}, {0.18045, 0.07218, 0.95037}, {-7.6271, 58.841, -160.1204}, {32.2982, 79.1936, -107.8586}},
        {{0.5f, 0.25f, 0.125f}, {0.31815, 0.29414, 0.15826}, {18.1199, 20.3022, 29.7593}, {61.145, 14.6465, 27.8547}},
        // Below the bend of CIELAB's cube root.
        {{0.001f, 0.001f, 0.002f},
         {0.00113, 0.00107, 0.00204},
         {-15.8756, 0.0588, -0.1601},
         {0.9685, 0.4582, -1.2469}}};
    for (const Row& row : rows) {
        const Vec3 xyz = rgb_to_xyz(row.rgb);
        check_vector(xyz, row.xyz[0], row.xyz[1], row.xyz[2], 2e-4);
        // Both are relative to white, 100 times and more the relative values.
        const Vec3 opponent = xyz_to_ycxcz(xyz), lab = xyz_to_lab(xyz);
        check_vector(opponent, row.opponent[0], row.opponent[1], row.opponent[2], 0.02);
        check_vector(lab, row.lab[0], row.lab[1], row.lab[2], 0.02);
    }
}

TEST_CASE("contrast sensitivity filters have the weights of the sampled Gaussians, and sum to one") {
    const FlipFilters f = make_flip_filters(kFlipPixelsPerDegree);
    const auto blue_yellow = [&](int x, int y) {
        return weight(f.blue_yellow[0].row, f.blue_yellow[0].column, x, y) +
               weight(f.blue_yellow[1].row, f.blue_yellow[1].column, x, y);
    };
    CHECK(weight(f.achromatic.row, f.achromatic.column, 0, 0) == doctest::Approx(0.14890264357570784).epsilon(1e-6));
    CHECK(weight(f.achromatic.row, f.achromatic.column, 3, 4) == doctest::Approx(1.241427170152627e-06).epsilon(1e-5));
    CHECK(weight(f.red_green.row, f.red_green.column, 0, 0) == doctest::Approx(0.13204574086784607).epsilon(1e-6));
    CHECK(weight(f.red_green.row, f.red_green.column, 3, 4) == doctest::Approx(4.137349747064653e-06).epsilon(1e-5));
    CHECK(blue_yellow(0, 0) == doctest::Approx(0.02001284695765231).epsilon(1e-6));
    CHECK(blue_yellow(3, 4) == doctest::Approx(0.00411548002753366).epsilon(1e-6));
    double sums[3] = {};
    for (int y = -12; y <= 12; ++y)
        for (int x = -12; x <= 12; ++x) {
            sums[0] += weight(f.achromatic.row, f.achromatic.column, x, y);
            sums[1] += weight(f.red_green.row, f.red_green.column, x, y);
            sums[2] += blue_yellow(x, y);
        }
    for (double sum : sums) CHECK(sum == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("feature filters are derivatives of a Gaussian of 2.747 pixels, each side of them weighing one") {
    const FlipFilters f = make_flip_filters(kFlipPixelsPerDegree);
    REQUIRE(f.edge.radius() == 9);  // three standard deviations, rounded up
    CHECK(f.edge.weight[10] == doctest::Approx(-0.12572107156949255).epsilon(1e-6));
    CHECK(f.edge.weight[8] == doctest::Approx(0.12572107156949255).epsilon(1e-6));
    CHECK(f.point.weight[9] == doctest::Approx(-0.2989764137131635).epsilon(1e-6));
    CHECK(f.point.weight[18] == doctest::Approx(0.01377272881128065).epsilon(1e-5));
    double smooth = 0;
    for (float w : f.smooth.weight) smooth += double(w);
    CHECK(smooth == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("two flat pictures differ by their HyAB distance to the power 0.7, mapped past the knee") {
    // Distances after Hunt: 11.2275 for these colours, 203.3017 for green and blue; to 0.7: 5.43497 and 41.2761.
    const double error = 5.434973677533553 * 0.95 / (0.4 * 41.27609841459544);
    CHECK(ldr_flip(flat(24, 24, {0.5f, 0.25f, 0.125f}), flat(24, 24, {0.4f, 0.3f, 0.2f})).mean ==
          doctest::Approx(error).epsilon(2e-4));
}

TEST_CASE("exposures start where the brightest pixel is shown at 0.85, and stop where the middle one is") {
    Image reference = flat(5, 1, Rgb(0.25f));
    reference.pixel[0] = Rgb(0.01f);
    reference.pixel[4] = Rgb(8);
    const FlipExposures exposures = flip_exposures(reference);
    CHECK(exposures.start == doctest::Approx(-1.916703341548901).epsilon(1e-6));
    CHECK(exposures.stop == doctest::Approx(3.083296658451099).epsilon(1e-6));
    CHECK((exposures.count == 5 || exposures.count == 6));  // the difference is 5 stops, to rounding
    CHECK(flip::tone_map(0.5f) == doctest::Approx(0.4384916931118162).epsilon(1e-6));
    CHECK(flip::tone_map(1) == doctest::Approx(0.6732904734073639).epsilon(1e-6));
    CHECK(flip::tone_map(5) == doctest::Approx(0.9537426408746843).epsilon(1e-6));
}

TEST_CASE("HDR-FLIP of a pixel is the largest LDR-FLIP over the exposures, and its mean that of the pixels") {
    Image reference = make_image(16, 12), test = make_image(16, 12);
    for (size_t i = 0; i < reference.pixel.size(); ++i) {
        const float x = float(i % 16) / 16, y = float(i / 16) / 12;
        reference.pixel[i] = Rgb(0.02f + 4 * x * x, 0.3f * y, 0.1f + x * y);
        test.pixel[i] = reference.pixel[i] * (1 + 0.4f * y) + Rgb(0, 0.05f, 0);
    }
    const FlipExposures exposures = flip_exposures(reference);
    std::vector<float> largest(reference.pixel.size(), 0.0f);
    const auto shown = [](const Image& image, double stops) {
        Image out = image;
        const float gain = float(std::exp2(stops));
        for (Rgb& v : out.pixel)
            v = {flip::tone_map(gain * v.x), flip::tone_map(gain * v.y), flip::tone_map(gain * v.z)};
        return out;
    };
    for (int i = 0; i < exposures.count; ++i) {
        const FlipResult at = ldr_flip(shown(reference, exposures.at(i)), shown(test, exposures.at(i)));
        for (size_t p = 0; p < largest.size(); ++p) largest[p] = std::max(largest[p], at.error[p]);
    }
    double mean = 0;
    for (float e : largest) mean += double(e) / double(largest.size());
    const HdrFlipResult hdr = hdr_flip(reference, test);
    CHECK(hdr.flip.error == largest);
    CHECK(hdr.flip.mean == doctest::Approx(mean).epsilon(1e-12));
    CHECK(mean > 0.01);
}
