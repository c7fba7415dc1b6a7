// SPDX-License-Identifier: MIT
// The cells of the igloo: that they are all of the hemisphere, and that light is seen through them unchanged.
#include <algorithm>
#include <numbers>

#include "tools/check/rows/projection_rows.h"
#include "tools/check/support/projected_hair.h"

namespace tress {
namespace {

using namespace test;

constexpr double kPiD = std::numbers::pi;
constexpr uint32_t kCells[] = {4, 16, 64, 100, 256, 1000, 1024, 4096, 16384};  // a hemisphere

/// Greatest differences from 2 pi and pi of sums over cells.
struct SumErrors {
    double solid = 0, cosine = 0;

    void see(long double of_solid, long double of_cosine) {
        solid = std::max(solid, double(std::abs(of_solid - 2 * std::numbers::pi_v<long double>)));
        cosine = std::max(cosine, double(std::abs(of_cosine - std::numbers::pi_v<long double>)));
    }
};

/// By what projection uses: the solid angle of all cells, and the height of each one's middle.
SumErrors sums_in_float() {
    SumErrors worst;
    for (const uint32_t cells : kCells) {
        const Igloo igloo = make_igloo(cells);
        long double solid = 0, cosine = 0;
        for (uint32_t cell = 0; cell < cells; ++cell)
            solid += igloo.solid_angle(), cosine += igloo.solid_angle() * igloo.center_z[cell];
        worst.see(solid, cosine);
    }
    return worst;
}

/// By the borders of the rows, and cosine_integral.
SumErrors sums_in_double() {
    SumErrors worst;
    for (const uint32_t cells : kCells) {
        const Igloo igloo = make_igloo(cells);
        long double solid = 0, cosine = 0;
        for (uint32_t row = 0; row < igloo.rows(); ++row) {
            const double top = 1 - igloo.row_first[row] / double(cells);
            const double bottom = 1 - igloo.row_first[row + 1] / double(cells);
            const uint32_t count = igloo.row_first[row + 1] - igloo.row_first[row];
            for (uint32_t i = 0; i < count; ++i) solid += 2 * kPiD * (top - bottom) / count;
        }
        for (uint32_t cell = 0; cell < cells; ++cell) cosine += cosine_integral(igloo, cell);
        worst.see(solid, cosine);
    }
    return worst;
}

Outcome igloo_sums(const CheckSettings&) {
    const SumErrors single = sums_in_float(), doubled = sums_in_double();
    return {{at_most("sum of solid angles less 2 pi, float, 4 to 16384 cells", single.solid, 1e-6),
             at_most("cosine-weighted sum less pi, float", single.cosine, 1e-6),
             at_most("sum of solid angles less 2 pi, double", doubled.solid, 1e-14),
             at_most("cosine-weighted sum less pi, double", doubled.cosine, 1e-14)},
            {}};
}

/// Irradiance of a uniform sky of radiance 1 through cells, over pi, less 1; the greatest of any number of cells.
double irradiance_error(const StrandSet& strands, ProjectionDetail detail, Isa isa) {
    double worst = 0;
    for (const uint32_t cells : kCells)
        for (const float gap : {0.0f, 1.0f}) {
            Options options;
            options.projection.cells = int(cells);
            options.projection.gap = gap;
            const ProjectedHair hair = projected(strands, gray_fiber(), detail, options);
            const std::vector<Rgb> through = seen_with(isa, hair, {Vec3(0), kUpright, Dome::hemisphere, {}});
            double sum = 0;
            for (uint32_t cell = 0; cell < cells; ++cell)
                sum += double(through[cell].x) * cosine_integral(hair.projection.igloo, cell);
            worst = std::max(worst, std::abs(sum / kPiD - 1));
        }
    return worst;
}

StrandSet hair_below() {
    StrandSet below = random_hair(300, 0.5f, 0.02f, 2);
    for (float& z : below.z) z -= 1.3f;
    return below;
}

/// A white square that slants, under a sky of radiance 1, and fibers on both sides that are all behind its plane: none
/// is before it, and yet it is inside the box of the hair.
Scene square_before_hair() {
    PlacedMesh slant = test::square(0.4f, Rgb(1));
    const double c = std::numbers::sqrt2 / 2;
    slant.placement.m = {c, 0, c, 0, 0, 1, 0, 0, -c, 0, c, 0};  // facing (1, 0, 1)
    const PlacedHair hair = upright_fibers({{-0.8f, 0.7f}, {-0.75f, 0.7f}, {0.7f, -0.8f}, {0.6f, -0.8f}}, 0.5f, 0.01f,
                                           make_fiber({.sigma_a = Rgb(1)}));
    Camera camera = camera_on_z(0, 8, 16);
    camera.from = {3 * c, 0, 3 * c};
    return assemble({hair}, {slant}, {EnvironmentLight{"", {}, Rgb(1), 0}}, camera);
}

/// Of the light of type 2, which is irradiance over pi here: the greatest difference of a pixel from 1.
double rendered_error(ProjectionDetail detail, Isa isa) {
    Options options = small_options();
    options.type1 = LampMethod::off;
    options.type3 = CrossingMethod::off;
    options.type2 = GatherMethod::projection;
    options.projection.detail = detail;
    options.spp = 4;
    options.isa = isa;
    const Rendered r = render(square_before_hair(), options);
    double worst = r.plan.projection == detail ? 0 : double(kInfinity);
    for (const float value : r.layer("type2")->data) worst = std::max(worst, std::abs(double(value) - 1));
    return worst;
}

Outcome uniform_sky(const CheckSettings& settings) {
    double nothing = 0, below = 0, rendered = 0;
    for (const ProjectionDetail detail : {ProjectionDetail::all, ProjectionDetail::tree}) {
        nothing = std::max(nothing, irradiance_error({}, detail, settings.isa));
        below = std::max(below, irradiance_error(hair_below(), detail, settings.isa));
        rendered = std::max(rendered, rendered_error(detail, settings.isa));
    }
    return {{at_most("irradiance over pi L less 1, no hair, 4 to 16384 cells", nothing, 1e-6),
             at_most("likewise with 300 segments below the horizon", below, 1e-6),
             at_most("rendered, a white square among hair behind its plane, worst of 256 pixels", rendered, 1e-6)},
            {}};
}

}  // namespace

std::vector<CheckRow> igloo_rows() {
    return {{"D17", "sums over the igloo's cells", "solid angles 2 pi, with the cosine pi", igloo_sums},
            {"D18", "an open hemisphere under a uniform sky", "irradiance pi L", uniform_sky}};
}

}  // namespace tress
