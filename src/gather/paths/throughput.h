// SPDX-License-Identifier: MIT
// What share of light from the end of a path leaves its start, kept apart by what decides the type of the path.
#pragma once

#include <array>

#include "core/path_type.h"

namespace tress {

/// Before the path has met a surface: by the number of events R (0, 1, 2 or more). After that its type is settled:
/// 0 is Type 2, 1 is Type 5, 2 is unused.
struct Throughput {
    static constexpr int kStates = 3;

    std::array<Rgb, kStates> by{Rgb(1), Rgb(0), Rgb(0)};
    bool settled = false;

    Rgb sum() const { return by[0] + by[1] + by[2]; }

    Throughput& operator*=(const Rgb& factor) {
        for (Rgb& share : by) share *= factor;
        return *this;
    }
};

inline Throughput operator*(Throughput t, const Rgb& factor) { return t *= factor; }

/// After one more event R.
inline Throughput reflected(const Throughput& t) {
    return t.settled ? t : Throughput{{Rgb(0), t.by[0], t.by[1] + t.by[2]}, false};
}

/// Past a surface.
inline Throughput settled(const Throughput& t) {
    return t.settled ? t : Throughput{{t.by[0], t.by[1] + t.by[2], Rgb(0)}, true};
}

/// After an event at a fiber that sends light on as F by `forward` and as R by `reflection`.
inline Throughput scattered(const Throughput& t, const Rgb& forward, const Rgb& reflection) {
    Throughput sum = reflected(t) * reflection;
    for (int state = 0; state < Throughput::kStates; ++state) sum.by[size_t(state)] += t.by[size_t(state)] * forward;
    return sum;
}

/// The type of light that enters a path in `state` from `source`.
inline PathType type_in(bool settled, int state, LightSource source) {
    return path_type(settled ? LightSource::elsewhere : source, state);
}

}  // namespace tress
