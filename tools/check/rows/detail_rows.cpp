// SPDX-License-Identifier: MIT
// Levels of detail by layers of distance: layer i projects every i-th segment of a strand.
#include <algorithm>
#include <numeric>

#include "core/groom.h"
#include "tools/check/check_rows.h"
#include "tools/check/support/projected_hair.h"

namespace tress {
namespace {

using namespace test;

constexpr uint32_t kStrandSegments = 15;

struct StrandShape {
    float segment, bend, radius;
};

/// A strand of kStrandSegments from `root` on, about `along`.
void add_strand(const Vec3& root, Vec3 along, const StrandShape& shape, uint64_t key, StrandSet& to) {
    Vec3 place = root;
    to.add_point(place);
    for (uint64_t i = 0; i < kStrandSegments; ++i) {
        along = normalize(along + shape.bend * sample_uniform_sphere({random(key, 2 * i), random(key, 2 * i + 1)}));
        place += shape.segment * along;
        to.add_point(place);
    }
    to.first.push_back(uint32_t(to.points()));
}

/// Strands with their roots all round the origin, at a distance of 1.
StrandSet hair_all_round(uint64_t strands, const StrandShape& shape) {
    StrandSet hair;
    hair.constant_radius = shape.radius;
    hair.first = {0};
    for (uint64_t s = 0; s < strands; ++s) {
        const uint64_t key = hash(41, s);
        const Vec3 root = sample_uniform_sphere({random(key, 100), random(key, 101)});
        add_strand(root, sample_uniform_sphere({random(key, 102), random(key, 103)}), shape, key, hair);
    }
    return hair;
}

ProjectedHair in_layers(StrandSet strands, LayerMeasure measure) {
    Options options = without_gap();
    options.projection.measure = measure;
    return projected(std::move(strands), gray_fiber(), ProjectionDetail::layers, options);
}

struct CellMeans {
    double depth = 0, through = 0;  // over all cells
};

CellMeans means_at(const ProjectedHair& hair, const Viewpoint& from, Isa isa, ProjectionScratch& scratch) {
    CellLight light;
    project(hair.projection, hair.segments(), from, {}, isa, scratch);
    find_light(hair.projection, from, isa, scratch, light);
    CellMeans means;
    for (size_t cell = 0; cell < light.cells; ++cell) means.depth += summed(scratch, cell) / double(light.cells);
    means.through = mean_of(cells_of(light));
    return means;
}

/// Layers as thick as put distance 1 in the middle of layer i.
float thickness_for(int i) { return 1 / (float(i) - 0.5f); }

Outcome depth_of_layers(const CheckSettings& settings) {
    constexpr int kMostLayer = 64;
    constexpr uint64_t kStrands = 100'000;
    Outcome outcome;
    ProjectionScratch scratch;
    for (const LayerMeasure measure : {LayerMeasure::root, LayerMeasure::segment}) {
        ProjectedHair hair = in_layers(hair_all_round(kStrands, {0.02f, 0.2f, 8e-5f}), measure);
        const Viewpoint from{Vec3(0), random_frame(1), Dome::sphere, {}};
        double worst = 0;
        std::vector<CellMeans> layer;
        for (int i = 1; i <= kMostLayer; ++i) {
            hair.projection.options.layer = i == 1 ? 1e9f : thickness_for(i);
            layer.push_back(means_at(hair, from, settings.isa, scratch));
            worst = std::max(worst, std::abs(layer.back().depth / layer.front().depth - 1));
        }
        const std::string by = measure == LayerMeasure::root ? ", by roots" : ", by segments";
        outcome.figures.push_back(at_most("mean optical depth, worst of layers 1 to 64" + by, 100 * worst, 2, "%"));
        if (measure == LayerMeasure::root) outcome.figures.push_back(told("mean optical depth", layer.front().depth));
        for (const int i : {4, 16, kMostLayer})
            outcome.figures.push_back(told("bias of the mean of exp(-depth), layer " + std::to_string(i) + by,
                                           100 * (layer[size_t(i) - 1].through / layer.front().through - 1), "%"));
    }
    return outcome;
}

/// The chance that chi-square of an even number of degrees of freedom is as large or larger.
double chance_of(double chi_square, int freedom) {
    double term = 1, sum = 1;
    for (int k = 1; k < freedom / 2; ++k) sum += term *= chi_square / (2 * k);
    return std::exp(-0.5 * chi_square) * sum;
}

/// Of the places along the strand of the segments that layer i picks. Where i divides the strand, places of equal rest
/// by i are picked together, and are counted as one.
double chance_of_places(const StrandLayers& layers, const SegmentView& hair, LayerMeasure measure, int layer) {
    ProjectionOptions options;
    options.measure = measure;
    options.layer = thickness_for(layer);
    std::vector<ChosenSegment> chosen;
    choose_segments(layers, hair, options, Vec3(0), chosen);
    const int classes = std::min(layer, int(kStrandSegments));
    std::vector<double> count(size_t(classes), 0.0);
    const double each = double(kStrandSegments) / classes;  // picked of a strand together
    for (const ChosenSegment& c : chosen) count[c.segment % kStrandSegments % uint32_t(classes)] += 1 / each;
    const double expected = std::accumulate(count.begin(), count.end(), 0.0) / classes;
    double chi_square = 0;
    for (const double c : count) chi_square += square(c - expected) / expected;
    return chance_of(chi_square, classes - 1);
}

Outcome resonance(const CheckSettings&) {
    // So short that a whole strand is in the layer of its root.
    const StrandSet strands = hair_all_round(20'000, {2e-4f, 0.2f, 1e-5f});
    const SegmentList list = list_segments(strands);
    const SegmentView hair = view(strands, list);
    const StrandLayers layers = make_strand_layers(hair);
    Outcome outcome;
    for (const LayerMeasure measure : {LayerMeasure::root, LayerMeasure::segment})
        for (const int layer : {15, 3, 5, 30}) {
            const std::string by = measure == LayerMeasure::root ? ", by roots" : ", by segments";
            outcome.figures.push_back(at_least(
                "chance of the places that layer " + std::to_string(layer) + " picks, 15 segments a strand" + by,
                chance_of_places(layers, hair, measure, layer), 0.01));
        }
    return outcome;
}

/// Strands as on a head, in cm, that all start at one place and spread from it towards -z.
StrandSet tuft(uint64_t strands) {
    StrandSet hair;
    hair.constant_radius = 0.004f;
    hair.first = {0};
    for (uint64_t s = 0; s < strands; ++s) {
        const uint64_t key = hash(43, s);
        const Vec3 along = sample_uniform_sphere({0.7f + 0.3f * random(key, 100), random(key, 101)});
        add_strand(Vec3(0), along, {1, 0.3f, 0}, key, hair);
    }
    return hair;
}

/// Of a uniform sky through a hemisphere, over pi.
double irradiance(const ProjectedHair& hair, const Viewpoint& from, Isa isa) {
    const std::vector<Rgb> cells = seen_with(isa, hair, from);
    double sum = 0;
    for (uint32_t cell = 0; cell < cells.size(); ++cell)
        sum += double(cells[cell].x) * cosine_integral(hair.projection.igloo, cell) / double(kPi);
    return sum;
}

/// The greatest step as a point that faces the tuft moves by 1e-4 cm, so that all of it goes to the next layer.
double greatest_step_at_tuft(uint64_t strands, LayerMeasure measure, Isa isa) {
    const ProjectedHair hair = in_layers(tuft(strands), measure);
    double greatest = 0;
    for (int edge = 1; edge <= 16; ++edge) {
        const float distance = float(edge) * hair.projection.options.layer;
        const auto at = [&](float z) { return Viewpoint{{0, 0, z}, kUpright, Dome::hemisphere, {}}; };
        const double nearer = irradiance(hair, at(5e-5f - distance), isa);
        const double farther = irradiance(hair, at(-5e-5f - distance), isa);
        greatest = std::max(greatest, std::abs(farther / nearer - 1));
    }
    return greatest;
}

/// The greatest step as a point that faces a head of hair moves away from it, beyond that of the hair itself.
double greatest_step_at_head(LayerMeasure measure, Isa isa) {
    constexpr int kSteps = 100;
    ProjectedHair hair = in_layers(make_groom("straight", 100'000, 1), measure);
    const float layer = hair.projection.options.layer;
    const Bounds box = hair.projection.bounds;
    const Frame inwards = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    double greatest = 0, before = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const Vec3 at(box.center().x, box.center().y, box.hi.z + 0.02f * layer * float(i));
        const Viewpoint from{at, inwards, Dome::hemisphere, {}};
        hair.projection.options.layer = 1e9f;
        const double all = irradiance(hair, from, isa);
        hair.projection.options.layer = layer;
        const double off = irradiance(hair, from, isa) / all;
        if (i > 0) greatest = std::max(greatest, std::abs(off - before));
        before = off;
    }
    return greatest;
}

Outcome layer_edge(const CheckSettings& settings) {
    Outcome outcome;
    for (const LayerMeasure measure : {LayerMeasure::root, LayerMeasure::segment}) {
        const std::string by = measure == LayerMeasure::root ? ", by roots" : ", by segments";
        outcome.figures.push_back(
            at_most("step of irradiance at a head of 1e5 segments, 100 steps over two layers" + by,
                    100 * greatest_step_at_head(measure, settings.isa), 1, "%"));
        for (const uint64_t strands : {100u, 1000u, 10'000u})
            outcome.figures.push_back(at_most("likewise where all of a tuft of " + std::to_string(strands) +
                                                  " strands changes its layer, 16 edges" + by,
                                              100 * greatest_step_at_tuft(strands, measure, settings.isa), 1, "%"));
    }
    return outcome;
}

}  // namespace

std::vector<CheckRow> detail_rows() {
    return {{"D19", "every i-th segment, i from 1 to 64", "weighted by i, they keep the mean optical depth",
             depth_of_layers},
            {"D20", "i divides the segments of a strand", "every place along strands is picked alike", resonance},
            {"D21", "a point moves past the edge of a layer", "no step of irradiance", layer_edge}};
}

}  // namespace tress
