// SPDX-License-Identifier: MIT
// The five types of light paths (Yuksel, Akleman, Keyser 2007, sec. 3). D: light from a lamp. I: light from a surface
// that is not hair, or from the environment. F: straight through a fiber. R: scattered by one in any other way.
#pragma once

#include <algorithm>
#include <array>

#include "core/math.h"

namespace tress {

inline constexpr int kPathTypes = 5;

/// Numbers of the types less one: an index.
enum class PathType : int {
    type1,  // D F*
    type2,  // I F*
    type3,  // D F* R F*
    type4,  // D F* R F* R (F* R*)*
    type5,  // I F* R (F* R*)*
};

/// Where light last came from that was not hair.
enum class LightSource { lamp, elsewhere };

/// The type of light from `source` after `reflections` events R.
inline PathType path_type(LightSource source, int reflections) {
    if (source == LightSource::elsewhere) return reflections == 0 ? PathType::type2 : PathType::type5;
    constexpr PathType of_lamps[] = {PathType::type1, PathType::type3, PathType::type4};
    return of_lamps[std::min(reflections, 2)];
}

/// Their names as layers of pictures.
inline constexpr const char* type_name(PathType type) {
    constexpr const char* names[] = {"type1", "type2", "type3", "type4", "type5"};
    return names[int(type)];
}

/// A value for each type.
template <class T>
using PerType = std::array<T, kPathTypes>;

/// Light of each type that arrives somewhere.
using LightByType = PerType<Rgb>;
using TypeSet = PerType<bool>;

inline constexpr int index_of(PathType type) { return int(type); }
inline bool any(const TypeSet& types) { return std::find(types.begin(), types.end(), true) != types.end(); }

}  // namespace tress
