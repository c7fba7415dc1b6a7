// SPDX-License-Identifier: MIT
// Hair over the pole of the igloo, and across the seam of its azimuths.
#include <algorithm>

#include "tools/check/rows/projection_rows.h"
#include "tools/check/support/cone_coverage.h"

namespace tress {
namespace {

using namespace test;

constexpr ProjectionDetail kDetails[] = {ProjectionDetail::all, ProjectionDetail::tree};

Viewpoint at_origin(const Frame& frame) { return {Vec3(0), frame, Dome::sphere, {}}; }

/// A segment through a place on the axis of z, `distance` away.
Cone over_pole(uint64_t key, float distance, float length, float radius) {
    const Vec3 along = sample_uniform_sphere({0.5f + 0.3f * (random(key, 0) - 0.5f), random(key, 1)});
    const float share = 0.2f + 0.6f * random(key, 2);
    const Vec3 pole(0, 0, distance);
    return {pole - share * length * along, pole + (1 - share) * length * along, radius, radius};
}

enum class PoleHair { thin, wide, far, tuft };

StrandSet hair_over_pole(PoleHair kind, uint64_t key) {
    const float size = std::exp2(2 * random(key, 9));
    std::vector<Cone> cones;
    if (kind == PoleHair::thin) cones.push_back(over_pole(key, 1, 2, 0.005f * size));
    if (kind == PoleHair::wide) cones.push_back(over_pole(key, 1, 2, 0.08f * size));
    if (kind == PoleHair::far) cones.push_back(over_pole(key, 8 * size, 1, 0.05f));
    for (uint64_t i = 0; kind == PoleHair::tuft && i < 64; ++i)
        cones.push_back(over_pole(hash(key, i), 1 + 0.01f * float(i), 2, 0.006f));
    return strands_of(cones);
}

/// How much visibility, a share of the sphere, changes as the igloo is turned.
struct TurnedVisibility {
    double most_change = 0, least = 1;
    int turns = 0;

    void see(const StrandSet& strands, uint64_t key, ProjectionDetail detail, const Attenuation& fiber, Isa isa) {
        const ProjectedHair hair = projected(strands, fiber, detail, without_gap());
        const double upright = mean_of(seen_with(isa, hair, at_origin(kUpright)));
        least = std::min(least, upright);
        for (uint64_t turn = 0; turn < 20; ++turn, ++turns) {
            const double turned = mean_of(seen_with(isa, hair, at_origin(random_frame(hash(key, 100 + turn)))));
            most_change = std::max(most_change, std::abs(turned - upright));
        }
    }
};

/// Cells of the two rows about the pole that thin segments cross by more than 0.6 of a cell's side, and are not in.
int cells_missed_at_pole(Isa isa) {
    int missed = 0;
    for (uint64_t i = 0; i < 50; ++i) {
        const Cone cone = over_pole(hash(7, i), 1, 2, 0.002f);
        const ProjectedHair hair = faint(cone, ProjectionDetail::all, without_gap());
        const Igloo& igloo = hair.projection.igloo;
        const Viewpoint from = at_origin(kUpright);
        const std::vector<double> covered = coverage(hair, from, double(kFaint), isa);
        const std::vector<double> truth = sampled_coverage(igloo, cone, from, 1, 10000, i);
        const double width = 2 * ConeSight(cone, Vec3(0)).half;
        for (uint32_t cell = 0; cell < igloo.row_first[2]; ++cell) {
            const double crossed = truth[cell] * double(igloo.solid_angle()) / width;
            missed += crossed > 0.6 * double(igloo.cell_size()) && !(covered[cell] > 0);
        }
    }
    return missed;
}

Outcome pole(const CheckSettings& settings) {
    const Attenuation fiber = gray_fiber();
    Outcome outcome;
    const auto turned = [&](PoleHair kind) {
        TurnedVisibility found;
        for (uint64_t i = 0; i < 10; ++i)
            for (const ProjectionDetail detail : kDetails)
                found.see(hair_over_pole(kind, hash(6, i)), hash(6, i), detail, fiber, settings.isa);
        return found;
    };
    for (const auto& [kind, name] :
         {std::pair(PoleHair::thin, "a thin"), {PoleHair::wide, "a wide"}, {PoleHair::far, "a far"}}) {
        const TurnedVisibility found = turned(kind);
        outcome.figures.push_back(at_most(
            "change of visibility by " + std::string(name) + " segment, " + std::to_string(found.turns) + " turns",
            found.most_change, 1e-3));
        outcome.figures.push_back(told("least visibility", found.least));
    }
    // Where hair overlaps, exp of a cell's mean depth is less than what it lets through, by how much depends on which
    // hair shares cells.
    outcome.figures.push_back(told("change by 64 segments that cross there", turned(PoleHair::tuft).most_change));
    outcome.figures.push_back(exactly("cells about the pole that a segment crosses and leaves empty, 50 segments",
                                      cells_missed_at_pole(settings.isa), 0));
    return outcome;
}

/// The cell on the other side of the plane y = 0.
uint32_t mirrored(const Igloo& igloo, uint32_t cell) {
    const uint32_t lower = cell >= igloo.cells ? igloo.cells : 0;
    const auto next = std::upper_bound(igloo.row_first.begin(), igloo.row_first.end(), cell - lower);
    return lower + *(next - 1) + *next - 1 - (cell - lower);
}

/// A segment from one side of the plane y = 0 to the other, where x is positive or negative.
Cone across_seam(uint64_t key, float radius) {
    const float side = key & 1 ? 1.0f : -1.0f, far = key & 2 ? 1.0f : 1 + 20 * random(key, 0);
    const auto end = [&](uint64_t i, float way) {
        return Vec3(side * (far + random(key, i)), way * random(key, i + 1), 2 * far * (2 * random(key, i + 2) - 1));
    };
    return {end(1, -1), end(4, 1), radius, radius};
}

/// What all of `cones` let through in each cell about the origin.
std::vector<Rgb> through(const std::vector<Cone>& cones, const Attenuation& attenuation, Isa isa) {
    return seen_with(isa, projected(strands_of(cones), attenuation, ProjectionDetail::all, without_gap()),
                     at_origin(kUpright));
}

/// Whether the mirrored scene is seen in mirrored cells, to the bit.
bool is_mirrored(const Igloo& igloo, const std::vector<Cone>& cones, const Attenuation& attenuation, Isa isa) {
    std::vector<Cone> other = cones;
    for (Cone& cone : other) cone.a.y = -cone.a.y, cone.b.y = -cone.b.y;
    const std::vector<Rgb> here = through(cones, attenuation, isa), there = through(other, attenuation, isa);
    for (uint32_t cell = 0; cell < here.size(); ++cell)
        if (here[cell] != there[mirrored(igloo, cell)]) return false;
    return true;
}

/// Whether a cell is farther from the segment than half a step on the way there and the corner of a cell.
bool is_far(const Igloo& igloo, uint32_t cell, const Cone& cone) {
    const Vec3 middle(igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]);
    float nearest = kPi;
    constexpr int kPlaces = 64;
    for (int i = 0; i <= kPlaces; ++i) {
        const Vec3 place = glm::mix(cone.a, cone.b, float(i) / kPlaces);
        const float around = safe_asin(cone.radius_a / length(place));
        nearest = std::min(nearest, std::acos(std::clamp(dot(middle, normalize(place)), -1.0f, 1.0f)) - around);
    }
    return nearest > 1.5f * igloo.cell_radius;
}

int far_cells(const Igloo& igloo, const Cone& cone, const Attenuation& attenuation, Isa isa) {
    const std::vector<Rgb> cells = through({cone}, attenuation, isa);
    int far = 0;
    for (uint32_t cell = 0; cell < cells.size(); ++cell) far += cells[cell] != Rgb(1) && is_far(igloo, cell, cone);
    return far;
}

Outcome seam(const CheckSettings& settings) {
    constexpr int kScenes = 200, kThin = 200;  // thin ones a scene; of wide ones, one
    const Igloo igloo = make_igloo(uint32_t(ProjectionOptions{}.cells));
    const Attenuation fiber = gray_fiber();
    int thin = 0, wide = 0, smeared = 0;
    for (uint64_t scene = 0; scene < kScenes; ++scene) {
        const uint64_t key = hash(8, scene);
        std::vector<Cone> cones;
        for (uint64_t i = 0; i < kThin; ++i)
            cones.push_back(across_seam(hash(key, i), 0.02f * std::exp2(-6 * random(key, i))));
        thin += !is_mirrored(igloo, cones, fiber, settings.isa);
        const Cone broad = across_seam(key, 0.1f + 0.2f * random(key, kThin));
        wide += !is_mirrored(igloo, {broad}, fiber, settings.isa);
        for (const Cone& cone : {cones.front(), broad}) smeared += far_cells(igloo, cone, fiber, settings.isa);
    }
    return {{exactly("mirrored scenes whose cells differ, 200 thin segments each, of 200", thin, 0),
             exactly("likewise of one wide segment", wide, 0),
             exactly("cells away from their segment that are covered, 400 segments", smeared, 0)},
            {}};
}

}  // namespace

std::vector<CheckRow> cell_border_rows() {
    return {{"D13", "segments over the pole", "visibility does not change as cells are turned", pole},
            {"D14", "segments across the seam of azimuths", "mirrored scenes give mirrored cells, to the bit", seam}};
}

}  // namespace tress
