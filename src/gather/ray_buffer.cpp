// SPDX-License-Identifier: MIT
#include "gather/ray_buffer.h"

namespace tress {

void RayBuffer::add(const Vec3& origin, const Vec3& direction, float t_far, const Excluded& excluded) {
    ox_.push_back(origin.x), oy_.push_back(origin.y), oz_.push_back(origin.z);
    dx_.push_back(direction.x), dy_.push_back(direction.y), dz_.push_back(direction.z);
    t_near_.push_back(0), t_far_.push_back(t_far);
    segment_first_.push_back(excluded.segments.first), segment_last_.push_back(excluded.segments.last);
    triangle_.push_back(excluded.triangle);
}

void RayBuffer::add_from(const RayBuffer& other, size_t ray) {
    add(other.origin(ray), other.direction(ray), other.t_far_[ray],
        {{other.segment_first_[ray], other.segment_last_[ray]}, other.triangle_[ray]});
}

void RayBuffer::clear() {
    for (auto* floats : {&ox_, &oy_, &oz_, &dx_, &dy_, &dz_, &t_near_, &t_far_}) floats->clear();
    for (auto* ids : {&segment_first_, &segment_last_, &triangle_}) ids->clear();
}

}  // namespace tress
