// SPDX-License-Identifier: MIT
#include "tools/photon_report.h"

#include "core/light_reach.h"

namespace tress {
namespace {

std::string share_text(const std::array<double, kReflectionClasses>& percent) {
    char text[80];
    std::snprintf(text, sizeof text, "%.1f / %.1f / %.1f %%", percent[0], percent[1], percent[2]);
    return text;
}

double power_in_hair(const PhotonStatistics& statistics) {
    double sum = 0;
    for (const auto& of_source : statistics.hair)
        for (const CrossingShare& share : of_source) sum += share.power;
    return sum;
}

}  // namespace

HairShares hair_shares(const PhotonStatistics& statistics) {
    HairShares shares;
    const double all = power_in_hair(statistics);
    if (!(all > 0)) return shares;
    for (size_t r = 0; r < kReflectionClasses; ++r) {
        shares.from_lamps[r] = 100 * statistics.hair[size_t(LightSource::lamp)][r].power / all;
        shares.from_elsewhere[r] = 100 * statistics.hair[size_t(LightSource::elsewhere)][r].power / all;
    }
    return shares;
}

std::vector<std::string> photon_lines(const PhotonStatistics& statistics, const Scene& scene) {
    std::vector<std::string> lines;
    if (power_in_hair(statistics) > 0) {
        const HairShares shares = hair_shares(statistics);
        lines.push_back("photons in hair, with 0 / 1 / more reflections: from lamps " + share_text(shares.from_lamps) +
                        ", from elsewhere " + share_text(shares.from_elsewhere));
    }
    for (const LightPhotons& light : statistics.lights)
        if (light.emitted > 0 && light.met_hair == 0 && !scene.segments.point.empty())
            lines.push_back("light " + std::to_string(light.light) + " (" + light_name(scene.lights[light.light]) +
                            "): none of its " + std::to_string(light.emitted) + " photons met hair");
    return lines;
}

nlohmann::ordered_json to_json(const PhotonStatistics& statistics) {
    using Json = nlohmann::ordered_json;
    Json lights = Json::array();
    for (const LightPhotons& light : statistics.lights)
        lights.push_back({{"light", light.light},
                          {"emitted", light.emitted},
                          {"met_hair", light.met_hair},
                          {"on_polygons", light.on_polygons},
                          {"power", light.power}});
    const HairShares shares = hair_shares(statistics);
    return {{"lights", lights},
            {"percent_in_hair_by_reflections",
             {{"from_lamps", shares.from_lamps}, {"from_elsewhere", shares.from_elsewhere}}}};
}

}  // namespace tress
