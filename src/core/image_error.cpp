// SPDX-License-Identifier: MIT
#include "core/image_error.h"

#include <algorithm>
#include <numeric>

#include "core/error.h"

namespace tress {
namespace {

constexpr double kRelativeFloor = 0.01;    // of relMSE: keeps black pixels from deciding
constexpr size_t kPixelsATrimmed = 10000;  // one pixel in so many is left out: 0.01 %

std::string size_text(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

void check_finite(const Image& image, const std::string& name) {
    for (size_t i = 0; i < image.pixel.size(); ++i) {
        const Rgb& v = image.pixel[i];
        if (is_finite(v)) continue;
        const size_t width = size_t(image.width);
        const std::string place = "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")";
        throw InputError(name + ": " + place, "found (" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " +
                                                  std::to_string(v.z) + "), expected finite numbers");
    }
}

/// Sum without the `leave_out` largest; of equal ones the first are left out.
double trimmed_sum(const std::vector<double>& values, size_t leave_out) {
    std::vector<size_t> order(values.size());
    std::iota(order.begin(), order.end(), size_t(0));
    const auto larger = [&](size_t a, size_t b) { return values[a] != values[b] ? values[a] > values[b] : a < b; };
    const auto kept = order.begin() + std::ptrdiff_t(leave_out);
    std::nth_element(order.begin(), kept, order.end(), larger);
    std::vector<bool> left_out(values.size(), false);
    for (auto i = order.begin(); i != kept; ++i) left_out[*i] = true;
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i)
        if (!left_out[i]) sum += values[i];
    return sum;
}

double ratio(double test, double reference) { return test == reference ? 1 : test / reference; }

}  // namespace

void check_comparable(const Image& reference, const Image& test, const std::string& reference_name,
                      const std::string& test_name) {
    if (reference.width != test.width || reference.height != test.height)
        throw InputError(
            test_name, "found " + size_text(test) + ", expected " + size_text(reference) + " as in " + reference_name);
    check_finite(reference, reference_name);
    check_finite(test, test_name);
}

ImageError image_error(const Image& reference, const Image& test) {
    check_comparable(reference, test);
    const size_t pixels = reference.pixel.size();
    ImageError error;
    error.peak = 1;
    error.psnr = std::numeric_limits<double>::infinity();
    if (pixels == 0) return error;

    std::vector<double> relative(pixels);
    double squares = 0, reference_sum = 0, test_sum = 0, peak = 0;
    for (size_t i = 0; i < pixels; ++i) {
        const DVec3 r(reference.pixel[i]), t(test.pixel[i]), difference = t - r;
        const DVec3 scaled = difference * difference / (r * r + kRelativeFloor);
        relative[i] = scaled.x + scaled.y + scaled.z;
        squares += dot(difference, difference);
        reference_sum += r.x + r.y + r.z;
        test_sum += t.x + t.y + t.z;
        peak = std::max({peak, r.x, r.y, r.z});
    }
    const size_t leave_out = pixels / kPixelsATrimmed;
    error.relmse = std::accumulate(relative.begin(), relative.end(), 0.0) / double(3 * pixels);
    error.relmse_trimmed =
        leave_out == 0 ? error.relmse : trimmed_sum(relative, leave_out) / double(3 * (pixels - leave_out));
    error.rmse = std::sqrt(squares / double(3 * pixels));
    if (peak > 0) error.peak = peak;
    if (error.rmse > 0) error.psnr = 20 * std::log10(error.peak / error.rmse);
    error.mean_ratio = ratio(test_sum, reference_sum);
    return error;
}

}  // namespace tress
