// SPDX-License-Identifier: MIT
#include "accel/isa_targets.h"

#include <string>
#include <string_view>

#include "accel/highway_targets.h"
#include "core/error.h"
#include "hwy/targets.h"

namespace tress {
namespace {

struct NamedTargets {
    Isa isa;
    std::string_view name;
    int64_t targets;  // of Highway; one of them will do
};
constexpr NamedTargets kNamed[] = {
    {Isa::avx512, "avx512", HWY_AVX3 | HWY_AVX3_DL},
    {Isa::avx2, "avx2", HWY_AVX2},
    {Isa::sse4, "sse4", HWY_SSE4},
    {Isa::scalar, "scalar", HWY_SCALAR | HWY_EMU128},
};

/// Those of `wanted` that are compiled and that the machine can run.
int64_t available(int64_t wanted) {
    static const int64_t machine = hwy::SupportedTargets() | HWY_SCALAR | HWY_EMU128;  // asked once: it is slow
    return wanted & HWY_TARGETS & machine;
}

int64_t targets_of(Isa isa) {
    if (isa == Isa::automatic) return available(HWY_TARGETS);
    std::string wanted, known;
    for (const NamedTargets& named : kNamed) {
        const int64_t targets = available(named.targets);
        if (named.isa == isa && targets != 0) return targets;
        if (named.isa == isa) wanted = named.name;
        if (targets != 0) known += std::string(known.empty() ? "" : ", ") + std::string(named.name);
    }
    throw InputError("isa", "'" + wanted + "' cannot run here, expected one of auto, " + known);
}

}  // namespace

std::vector<Isa> supported_isas() {
    std::vector<Isa> isas;
    for (const NamedTargets& named : kNamed)
        if (available(named.targets) != 0) isas.push_back(named.isa);
    return isas;
}

Isa used_isa(Isa isa) {
    targets_of(isa);
    return isa == Isa::automatic ? supported_isas().front() : isa;
}

size_t kernel_index(Isa isa) {
    hwy::ChosenTarget chosen;
    chosen.Update(targets_of(isa));
    return chosen.GetIndex();
}

}  // namespace tress
