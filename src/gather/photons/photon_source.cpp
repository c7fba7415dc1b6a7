// SPDX-License-Identifier: MIT
#include "gather/photons/photon_source.h"

#include <algorithm>

namespace tress {
namespace {

/// Calls `function` with a light as light_emission.h takes it.
template <class Function>
auto with_light(const Scene& scene, const PreparedScene& prepared, uint32_t light, const Function& function) {
    return std::visit(
        [&](const auto& lamp) {
            if constexpr (std::is_same_v<std::decay_t<decltype(lamp)>, EnvironmentLight>)
                return function(*prepared.environment[light]);
            else
                return function(lamp);
        },
        scene.lights[light]);
}

/// Photons of environments, and of lamps off polygons, can be of Types 2 and 5 alone; those straight from lamps not.
std::vector<uint32_t> useful_lights(const Plan& plan) {
    const bool elsewhere = plan.polygon_gather || plan.photon_display[index_of(PathType::type5)];
    std::vector<uint32_t> lights;
    if (plan.photon_display[index_of(PathType::type4)] || (elsewhere && plan.mesh_tree)) lights = plan.lamps;
    if (elsewhere) lights.insert(lights.end(), plan.environments.begin(), plan.environments.end());
    return lights;
}

constexpr float kBelowOne = 1 - 0x1p-24f;

}  // namespace

PhotonSource make_photon_source(const Scene& scene, const PreparedScene& prepared, const Plan& plan, int photons) {
    PhotonSource source;
    source.sphere = sphere_about(scene.bounds);
    std::vector<double> power;
    double total = 0;
    for (const uint32_t light : useful_lights(plan)) {
        const auto of_light = [&](const auto& l) { return emission_power(l, source.sphere); };
        power.push_back(double(luminance(with_light(scene, prepared, light, of_light))));
        total += power.back();
        source.shares.push_back({light, 0, 0});
    }
    if (!(total > 0)) return source;
    double below = 0;
    for (size_t i = 0; i < power.size(); ++i) {
        source.shares[i].below = below / total;
        if (power[i] > 0) source.shares[i].factor = total / (power[i] * photons);
        below += power[i];
    }
    source.dark = false;
    return source;
}

/// The first number chooses the light and then, stretched over its share, serves again: photons of one light stay well
/// spread. A light without power has no share to be chosen by.
StartingPhoton start_photon(const PhotonSource& source, const Scene& scene, const PreparedScene& prepared,
                            const Sampler& sampler) {
    glm::vec4 u = sampler.get4(0);
    const auto past = [](double at, const PhotonSource::Share& share) { return at < share.below; };
    auto next = std::upper_bound(source.shares.begin() + 1, source.shares.end(), double(u.x), past);
    const PhotonSource::Share& share = *(next - 1);
    const double above = next == source.shares.end() ? 1 : next->below;
    u.x = std::min(float((double(u.x) - share.below) / (above - share.below)), kBelowOne);

    const auto of_light = [&](const auto& l) { return emit(l, source.sphere, u); };
    const bool lamp = !std::holds_alternative<EnvironmentLight>(scene.lights[share.light]);
    StartingPhoton photon{uint32_t(&share - source.shares.data()), lamp ? LightSource::lamp : LightSource::elsewhere,
                          with_light(scene, prepared, share.light, of_light)};
    photon.emission.power = Rgb(min(DVec3(photon.emission.power) * share.factor, DVec3(double(kLargestPower))));
    return photon;
}

}  // namespace tress
