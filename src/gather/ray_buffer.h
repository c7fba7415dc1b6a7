// SPDX-License-Identifier: MIT
// Rays gathered one by one into the arrays that queries take.
#pragma once

#include <vector>

#include "accel/queries.h"
#include "core/segments.h"

namespace tress {

/// What a ray must not meet because it starts there: segments of the hair tree, one triangle of the mesh tree.
struct Excluded {
    SegmentRange segments{1, 0};  // none
    uint32_t triangle = kNone;
};

class RayBuffer {
public:
    void add(const Vec3& origin, const Vec3& direction, float t_far, const Excluded& excluded);
    void add_from(const RayBuffer& other, size_t ray);
    void clear();
    void set_far(size_t ray, float t_far) { t_far_[ray] = t_far; }

    size_t size() const { return ox_.size(); }
    Vec3 direction(size_t ray) const { return {dx_[ray], dy_[ray], dz_[ray]}; }
    float far(size_t ray) const { return t_far_[ray]; }
    Vec3 origin(size_t ray) const { return {ox_[ray], oy_[ray], oz_[ray]}; }
    RayBatch for_hair() const { return batch(segment_first_, segment_last_); }
    RayBatch for_mesh() const { return batch(triangle_, triangle_); }

private:
    RayBatch batch(std::span<const uint32_t> first, std::span<const uint32_t> last) const {
        return {ox_, oy_, oz_, dx_, dy_, dz_, t_near_, t_far_, first, last};
    }
    std::vector<float> ox_, oy_, oz_, dx_, dy_, dz_, t_near_, t_far_;
    std::vector<uint32_t> segment_first_, segment_last_, triangle_;
};

}  // namespace tress
