// SPDX-License-Identifier: MIT
// Sequences of numbers for the parts of the pixel loop: each has all dimensions to itself.
#pragma once

#include "core/rng.h"
#include "core/sampler.h"

namespace tress {

enum class Stream : uint64_t { gather = 1, crossings, paths, projection };

/// The sequence of `stream` beside that of a pixel.
inline Sampler stream_of(const Sampler& sampler, Stream stream) {
    return {hash(sampler.key, uint64_t(stream)), sampler.index};
}

}  // namespace tress
