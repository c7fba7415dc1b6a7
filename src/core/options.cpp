// SPDX-License-Identifier: MIT
#include "core/options.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/shortest_text.h"

namespace tress {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kLampNames[] = {"off", "ray", "deep", "opacity", "clusters", "path", "auto"};
constexpr std::string_view kCrossingNames[] = {"off", "ray", "ray+deep", "ray+opacity", "ray+clusters", "path"};
constexpr std::string_view kGatherNames[] = {"off", "ray", "projection", "path", "auto"};
constexpr std::string_view kDetailNames[] = {"auto", "all", "simplified", "layers", "tree"};
constexpr std::string_view kFarFieldNames[] = {"off", "on", "auto"};
constexpr std::string_view kMeasureNames[] = {"root", "segment"};
constexpr std::string_view kScatteredNames[] = {"off", "photons", "path"};
constexpr std::string_view kScatteringNames[] = {"straight", "full"};
constexpr std::string_view kIsaNames[] = {"auto", "scalar", "sse4", "avx2", "avx512"};
constexpr std::string_view kSplitNames[] = {"binned", "exact", "naive", "spatial_median", "object_median"};
constexpr double kMaxCount = 1e9;

template <class Enum>
Choice choice(Enum& value, std::span<const std::string_view> names) {
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, int>);
    return {reinterpret_cast<int*>(&value), names};
}

/// Ends included: a float's bounds are rounded to float first.
template <class T>
bool in_range(T value, const OptionField& field) {
    using Bound = std::conditional_t<std::is_same_v<T, float>, float, double>;
    return Bound(value) >= Bound(field.lowest) && Bound(value) <= Bound(field.highest);
}

template <class T>
T parse_number(const std::string& where, const OptionField& field, std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || !in_range(value, field))
        throw InputError(where, "'" + std::string(text) + "' for " + field.key + ", expected " + accepted(field));
    return value;
}

bool parse_bool(const std::string& where, const OptionField& field, std::string_view text) {
    if (text == "true" || text == "1" || text == "on") return true;
    if (text == "false" || text == "0" || text == "off") return false;
    throw InputError(where, "'" + std::string(text) + "' for " + field.key + ", expected " + accepted(field));
}

int parse_choice(const std::string& where, const OptionField& field, std::string_view text) {
    const auto names = std::get<Choice>(field.value).names;
    for (size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return int(i);
    throw InputError(where, "'" + std::string(text) + "' for " + field.key + ", expected " + accepted(field));
}

}  // namespace

std::vector<OptionField> option_fields(Options& o) {
    AccelOptions& a = o.accel;
    PhotonOptions& p = o.photons;
    MapOptions& m = o.maps;
    ProjectionOptions& j = o.projection;
    FilmOptions& f = o.film;
    return {
        {"type1", choice(o.type1, kLampNames), 0, 0, "light from lamps, straight through hair"},
        {"type2", choice(o.type2, kGatherNames), 0, 0,
         "light from polygons and the environment, straight through hair"},
        {"type3", choice(o.type3, kCrossingNames), 0, 0, "light from lamps, scattered once on its way"},
        {"type4", choice(o.type4, kScatteredNames), 0, 0, "light from lamps, scattered more than once on its way"},
        {"type5", choice(o.type5, kScatteredNames), 0, 0, "light from elsewhere, scattered on its way"},
        {"scattering", choice(o.scattering, kScatteringNames), 0, 0, "of types by path: full scatters TT by its lobe"},
        {"spp", &o.spp, 1, kMostSamples, "samples a pixel; with time, the most that are taken"},
        {"time", &o.time, 0, 1e9, "seconds of rendering after which no new pass starts; 0: no limit"},
        {"seed", &o.seed, 0, 0x1p64, "of all random numbers"},
        {"threads", &o.threads, 0, 4096, "0: as many as the machine has"},
        {"isa", choice(o.isa, kIsaNames), 0, 0, "instruction set; auto: the best that the machine has"},
        {"cutoff", &o.cutoff, 0, 0.1, "transmittance below which a ray counts as blocked"},
        {"accel.split", choice(a.split, kSplitNames), 0, 0, "how a cell is split"},
        {"accel.traversal_cost", &a.traversal_cost, 0, 1e6, "cost of a step, in tests of one segment"},
        {"accel.empty_bonus", &a.empty_bonus, 0, 0.99, "share taken off the cost where one side is empty"},
        {"accel.bins", &a.bins, 2, 256, "bins an axis (binned)"},
        {"accel.exact_below", &a.exact_below, 0, 4096, "references up to which a node is swept exactly (binned)"},
        {"accel.clip", &a.clip, 0, 0, "cut references to their cell"},
        {"accel.automatic", &a.automatic, 0, 0, "stop where no split is cheaper than a leaf"},
        {"accel.leaf_size", &a.leaf_size, 1, kMaxCount, "references a leaf may keep (automatic off)"},
        {"accel.depth_base", &a.depth_base, 0, 60, "depth limit: base + factor log2(n), at most 60"},
        {"accel.depth_factor", &a.depth_factor, 0, 10, "depth limit: base + factor log2(n), at most 60"},
        {"accel.failed_splits", &a.failed_splits, 0, 60, "splits dearer than a leaf allowed on a path"},
        {"accel.references", &a.references, 1, 100, "references a segment that all leaves together may hold"},
        {"photons.count", &p.count, 0, kMaxCount, "emitted, from all lights together"},
        {"photons.nearest", &p.nearest, 2, 65536, "photons that an estimate takes"},
        {"photons.radius", &p.radius, 0, 1e30, "largest of an estimate, scene units; 0: by the density of photons"},
        {"gather.rays", &o.gather.rays, 1, 1024, "a camera sample, for types 2 and 3"},
        {"gather.crossings", &o.gather.crossings, 0, 65536, "of a ray, shaded for type 3; 0: every one"},
        {"maps.resolution", &m.resolution, 1, 8192, "texels of the longer side of a lamp's view of the hair"},
        {"maps.grid", &m.grid, 1, 16, "a quad light has grid x grid shadow maps"},
        {"maps.near", &m.near, 0, 1e6,
         "texel widths next to what the eye sees traced exactly; 0: only next to hair of a quarter texel and more"},
        {"maps.near_crossings", &m.near_crossings, 0, 1e6, "the same next to crossings of gather rays (type 3)"},
        {"deep.error", &o.deep.error, 0, 0.5, "greatest error of transmittance by compression"},
        {"opacity.layers", &o.opacity.layers, 1, 1024, "of optical depth"},
        {"opacity.follow", &o.opacity.follow, 0, 0, "layers start at the first hair of each texel"},
        {"clusters.count", &o.clusters.count, 1, 64, "clusters of hair a texel"},
        {"projection.cells", &j.cells, 4, 16384, "a hemisphere, that hair is projected onto (type 2)"},
        {"projection.detail", choice(j.detail, kDetailNames), 0, 0,
         "what is projected: every segment, fewer, or a tree"},
        {"projection.directions", &j.directions, 1, 4096, "drawn a point by its scattering, seen through its cells"},
        {"projection.rays", &j.rays, 1, 4096, "a point of polygons, drawn by its scattering, to other polygons"},
        {"projection.probes", &j.probes, 0, 256,
         "cubes across the hair (a power of two; 0: 64, or 128 with far_field), whose corners see what is beyond"},
        {"projection.probe_cells", &j.probe_cells, 4, 4096, "a hemisphere of such a corner, a ray to polygons each"},
        {"projection.far_field", choice(j.far_field, kFarFieldNames), 0, 0,
         "hair that is not next to a point as seen from such a corner (tree)"},
        {"projection.near", &j.near, 0.01, 0.45, "share of a cell; wider hair is told apart by 64 samples of each"},
        {"projection.opening", &j.opening, 0.1, 16, "cells; larger cubes are opened (tree)"},
        {"projection.splats", &j.splats, 0.1, 16, "that stand for a cube as large as a cell (tree)"},
        {"projection.leaf", &j.leaf, 1, 4096, "pieces of hair that a cube may keep undivided (tree)"},
        {"projection.cube", &j.cube, 0, 1e30, "side of the smallest cube, scene units; 0: 1/256 of the hair (tree)"},
        {"projection.gap", &j.gap, -1, 8, "share of gaps between cells that is added; below 0: as rays show"},
        {"projection.scatter", &j.scatter, 0, 8, "share of their scatter that is taken off, where gap is given"},
        {"projection.share", &j.share, 1e-4, 1, "of strands that are kept (simplified)"},
        {"projection.stride", &j.stride, 1, 1024, "segments of a strand that become one (simplified)"},
        {"projection.layer", &j.layer, 1e-20, 1e30, "depth of a layer, scene units; the i-th keeps every i-th segment"},
        {"projection.measure", choice(j.measure, kMeasureNames), 0, 0, "what of a strand is in a layer (layers)"},
        {"projection.weighted", &j.weighted, 0, 0, "what is kept counts for what is left out (layers, simplified)"},
        {"film.filter_radius", &f.filter_radius, 0.5, 8, "pixels, of the Blackman-Harris filter"},
        {"film.exposure", &f.exposure, -40, 40, "stops, of the PNG only"},
    };
}

std::string options_text(Options options, std::initializer_list<std::string_view> without) {
    std::string text;
    for (const OptionField& field : option_fields(options))
        if (std::find(without.begin(), without.end(), field.key) == without.end())
            text += field.key + "=" + option_text(field) + "\n";
    return text;
}

std::string accepted(const OptionField& field) {
    if (std::holds_alternative<bool*>(field.value)) return "true or false";
    std::ostringstream text;
    if (const Choice* c = std::get_if<Choice>(&field.value)) {
        text << "one of";
        for (size_t i = 0; i < c->names.size(); ++i) text << (i ? ", " : " ") << c->names[i];
        return text.str();
    }
    const bool whole = std::holds_alternative<int*>(field.value) || std::holds_alternative<uint64_t*>(field.value);
    text << (whole ? "a whole number" : "a number") << " from " << shortest_text(field.lowest) << " to "
         << shortest_text(field.highest);
    return text.str();
}

void use_paths(Options& o) {
    o.type1 = LampMethod::path;
    o.type2 = GatherMethod::path;
    o.type3 = CrossingMethod::path;
    o.type4 = o.type5 = ScatteredMethod::path;
}

void switch_off(Options& o, PathType type) {
    switch (type) {
        case PathType::type1:
            o.type1 = LampMethod::off;
            break;
        case PathType::type2:
            o.type2 = GatherMethod::off;
            break;
        case PathType::type3:
            o.type3 = CrossingMethod::off;
            break;
        case PathType::type4:
            o.type4 = ScatteredMethod::off;
            break;
        case PathType::type5:
            o.type5 = ScatteredMethod::off;
            break;
    }
}

std::optional<MapKind> map_kind(LampMethod method) {
    switch (method) {
        case LampMethod::deep:
            return MapKind::deep;
        case LampMethod::opacity:
            return MapKind::opacity;
        case LampMethod::clusters:
            return MapKind::clusters;
        default:
            return {};
    }
}

std::optional<MapKind> map_kind(CrossingMethod method) {
    switch (method) {
        case CrossingMethod::ray_deep:
            return MapKind::deep;
        case CrossingMethod::ray_opacity:
            return MapKind::opacity;
        case CrossingMethod::ray_clusters:
            return MapKind::clusters;
        default:
            return {};
    }
}

std::string_view isa_name(Isa isa) { return kIsaNames[size_t(isa)]; }

std::string option_text(const OptionField& field) {
    return std::visit(
        [](auto value) -> std::string {
            using T = decltype(value);
            if constexpr (std::is_same_v<T, Choice>)
                return std::string(value.names[size_t(*value.value)]);
            else if constexpr (std::is_same_v<T, bool*>)
                return *value ? "true" : "false";
            else
                return shortest_text(*value);
        },
        field.value);
}

void set_option(Options& options, const std::string& where, std::string_view key, std::string_view text) {
    std::vector<std::string> keys;
    for (const OptionField& field : option_fields(options)) {
        if (field.key != key) {
            keys.push_back(field.key);
            continue;
        }
        std::visit(
            [&](auto value) {
                using T = decltype(value);
                if constexpr (std::is_same_v<T, Choice>)
                    *value.value = parse_choice(where, field, text);
                else if constexpr (std::is_same_v<T, bool*>)
                    *value = parse_bool(where, field, text);
                else
                    *value = parse_number<std::remove_pointer_t<T>>(where, field, text);
            },
            field.value);
        return;
    }
    throw InputError(where, "unknown option '" + std::string(key) + "', " + did_you_mean(key, keys));
}

}  // namespace tress
