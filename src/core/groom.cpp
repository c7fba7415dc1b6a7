// SPDX-License-Identifier: MIT
#include "core/groom.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>

#include "core/carried_frame.h"
#include "core/error.h"
#include "core/groom_style.h"
#include "core/hair_noise.h"
#include "core/hair_path.h"
#include "core/nearest_name.h"
#include "core/point_grid.h"

namespace tress {
namespace {

constexpr uint64_t kMostSegments = uint64_t(1) << 31;
constexpr size_t kLargeClumps = 260, kSmallClumps = 3200;  // on the whole scalp: locks 1.6 and 0.45 cm apart
constexpr size_t kStrandsPerClump = 8;                     // at least, on average: sparse hair has fewer clumps
constexpr float kPartingGap = 3;                           // cm that keep clumps of the two sides apart
constexpr float kClumpBorder = 0.35f;                      // cm by which the borders of clumps are blurred
constexpr float kLosing = 2.5f, kLost = 6;                 // cm: strands so far from their clump leave it
constexpr float kClumpClearance = 0.05f;                   // cm
constexpr float kUnisonHeight = -1;                        // cm
constexpr int kLaidNode = 8;  // of a path: by here it has turned from the scalp's normal to the combed direction
constexpr float kRootRadius = 0.004f, kRadiusVariation = 0.0005f;  // cm
constexpr float kTipRadius = 0.25f;                                // relative to the root

/// Keys of independent streams.
enum Stream : uint64_t { kLargeStream, kSmallStream, kStrandStream };

const GroomStyle& find_style(std::string_view name) {
    const auto styles = groom_styles();
    const auto found = std::find_if(styles.begin(), styles.end(), [&](const auto& s) { return s.name == name; });
    if (found != styles.end()) return *found;
    const std::vector<std::string> known(groom_names().begin(), groom_names().end());
    throw InputError("groom '" + std::string(name) + "'", "no such groom; " + did_you_mean(name, known));
}

/// Where a root stands for the search of its clump: the two sides of the parting are moved apart.
Vec3 clump_space(const GroomStyle& style, const Vec3& root) {
    return root + Vec3(kPartingGap * parting_strength(style, root) * parting_side(style, root), 0, 0);
}

/// Locks of hair: a path each, with a frame carried along it without twist.
struct Clumps {
    std::vector<uint64_t> key;
    std::vector<HairPath> path;
    std::vector<std::array<Vec3, HairPath::kNodes>> side;  // unit, across the path
    std::vector<float> fallen;                             // arc length at which the path has reached kUnisonHeight
    std::vector<uint32_t> parent;                          // the large clump of a small one, or empty
    PointGrid roots;
};

/// Unit vectors across a path, carried along it; at the root in the plane of the scalp, so that a path that lies on the
/// head has them in the plane of the head, and neighbours have them alike.
std::array<Vec3, HairPath::kNodes> sides(const HairPath& path, const Vec3& normal) {
    std::array<Vec3, HairPath::kNodes> side;
    const auto tangent = [&](int i) {
        const int last = HairPath::kNodes - 1;
        return normalize(path.node[glm::min(i + 1, last)] - path.node[glm::max(i - 1, 0)]);
    };
    const Vec3 out = fiber_frame(tangent(kLaidNode), normal).y;
    for (int i = 0; i <= kLaidNode; ++i) side[i] = out;
    for (int i = kLaidNode + 1; i < HairPath::kNodes; ++i)
        side[i] = carry_side(side[i - 1], tangent(i - 1), tangent(i));
    return side;
}

/// Arc length at which the path falls below the middle of the head: where waves in unison have one phase.
float fallen(const HairPath& path) {
    int n = 0;
    while (n + 1 < HairPath::kNodes && path.node[n].y > kUnisonHeight) ++n;
    return path.step * float(n) + (path.node[n].y - kUnisonHeight);
}

/// How far a strand has come to its clump at arc length s, where the two run `apart` from each other.
float gathered(float s, float length, float apart) {
    return glm::smoothstep(0.05f * length, 0.6f * length, s) * (1 - glm::smoothstep(kLosing, kLost, apart));
}

Clumps make_clumps(const GroomStyle& style, const Scalp& scalp, size_t count, uint64_t key, const Clumps* larger) {
    const Roots roots = place_roots(scalp, count, key);
    std::vector<Vec3> moved(count);
    for (size_t i = 0; i < count; ++i) moved[i] = clump_space(style, roots.point[i]);
    Clumps clumps{.key = std::vector<uint64_t>(count),
                  .path = std::vector<HairPath>(count),
                  .side = std::vector<std::array<Vec3, HairPath::kNodes>>(count),
                  .fallen = std::vector<float>(count),
                  .parent = std::vector<uint32_t>(larger ? count : 0),
                  .roots = PointGrid(moved)};
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
        const uint64_t own = hash(key, i);
        clumps.key[i] = own;
        HairPath& path = clumps.path[i];
        path = grow_path(style, scalp, roots.point[i], roots.normal[i], {own, random(own, 4), 0});
        if (larger) {
            const uint32_t parent = clumps.parent[i] = larger->roots.nearest(moved[i]);
            for (int n = 0; n < HairPath::kNodes; ++n) {
                const Vec3 to = larger->path[parent].node[n];
                const float apart = distance(path.node[n], to);
                const float weight = style.large_clump * gathered(path.step * float(n), path.length(), apart);
                path.node[n] = push_out(scalp, glm::mix(path.node[n], to, weight), kClumpClearance);
            }
        }
        clumps.side[i] = sides(path, roots.normal[i]);
        clumps.fallen[i] = fallen(path);
    });
    return clumps;
}

/// One strand on its way: what its points are computed from.
struct Strand {
    uint64_t key;
    float length, root_radius;
    float clumping;  // to its small clump, at the tip
    float disorder;  // cm at the tip
    float wave_width, wave_length, phase;
};

Strand make_strand(const GroomStyle& style, const Vec3& root, uint64_t key, uint64_t large, uint64_t small) {
    Strand strand;
    strand.key = key;
    const float height = std::pow(root_height(root), style.cut);
    const float meant = style.nape_length + height * (style.crown_length - style.nape_length);
    // Locks are cut to lengths of their own, and few strands are much shorter than their lock.
    const float lock = 1 - 0.5f * (1 - style.shortest) * random(small, 10);
    const float own = 1 - (1 - style.shortest) * square(random(key, 10));
    strand.length = meant * lock * own;
    strand.root_radius = kRootRadius + kRadiusVariation * signed_random(key, 11);
    const bool flyaway = random(key, 12) < style.flyaways;
    strand.clumping = flyaway ? 0.15f : style.small_clump * (1 - 0.35f * square(random(key, 13)));
    strand.disorder = style.disorder * (flyaway ? 2.0f : 0.3f + square(random(key, 14)));
    strand.wave_width = style.wave_width * (0.75f + 0.4f * random(small, 15) + 0.15f * signed_random(key, 15));
    strand.wave_length = style.wave_length * (1 + 0.15f * signed_random(large, 16) + 0.08f * signed_random(small, 16));
    const float apart = (1 - style.unison) * kPi * signed_random(large, 17);
    const float spread = 0.5f * signed_random(small, 17) + 0.25f * signed_random(key, 17);
    strand.phase = apart + spread * (flyaway ? 3.0f : 1.0f);
    return strand;
}

/// The strand's way round its clump at arc length s.
Vec3 wave(const GroomStyle& style, const Strand& strand, const Clumps& clumps, uint32_t clump, float s) {
    const HairPath& path = clumps.path[clump];
    const int n = glm::clamp(int(s / path.step + 0.5f), 1, HairPath::kNodes - 2);
    const Vec3 tangent = normalize(path.node[n + 1] - path.node[n - 1]);
    const Vec3 side = clumps.side[clump][n], up = cross(tangent, side);
    const float width = strand.wave_width * glm::smoothstep(0.0f, style.wave_start, s);
    const float at = s / (2 * strand.wave_length);
    const float wobble =
        0.6f * line_noise(hash(clumps.key[clump], 18), at) + 0.2f * line_noise(hash(strand.key, 18), at);
    const float angle = 2 * kPi * (s - clumps.fallen[clump]) / strand.wave_length + strand.phase + wobble;
    return width * (std::cos(angle) * side + style.roundness * std::sin(angle) * up);
}

}  // namespace

std::span<const std::string_view> groom_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const GroomStyle& style : groom_styles()) all.push_back(style.name);
        return all;
    }();
    return names;
}

StrandSet make_groom(std::string_view name, uint64_t segments, uint64_t seed) {
    const GroomStyle& style = find_style(name);
    if (segments == 0 || segments > kMostSegments)
        throw InputError("groom '" + std::string(name) + "'",
                         std::to_string(segments) + " segments; expected 1 to " + std::to_string(kMostSegments));
    const uint64_t per_strand = std::min<uint64_t>(segments, style.points - 1);
    const size_t count = size_t((segments + per_strand / 2) / per_strand), points = size_t(per_strand) + 1;

    const Scalp scalp = make_scalp();
    const auto clump_count = [&](size_t most) { return std::clamp<size_t>(count / kStrandsPerClump, 1, most); };
    const Clumps large = make_clumps(style, scalp, clump_count(kLargeClumps), hash(seed, kLargeStream), nullptr);
    const Clumps small = make_clumps(style, scalp, clump_count(size_t(style.locks)), hash(seed, kSmallStream), &large);
    const uint64_t strand_key = hash(seed, kStrandStream);
    const Roots roots = place_roots(scalp, count, strand_key);

    StrandSet set;
    set.x.resize(count * points), set.y.resize(count * points), set.z.resize(count * points);
    set.radius.resize(count * points);
    set.first.resize(count + 1);
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
        const uint64_t key = hash(strand_key, i);
        const Vec3 root = roots.point[i];
        const Vec3 blur(signed_random(key, 20), signed_random(key, 21), signed_random(key, 22));
        const uint32_t clump = small.roots.nearest(clump_space(style, root) + kClumpBorder * blur);
        const Strand strand = make_strand(style, root, key, large.key[small.parent[clump]], small.key[clump]);
        const bool flyaway = strand.clumping < 0.2f;
        const HairPath own =
            grow_path(style, scalp, root, roots.normal[i], {key, random(key, 4), flyaway ? random(key, 5) : 0.0f});
        set.first[i] = uint32_t(i * points);
        for (size_t k = 0; k < points; ++k) {
            const float t = float(k) / float(points - 1), s = strand.length * t;
            const size_t at = i * points + k;
            Vec3 p = root;
            if (k > 0) {
                const Vec3 alone = own.at(s), together = small.path[clump].at(s);
                const float apart = distance(alone, together);
                p = glm::mix(alone, together, strand.clumping * gathered(s, strand.length, apart));
                p += wave(style, strand, small, clump, s);
                p += strand.disorder * t * line_noise3(hash(key, 23), 0.15f * s);
                p = push_out(scalp, p, glm::min(0.1f, 0.2f * s));
            }
            set.x[at] = p.x, set.y[at] = p.y, set.z[at] = p.z;
            set.radius[at] = strand.root_radius * (1 - (1 - kTipRadius) * glm::smoothstep(0.4f, 1.0f, t));
        }
    });
    set.first[count] = uint32_t(count * points);
    return set;
}

}  // namespace tress
