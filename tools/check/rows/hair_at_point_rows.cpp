// SPDX-License-Identifier: MIT
// Points that lie on the hair which is projected, or in it.
#include <algorithm>

#include "tools/check/rows/projection_rows.h"
#include "tools/check/support/cone_coverage.h"

namespace tress {
namespace {

using namespace test;

constexpr ProjectionDetail kDetails[] = {ProjectionDetail::all, ProjectionDetail::tree};

/// Turned and moved somewhere.
StrandSet placed(StrandSet strands, uint64_t key) {
    const Frame frame = random_frame(key);
    const Vec3 to(random(key, 5), random(key, 6), random(key, 7));
    for (size_t i = 0; i < strands.points(); ++i) {
        const Vec3 p = to + frame.to_world(strands.point(i));
        strands.x[i] = p.x, strands.y[i] = p.y, strands.z[i] = p.z;
    }
    return strands;
}

struct LoneHair {
    int segments;
    float segment, radius;
};
/// All within kOwnStrandRadii of each of their points, or of touching segments.
constexpr LoneHair kShortHairs[] = {
    {1, 1, 0.02f}, {1, 100, 0.001f}, {2, 1, 0.01f}, {4, 0.08f, 0.02f}, {60, 0.005f, 0.02f}};
constexpr LoneHair kLongHairs[] = {{15, 1, 0.0035f}, {100, 0.1f, 0.0035f}, {300, 0.01f, 0.004f}};

/// What hair hides from points on it, as a share of the sphere.
struct SelfOcclusion {
    double on_axis = 0, on_surface = 0;  // greatest
    int points = 0, not_finite = 0;

    void see(const ProjectedHair& hair, uint32_t segment, Isa isa) {
        const SegmentView view = hair.segments();
        const Unseen unseen = unseen_on(view, segment);
        const uint64_t key = hash(3, segment);
        const Vec3 a = view.start(segment), b = view.end(segment), across = frame_about(normalize(b - a)).x;
        const auto occlusion = [&](const Vec3& place) {
            const std::vector<Rgb> cells = seen_with(isa, hair, {place, random_frame(key), Dome::sphere, {}}, unseen);
            ++points;
            not_finite += !all_within_unit(cells);
            return 1 - mean_of(cells);
        };
        for (const Vec3& place : {a, b, 0.5f * (a + b), glm::mix(a, b, random(key, 3))}) {
            on_axis = std::max(on_axis, occlusion(place));
            on_surface = std::max(on_surface, occlusion(place + view.start_radius(segment) * across));
        }
    }
};

SelfOcclusion self_occlusion(std::span<const LoneHair> hairs, ProjectionDetail detail, Isa isa) {
    const Attenuation fiber = gray_fiber();
    SelfOcclusion found;
    for (const LoneHair& hair : hairs)
        for (const int cells : {16, 256, 4096})
            for (uint64_t turn = 0; turn < 3; ++turn) {
                Options options = without_gap();
                options.projection.cells = cells;
                const StrandSet strands = placed(straight_fiber(hair.segments, hair.segment, hair.radius), turn);
                const ProjectedHair lone = projected(strands, fiber, detail, options);
                const uint32_t last = uint32_t(lone.segments().size()) - 1;
                for (const uint32_t segment : {0u, last / 2, last}) found.see(lone, segment, isa);
            }
    return found;
}

/// A bent strand of many segments, each at most a radius long; some points are given twice where asked for.
StrandSet bent_strand(uint64_t key, bool doubled) {
    constexpr uint64_t kPoints = 60;
    StrandSet strand;
    strand.constant_radius = 0.02f;
    Vec3 place(0);
    for (uint64_t i = 0; i < kPoints; ++i) {
        strand.add_point(place);
        if (doubled && i % 7 == 6) strand.add_point(place);
        const Vec3 way(1, random(key, 3 * i), random(key, 3 * i + 1));
        place += 0.02f * (0.1f + 0.9f * random(key, 3 * i + 2)) * normalize(way);
    }
    strand.first = {0, uint32_t(strand.points())};
    return strand;
}

/// Segments that begin within a radius of the middle of another, along their strand, and are seen from there all the
/// same.
int neighbors_seen(const StrandSet& strand) {
    const SegmentList list = list_segments(strand);
    const SegmentView hair = view(strand, list);
    std::vector<float> at{0};  // of the start of each segment along the strand, and of the last's end
    for (uint32_t i = 0; i < hair.size(); ++i) at.push_back(at.back() + distance(hair.start(i), hair.end(i)));
    int seen = 0;
    for (uint32_t i = 0; i < hair.size(); ++i) {
        const Unseen unseen = unseen_on(hair, i);
        const float middle = 0.5f * (at[i] + at[i + 1]), radius = hair.start_radius(i);
        for (uint32_t k = 0; k < hair.size(); ++k) {
            const bool near = at[k] <= middle + radius && at[k + 1] >= middle - radius;
            seen += near && !unseen.holds(k);
        }
    }
    return seen;
}

int neighbors_seen(int strands, bool doubled) {
    int seen = 0;
    for (int i = 0; i < strands; ++i) seen += neighbors_seen(bent_strand(hash(4, uint64_t(i)), doubled));
    return seen;
}

Outcome point_on_axis(const CheckSettings& settings) {
    Outcome outcome;
    std::vector<Figure>& figures = outcome.figures;
    int not_finite = 0;
    for (const auto& [detail, by] :
         {std::pair(ProjectionDetail::all, ", every segment"), {ProjectionDetail::tree, ", tree"}}) {
        const SelfOcclusion near = self_occlusion(kShortHairs, detail, settings.isa);
        const SelfOcclusion far = self_occlusion(kLongHairs, detail, settings.isa);
        not_finite += near.not_finite + far.not_finite;
        const auto tried = [&, by = by](const SelfOcclusion& s) {
            return by + (", " + std::to_string(s.points / 2)) + " points";
        };
        figures.push_back(
            within("occlusion of a lone hair on its axis, all of it left out" + tried(near), near.on_axis, 0, 1e-6));
        figures.push_back(within("likewise on its surface", near.on_surface, 0, 1e-6));
        figures.push_back(within("of a longer straight hair on its axis" + tried(far), far.on_axis, 0, 1e-6));
        figures.push_back(told("on its surface, where a little of it is seen", far.on_surface));
    }
    figures.push_back(exactly("of these, points with cells that are not in [0, 1]", not_finite, 0));
    figures.push_back(
        exactly("neighbours within a radius that are seen, 100 bent strands", neighbors_seen(100, false), 0));
    figures.push_back(exactly("likewise where every seventh point is given twice", neighbors_seen(100, true), 0));
    return outcome;
}

/// A segment whose axis passes through a point: exactly, or as near as rounding lets it.
struct PiercedCone {
    Cone cone;
    Vec3 point, u;
    bool ends_there;
};

PiercedCone pierced_cone(uint64_t key) {
    const Vec3 u = sample_uniform_sphere({random(key, 0), random(key, 1)});
    const float length = 0.1f + random(key, 2), radius = length * std::pow(10.0f, -1 - 3 * random(key, 3));
    if (key & 1) {  // halves, or an end, by exact multiples
        const float share = key & 2 ? 0.0f : key & 4 ? 0.25f : 1.0f;
        return {{-share * length * u, length * u, radius, radius}, Vec3(0), u, share == 0};
    }
    const Vec3 at(random(key, 4), random(key, 5), random(key, 6));
    const float share = 0.02f + 0.96f * random(key, 7);
    return {{at - share * length * u, at + (1 - share) * length * u, radius, radius}, at, u, false};
}

/// Whether one of the cells about a direction is covered: of a cell that half a sphere cuts, its samples may be none.
bool is_covered_towards(const Igloo& igloo, const std::vector<double>& covered, const Vec3& direction) {
    for (uint32_t cell = 0; cell < covered.size(); ++cell) {
        const Vec3 middle(igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]);
        if (covered[cell] > 0 && dot(middle, direction) > std::cos(2 * igloo.cell_radius)) return true;
    }
    return false;
}

struct PiercedCoverage {
    double most_of_touched = 0, most_of_cell = 0;
    int tried = 0, not_finite = 0, ends_unseen = 0;

    void see(const PiercedCone& pierced, ProjectionDetail detail, int cells, Isa isa) {
        Options options = without_gap();
        options.projection.cells = cells;
        const ProjectedHair hair = faint(pierced.cone, detail, options);
        const Viewpoint from{pierced.point, random_frame(uint64_t(tried)), Dome::sphere, {}};
        double sum = 0;
        int touched = 0;
        const std::vector<double> covered = coverage(hair, from, double(kFaint), isa);
        for (const double share : covered) {
            sum += share, touched += share != 0;
            most_of_cell = std::max(most_of_cell, share);
        }
        ++tried;
        not_finite += !std::isfinite(sum);
        most_of_touched = std::max(most_of_touched, touched > 0 ? sum / touched : 0);
        const Vec3 end = from.frame.to_local(pierced.u);
        if (pierced.ends_there) return;
        ends_unseen += !is_covered_towards(hair.projection.igloo, covered, end);
        ends_unseen += !is_covered_towards(hair.projection.igloo, covered, -end);
    }
};

Outcome segment_through_point(const CheckSettings& settings) {
    PiercedCoverage found;
    for (uint64_t i = 0; i < 500; ++i)
        for (const ProjectionDetail detail : kDetails)
            for (const int cells : {16, 256}) found.see(pierced_cone(hash(5, i)), detail, cells, settings.isa);
    return {{exactly("sums that are not finite, of " + std::to_string(found.tried), found.not_finite, 0),
             at_most("sum of coverage over cells touched", found.most_of_touched, 1),
             told("coverage of one cell, most", found.most_of_cell),
             exactly("ends towards which no cell is covered", found.ends_unseen, 0)},
            {}};
}

}  // namespace

std::vector<CheckRow> hair_at_point_rows() {
    return {
        {"D11", "a point on its own hair's axis", "its own fiber is left out by identity: finite, no occlusion",
         point_on_axis},
        {"D12", "a segment through the point", "finite, nothing counted twice, both ends seen", segment_through_point}};
}

}  // namespace tress
