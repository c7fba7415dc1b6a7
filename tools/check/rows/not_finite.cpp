// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/load_scene.h"
#include "tools/check/rows/bad_segments.h"
#include "tools/check/support/bad_hair.h"
#include "tools/check/support/pictures.h"

namespace tress {
namespace {

using namespace test;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Hair whose every point has a radius and a colour.
HairFile colored_ball() {
    HairFile file;
    file.strands = ball_of_hair(100, 5, 1.2, 0.04f, Vec3(0), 5, white_fiber()).strands;
    StrandSet& s = file.strands;
    for (size_t p = 0; p < s.points(); ++p) {
        s.radius.push_back(0.03f + 0.02f * random(6, p));
        s.color.push_back(0.2f + 0.7f * Rgb(random(7, p), random(8, p), random(9, p)));
    }
    return file;
}

/// A point of six strands each, neither at their ends nor outermost.
std::vector<uint32_t> six_points(const StrandSet& strands) {
    std::vector<uint32_t> points;
    for (size_t strand = 3; points.size() < 6; strand += 10) points.push_back(strands.first[strand] + 2);
    return points;
}

/// NaN and infinity as coordinate, as radius and as colour.
void spoil(StrandSet& s, const std::vector<uint32_t>& points) {
    s.y[points[0]] = kNan;
    s.z[points[1]] = -kInfinity;
    s.radius[points[2]] = kNan;
    s.radius[points[3]] = kInfinity;
    s.color[points[4]].y = kNan;
    s.color[points[5]].z = kInfinity;
}

/// Without `points`, where strands are cut in two.
StrandSet without(const StrandSet& from, const std::vector<uint32_t>& points) {
    StrandSet to;
    to.first = {0};
    const auto end_strand = [&] {
        if (to.points() > to.first.back()) to.first.push_back(uint32_t(to.points()));
    };
    for (size_t strand = 0; strand < from.strands(); ++strand) {
        for (uint32_t p = from.first[strand]; p < from.first[strand + 1]; ++p) {
            if (std::find(points.begin(), points.end(), p) != points.end()) {
                end_strand();
                continue;
            }
            to.add_point(from.point(p));
            to.radius.push_back(from.radius[p]);
            to.color.push_back(from.color[p]);
        }
        end_strand();
    }
    return to;
}

/// The segments at `points` in another colour.
StrandSet painted(StrandSet strands, const std::vector<uint32_t>& points, const Rgb& color) {
    for (const uint32_t p : points) strands.color[p - 1] = strands.color[p] = color;
    return strands;
}

struct Loaded {
    uint64_t dropped;
    LayeredImage picture;
};
/// From a file, under lamps and a sky.
Loaded load_and_render(const StrandSet& strands, const Options& options) {
    const Folder folder;
    SceneDescription description = scene_of_file(strands, folder);
    description.camera = camera_on_z(8, 24, 48);
    description.lights = {PointLight{{1, 3, 4}, Rgb(12)}, DistantLight{{0.2, -0.5, -1}, Rgb(0.5f)}, EnvironmentLight{}};
    const LoadedScene loaded = load_scene(description);
    return {loaded.scene.segments.dropped, render(loaded.scene, options).picture};
}

/// One a pixel: whether any layer differs there.
std::vector<bool> pixels_that_differ(const LayeredImage& a, const LayeredImage& b) {
    std::vector<bool> differ(size_t(a.width) * size_t(a.height));
    for (size_t l = 0; l < a.layers.size(); ++l)
        for (size_t i = 0; i < a.layers[l].data.size(); ++i)
            if (a.layers[l].data[i] != b.layers[l].data[i]) differ[i / a.layers[l].channels.size()] = true;
    return differ;
}

/// Without light that is drawn among all segments of its way, so that what a segment does not light or shade knows
/// nothing of it.
Options without_drawn_light(Options options) {
    options.type3 = CrossingMethod::off;
    return options;
}

/// A tree of one leaf: another tree rounds other numbers.
Options with_one_leaf(Options options) {
    options.accel.depth_base = options.accel.depth_factor = 0;
    return options;
}

struct Away {
    size_t pixels = 0, wrong = 0;
    double largest = 0;  // difference, relative to the larger value
};
/// Pixels that show `spoilt` strands otherwise than intact ones though no light of theirs touches the segments at
/// `points`: there, black segments look as white ones do.
Away away_from(const std::vector<uint32_t>& points, const StrandSet& strands, const StrandSet& spoilt,
               const Options& options) {
    const auto picture = [&](const StrandSet& of) { return load_and_render(of, options).picture; };
    const LayeredImage a = picture(strands), b = picture(spoilt);
    const std::vector<bool> touched =
        pixels_that_differ(picture(painted(strands, points, Rgb(0.001f))), picture(painted(strands, points, Rgb(1))));
    const std::vector<bool> wrong = pixels_that_differ(a, b);
    Away away;
    for (size_t i = 0; i < touched.size(); ++i) {
        away.pixels += !touched[i];
        away.wrong += !touched[i] && wrong[i];
    }
    for (size_t l = 0; l < a.layers.size(); ++l) {
        const Layer &x = a.layers[l], &y = b.layers[l];
        for (size_t i = 0; i < x.data.size(); ++i)
            if (!touched[i / x.channels.size()] && x.data[i] != y.data[i])
                away.largest = std::max(away.largest, double(std::abs(x.data[i] - y.data[i])) /
                                                          double(std::max(std::abs(x.data[i]), std::abs(y.data[i]))));
    }
    return away;
}

void add_figures_away(const StrandSet& strands, const StrandSet& spoilt, const std::vector<uint32_t>& points,
                      const Options& options, std::vector<Figure>& to) {
    const Away same_tree = away_from(points, strands, spoilt, with_one_leaf(without_drawn_light(options)));
    const Away other_tree = away_from(points, strands, spoilt, without_drawn_light(options));
    to.push_back(exactly("pixels away from them that are not as in the intact scene, of " +
                             std::to_string(same_tree.pixels) + ", trees of one leaf",
                         double(same_tree.wrong), 0));
    to.push_back(told("the same where the tree has other leaves without them", double(other_tree.wrong)));
    to.push_back(told("largest relative difference there", other_tree.largest));
}

/// One point of a strand lies far outside, the other is NaN.
StrandSet with_stray(StrandSet strands) {
    const Vec3 points[] = {{-2.71f, 1.93f, 1.13f}, Vec3(kNan)};
    add_strand(strands, points, 2);
    strands.radius.resize(strands.points(), 0.04f);
    strands.color.resize(strands.points(), Rgb(0.5f));
    return strands;
}

}  // namespace

Outcome measure_not_finite(const CheckSettings& settings) {
    const StrandSet strands = colored_ball().strands;
    const std::vector<uint32_t> points = six_points(strands);
    StrandSet spoilt = strands;
    spoil(spoilt, points);
    const size_t expected = 2 * points.size();
    Options options;
    options.isa = settings.isa;
    options.spp = 4;
    const auto picture = [&](const StrandSet& of) { return load_and_render(of, options).picture; };
    const Loaded bad = load_and_render(spoilt, options);
    const CommandEnd end = render_file_of(spoilt);
    std::vector<Figure> figures{exactly("dropped, of " + std::to_string(segments(strands)) + " segments",
                                        double(bad.dropped), double(expected)),
                                exactly("values that are not finite, of " + std::to_string(values(bad.picture)),
                                        double(values_not_finite(bad.picture)), 0),
                                exactly("values whose bits differ from the scene without these segments",
                                        double(different_values(bad.picture, picture(without(strands, points)))), 0),
                                exactly("values that differ once a strand is added of a point far outside and a NaN",
                                        double(different_values(picture(strands), picture(with_stray(strands)))), 0),
                                exactly("exit code of tress render", end.exit_code, 0),
                                exactly("lines that say what was dropped",
                                        double(end.lines_with("dropped " + std::to_string(expected) + " ")), 1)};
    add_figures_away(strands, spoilt, points, options, figures);
    return {figures, {}};
}

}  // namespace tress
