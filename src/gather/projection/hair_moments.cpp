// SPDX-License-Identifier: MIT
#include "gather/projection/hair_moments.h"

#include "core/rng.h"

namespace tress {
namespace {

constexpr uint64_t kSampleKey = hash(0, 0x6d6f6d656e7473);

}  // namespace

void HairMoments::add(const HairPiece& piece) {
    const DVec3 a(piece.a), b(piece.b), axis = b - a;
    const double length = glm::length(axis);
    const double weight = length * double(piece.radius_a + piece.radius_b);
    if (!(weight > 0)) return;
    const DVec3 t = axis / length;
    HairMoments own;
    own.area = weight;
    own.first = weight * 0.5 * (a + b);
    own.second = weight * (a * a + a * b + b * b) / 3.0;
    own.tensor[0] = weight * t.x * t.x, own.tensor[1] = weight * t.y * t.y, own.tensor[2] = weight * t.z * t.z;
    own.tensor[3] = weight * t.x * t.y, own.tensor[4] = weight * t.x * t.z, own.tensor[5] = weight * t.y * t.z;
    own.sample = piece.segment;
    add(own);
}

void HairMoments::add(const HairMoments& o) {
    if (!(o.area > 0)) return;
    area += o.area;
    first += o.first;
    second += o.second;
    for (int i = 0; i < 6; ++i) tensor[i] += o.tensor[i];
    if (double(random(hash(kSampleKey, sample), o.sample)) * area < o.area) sample = o.sample;
}

}  // namespace tress
