// SPDX-License-Identifier: MIT
// Absorption from what people know: melanin and colour.
#include <string>
#include <utility>

#include "core/error.h"
#include "core/fiber.h"

namespace tress {

Rgb sigma_a_from_melanin(float eumelanin, float pheomelanin) {
    const Rgb kEumelanin(0.419f, 0.697f, 1.37f), kPheomelanin(0.187f, 0.4f, 1.05f);
    for (const auto& [name, value] : {std::pair("eumelanin", eumelanin), std::pair("pheomelanin", pheomelanin)})
        if (!(value >= 0) || std::isinf(value))
            throw InputError(name, std::to_string(value) + ", expected a finite number of at least 0");
    return eumelanin * kEumelanin + pheomelanin * kPheomelanin;
}

Rgb sigma_a_from_color(const Rgb& color, float beta_n) {
    for (int channel = 0; channel < 3; ++channel)
        if (!(color[channel] >= 0 && color[channel] <= 1))
            throw InputError("color", std::to_string(color[channel]) + ", expected three numbers from 0 to 1");
    const float b = beta_n;
    const float fit = 5.969f + b * (-0.215f + b * (2.532f + b * (-10.73f + b * (5.574f + b * 0.245f))));
    Rgb sigma_a;
    for (int channel = 0; channel < 3; ++channel) sigma_a[channel] = square(std::log(color[channel]) / fit);
    return sigma_a;
}

}  // namespace tress
