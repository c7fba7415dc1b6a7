// SPDX-License-Identifier: MIT
#include "core/attenuation.h"

#include "core/forward_albedo.h"

namespace tress {
namespace {

float depth_of(double albedo) {
    return albedo > 0 ? float(glm::clamp(-std::log(albedo), 0.0, double(kOpaqueDepth))) : kOpaqueDepth;
}

/// Paths of a row, for either sense of the tangent: a crossing does not know which end is the root.
struct RowPaths {
    ForwardPaths up, down;

    RowPaths(const Fiber& fiber, int row, int rows)
        : up(forward_paths(fiber, sine(row, rows))), down(forward_paths(fiber, -sine(row, rows))) {}

    float depth(float sigma_a) const {
        return depth_of(0.5 * (albedo(up, double(sigma_a)) + albedo(down, double(sigma_a))));
    }

    static double sine(int row, int rows) { return safe_sqrt(1 - square(double(row) / (rows - 1))); }
};

}  // namespace

AttenuationTable make_attenuation_table(const Fiber& fiber) {
    AttenuationTable table;
    for (int row = 0; row < table.kRows; ++row) {
        const RowPaths paths(fiber, row, table.kRows);
        const Rgb& sigma_a = fiber.parameters.sigma_a;
        table.depth.push_back({paths.depth(sigma_a.x), paths.depth(sigma_a.y), paths.depth(sigma_a.z)});
    }
    return table;
}

float AbsorptionTable::absorption_of(int column) {
    const float c = float(column) / float(kColumns - 1);
    return column == kColumns - 1 ? kInfinity : c / (1 - c);
}

AbsorptionTable make_absorption_table(const Fiber& fiber) {
    AbsorptionTable table;
    for (int row = 0; row < table.kRows; ++row) {
        const RowPaths paths(fiber, row, table.kRows);
        for (int column = 0; column < table.kColumns; ++column)
            table.depth.push_back(paths.depth(AbsorptionTable::absorption_of(column)));
    }
    return table;
}

}  // namespace tress
