// SPDX-License-Identifier: MIT
// The files of `tress trace`: segments, rays and hits as plain little-endian arrays, to feed the hair tree alone and
// to compare what it says with other tracers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tress {

/// "TRSEG001", u64 n, n x 7 f32 (start, end, radius). Points 2 i and 2 i + 1 are the ends of segment i.
struct TraceSegments {
    std::vector<float> x, y, z, radius;  // one a point
    std::vector<uint32_t> point;         // one a segment: its first point

    size_t size() const { return point.size(); }
};

/// "TRRAY001", u64 n, n x 8 f32 (origin, t_near, direction, t_far).
struct TraceRays {
    std::vector<float> ox, oy, oz, dx, dy, dz, t_near, t_far;

    size_t size() const { return ox.size(); }
};

/// "TRHIT001", u64 n, n x (f32 t or infinity, u32 segment or 0xffffffff, f32 transmittance, u32 crossings).
struct TraceHits {
    std::vector<float> t, transmittance;
    std::vector<uint32_t> segment, crossings;

    size_t size() const { return t.size(); }
};

/// Throw InputError where the file is not one of these, or shorter or longer than it says, or holds a segment that is
/// not finite or whose radius is negative. Rays may hold anything.
TraceSegments read_trace_segments(const std::string& path);
TraceRays read_trace_rays(const std::string& path);
TraceHits read_trace_hits(const std::string& path);

/// Written whole or not at all.
void write_trace_segments(const std::string& path, const TraceSegments& segments);
void write_trace_rays(const std::string& path, const TraceRays& rays);
void write_trace_hits(const std::string& path, const TraceHits& hits);

}  // namespace tress
