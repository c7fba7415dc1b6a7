// SPDX-License-Identifier: MIT
// What a user can choose, with defaults, ranges and units. One field list (option_fields) feeds JSON, --set, the
// command's help, the plan and the metadata of pictures; no other list of these names exists.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/path_type.h"

namespace tress {

enum class LampMethod : int { off, ray, deep, opacity, clusters, path, automatic };       // type 1
enum class GatherMethod : int { off, ray, projection, path, automatic };                  // type 2
enum class CrossingMethod : int { off, ray, ray_deep, ray_opacity, ray_clusters, path };  // type 3
enum class ScatteredMethod : int { off, photons, path };                                  // types 4 and 5
enum class ScatteringModel : int { straight, full };
enum class Isa : int { automatic, scalar, sse4, avx2, avx512 };
enum class ProjectionDetail : int { automatic, all, simplified, layers, tree };
enum class LayerMeasure : int { root, segment };
enum class FarField : int { off, on, automatic };
enum class SplitMethod : int { binned, exact, naive, spatial_median, object_median };

/// Parameters of the kd-tree after Havran 2000 and Wald & Havran 2006.
struct AccelOptions {
    SplitMethod split = SplitMethod::binned;
    float traversal_cost = 20;  // of a step, in tests of one segment: too low makes tiny leaves, see docs/tree.md
    float empty_bonus = 0.2f;   // share of the cost taken off where one side is empty
    int bins = 32;              // an axis
    int exact_below = 32;       // references: smaller nodes are swept exactly (binned only)
    bool clip = true;           // split clipping: a reference is cut to its cell
    bool automatic = true;      // stop where no split is cheaper than a leaf; otherwise at leaf_size and max_depth
    int leaf_size = 8;          // references a leaf may keep unsplit when automatic is off
    float depth_base = 8;       // depth limit = depth_base + depth_factor log2(n), at most 60
    float depth_factor = 1.8f;
    int failed_splits = 0;    // splits dearer than a leaf allowed on a path
    float references = 5.4f;  // a segment, that all leaves together may hold: bounds the memory of dense hair
};

inline constexpr int kMostSamples = 1 << 20;  // a pixel

struct PhotonOptions {
    int count = 1'000'000;  // emitted, from all lights together
    int nearest = 50;       // that an estimate takes
    float radius = 0;       // the largest of an estimate, scene units; 0: by the density of photons
};

struct GatherOptions {
    int rays = 1;       // a camera sample, for types 2 (to polygons and to each sky) and 3
    int crossings = 1;  // of a ray, shaded for type 3, drawn by what they are seen through; 0: every one
};

enum class MapKind : int { deep, opacity, clusters };  // of shadow maps
inline constexpr int kMapKinds = 3;

struct MapOptions {
    int resolution = 128;      // texels of the longer side of a view; finer costs time and memory, coarser sharpness
    int grid = 2;              // a quad light has grid x grid views
    float near = 4;            // texel widths next to a point that rays are traced through before a map is asked
    float near_crossings = 0;  // the same next to crossings of gather rays (type 3)
};

struct DeepOptions {
    float error = 0.02f;  // greatest error of transmittance by compression; 0: none is allowed
};

struct OpacityOptions {
    int layers = 32;      // too few band the hair
    bool follow = false;  // layers start at each texel's first hair (deep opacity maps)
};

struct ClusterOptions {
    int count = 4;  // a texel
};

/// Type 2 by projection of hair onto cells about each point.
struct ProjectionOptions {
    int cells = 256;  // a hemisphere; fewer are faster, and take more light than there is, or less
    ProjectionDetail detail = ProjectionDetail::automatic;
    int directions = 64;    // drawn a point by its scattering, seen through its cells
    int rays = 16;          // at polygons: directions, each a ray
    int probes = 0;         // cubes across the hair whose corners see what lies beyond; 0: 64, or 128 with far_field
    int probe_cells = 256;  // a hemisphere of a probe, a ray to polygons each
    FarField far_field = FarField::automatic;  // tree: points share far hair, as these corners see it
    float near = 0.35f;                        // share of a cell: wider hair is told apart by samples of cells
    float opening = 3;                         // tree: cubes larger than this many cells are opened
    float splats = 2;                          // tree: that stand for a cube as large as a cell
    int leaf = 16;                             // tree: pieces of hair that a cube may keep undivided
    float cube = 0;                            // tree: sides of the smallest cube, scene units; 0: 1/256 of the hair
    float gap = -1;       // share of the gap between neighbouring cells that is added; below 0: as rays show
    float scatter = 0;    // share of cells' scatter that is taken off, where gap is given
    float share = 0.25f;  // simplified: of strands that are kept, as wide as those they stand for
    int stride = 1;       // simplified: segments of a strand that become one
    float layer = 4;      // layers: s of the paper, scene units; layer i keeps every i-th segment
    LayerMeasure measure = LayerMeasure::root;  // layers: by the distance of a strand's root, or of the segment itself
    bool weighted = true;                       // layers, simplified: what is kept counts for what is left out
};

struct FilmOptions {
    float filter_radius = 1.5f;  // pixels; Blackman-Harris, sampled by importance
    float exposure = 0;          // stops, of the PNG only
};

struct Options {
    LampMethod type1 = LampMethod::ray;
    GatherMethod type2 = GatherMethod::ray;
    CrossingMethod type3 = CrossingMethod::ray;
    ScatteredMethod type4 = ScatteredMethod::off, type5 = ScatteredMethod::off;
    ScatteringModel scattering = ScatteringModel::straight;  // of the method `path`
    int spp = 64;                                            // samples a pixel
    double time = 0;  // seconds of rendering after which no new pass starts; 0: none
    uint64_t seed = 0;
    int threads = 0;  // 0: all
    Isa isa = Isa::automatic;
    float cutoff = 1e-6f;  // transmittance below which a ray counts as blocked
    AccelOptions accel;
    PhotonOptions photons;
    GatherOptions gather;
    MapOptions maps;
    DeepOptions deep;
    OpacityOptions opacity;
    ClusterOptions clusters;
    ProjectionOptions projection;
    FilmOptions film;
};

/// An enum option, as its number and the names of its values in order.
struct Choice {
    int* value;
    std::span<const std::string_view> names;
};

/// One option: where it lives, what it is called ("accel.bins"), what it may be.
struct OptionField {
    std::string key;
    std::variant<bool*, int*, uint64_t*, float*, double*, Choice> value;
    double lowest, highest;  // inclusive; ignored for bool and Choice
    std::string_view help;   // one line, with the unit
};

/// The field list, bound to `options`.
std::vector<OptionField> option_fields(Options& options);

/// Sets `key` from text; throws InputError that names `where`, the nearest known key, or the range.
void set_option(Options& options, const std::string& where, std::string_view key, std::string_view text);

/// All types by `path`.
void use_paths(Options& options);
void switch_off(Options& options, PathType type);

/// Shadow maps that a method asks, if any.
std::optional<MapKind> map_kind(LampMethod method);
std::optional<MapKind> map_kind(CrossingMethod method);

/// "avx2" …
std::string_view isa_name(Isa isa);

/// The value as set_option would read it.
std::string option_text(const OptionField& field);

/// All options as lines of "key=value", in the order of the list, without those named.
std::string options_text(Options options, std::initializer_list<std::string_view> without = {});

/// "one of a, b, c" or "a whole number from 1 to 64": what a field accepts.
std::string accepted(const OptionField& field);

}  // namespace tress
