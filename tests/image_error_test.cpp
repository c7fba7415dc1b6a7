// SPDX-License-Identifier: MIT
#include "core/image_error.h"

#include <doctest/doctest.h>

#include "core/error.h"
#include "core/layer_image.h"
#include "core/rng.h"

using namespace tress;

namespace {

Image constant_image(int width, int height, const Rgb& value) {
    Image image = make_image(width, height);
    for (Rgb& v : image.pixel) v = value;
    return image;
}

}  // namespace

TEST_CASE("errors of two pixels equal those reckoned by hand") {
    Image reference = make_image(2, 1), test = make_image(2, 1);
    reference.pixel = {{1, 0, 2}, {0.5f, 0.5f, 0}};
    test.pixel = {{1.5f, 0.1f, 1}, {0.5f, 0, 0}};
    const ImageError error = image_error(reference, test);
    // The only rounding is of 0.1 to float: 1.5e-8 relative, doubled by the square.
    const double relmse = (0.25 / 1.01 + 0.01 / 0.01 + 1.0 / 4.01 + 0 + 0.25 / 0.26 + 0) / 6;
    const double rmse = std::sqrt((0.25 + 0.01 + 1 + 0.25) / 6);
    CHECK(error.relmse == doctest::Approx(relmse).epsilon(1e-7));
    CHECK(error.relmse_trimmed == error.relmse);
    CHECK(error.rmse == doctest::Approx(rmse).epsilon(1e-7));
    CHECK(error.peak == 2);
    CHECK(error.psnr == doctest::Approx(20 * std::log10(2 / rmse)).epsilon(1e-7));
    CHECK(error.mean_ratio == doctest::Approx(3.1 / 4).epsilon(1e-7));
}

TEST_CASE("the trimmed error leaves out exactly the worst pixel of ten thousand") {
    const Image reference = constant_image(100, 200, Rgb(1));
    Image test = constant_image(100, 200, Rgb(1.5f));
    test.at(37, 5) = Rgb(1e4f);
    test.at(99, 199) = Rgb(1e5f);
    const ImageError error = image_error(reference, test);
    CHECK(error.relmse_trimmed == doctest::Approx(0.25 / 1.01).epsilon(1e-12));
    CHECK(error.relmse > 1e5);
    test.at(0, 0) = Rgb(1e3f);  // a third one stays
    CHECK(image_error(reference, test).relmse_trimmed > 40);
}

TEST_CASE("equal pictures have no error and no finite PSNR; black ones too") {
    for (const Rgb& value : {Rgb(0), Rgb(0.3f, 1e30f, -2)}) {
        const Image image = constant_image(3, 3, value);
        const ImageError error = image_error(image, image);
        CHECK(error.relmse == 0);
        CHECK(error.rmse == 0);
        CHECK(std::isinf(error.psnr));
        CHECK(error.mean_ratio == 1);
    }
    CHECK(image_error(constant_image(1, 1, Rgb(0)), constant_image(1, 1, Rgb(1))).peak == 1);
}

TEST_CASE("a pixel that is not finite and a wrong size are refused in words") {
    const Image good = constant_image(4, 3, Rgb(1));
    Image bad = good;
    bad.at(2, 1).y = std::nanf("");
    CHECK_THROWS_WITH_AS(image_error(good, bad), doctest::Contains("test: pixel (2, 1)"), InputError);
    CHECK_THROWS_WITH_AS(image_error(bad, good), doctest::Contains("reference: pixel (2, 1)"), InputError);
    CHECK_THROWS_WITH_AS(image_error(good, constant_image(3, 4, Rgb(1))), doctest::Contains("expected 4 x 3"),
                         InputError);
}

TEST_CASE("a layer becomes a picture by the names of its channels") {
    LayeredImage file{
        1, 1, {{"", {"A", "B", "G", "R"}, {4, 3, 2, 1}}, {"depth", {"Z"}, {7}}, {"uv", {"u", "v"}, {0, 0}}}, {}};
    CHECK(layer_image(file, "", "a.exr").pixel[0] == Rgb(1, 2, 3));
    CHECK(layer_image(file, "depth", "a.exr").pixel[0] == Rgb(7));
    CHECK_THROWS_WITH_AS(layer_image(file, "typ1", "a.exr"),
                         doctest::Contains("expected one of: the beauty, 'depth', 'uv'"), InputError);
    CHECK_THROWS_WITH_AS(layer_image(file, "uv", "a.exr"), doctest::Contains("no channel R"), InputError);
}
