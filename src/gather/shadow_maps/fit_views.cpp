// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/fit_views.h"

#include <algorithm>

#include "gather/shadow_maps/hair_window.h"

namespace tress {
namespace {

constexpr double kWidest =
    1.5;  // |x / z|, |y / z| of a single pinhole: in angle, texels at its border are a third as wide
constexpr double kSeenShare = 1.0 / 256;  // of all hair's diagonal: what one seen point stands for about itself
constexpr double kMargin = 0.04;          // about what is seen, of its longer side: seen points are but a sample
constexpr double kMarginTexels = 2;
constexpr double kHairMargin = 1.0 / 256;   // about all hair, of its longer side: keeps rounded points inside
constexpr double kSmallestTexel = 0x1p-50;  // of the coordinates that double has to tell apart

double longer(const ViewRectangle& r) { return glm::max(r.extent().x, r.extent().y); }

ViewRectangle with_margin(const ViewRectangle& r, double texel) {
    return grown(r, glm::max(kMargin * longer(r), kMarginTexels * texel));
}

LightView looking(const DVec3& from, const DVec3& along, bool parallel) {
    LightView view;
    view.origin = from;
    view.frame = frame_about(Vec3(along));
    view.parallel = parallel;
    return view;
}

/// Face `face` of a cube about the view's axes: z along one of them or against it. Each of the twelve edges is on the
/// low side of one of its two faces.
LightView cube_face(const LightView& view, int face) {
    const Vec3 axes[] = {view.frame.x, view.frame.y, view.frame.z};
    const int along = face / 2;
    const Vec3 &z = axes[along], &next = axes[(along + 1) % 3], &last = axes[(along + 2) % 3];
    LightView turned = view;
    turned.frame = face % 2 == 0 ? Frame{-last, next, z} : Frame{-next, last, -z};
    return turned;
}

/// What views of one point are fitted to.
struct Fitting {
    const SegmentView& segments;
    LitCone cone;
    std::vector<Vec3> points;  // seen and lit; empty: all hair is wanted
    double point_radius;
    DBounds bounds;  // of all hair
    int resolution;

    /// Where a pinhole looks.
    DVec3 middle_from(const DVec3& from) const {
        DBounds box;
        for (const Vec3& p : points) box.add(DVec3(p));
        const bool narrow = points.empty() && cone.cosine > 0;
        const DVec3 way = (points.empty() ? bounds.center() : box.center()) - from;
        return narrow || !(length(way) > 0) ? cone.axis : normalize(way);
    }

    bool any_lit() const {
        for (size_t s = 0; s < segments.size(); ++s) {
            const HairBall ball = ball_about(segments, s);
            if (cone.reaches(ball.center, ball.radius)) return true;
        }
        return false;
    }

    ViewHair ball(const LightView& view, const Vec3& at) const {
        const DVec3 p = to_local(view, DVec3(at));
        return {{p, p}, {point_radius, point_radius}};
    }

    /// What is wanted of a view without limits.
    ViewRectangle wanted_of(const LightView& view) const {
        const ViewRectangle lit = lit_part(view);
        if (points.empty()) {
            const HairWindow all{view, kEverywhere, lit, lit, lit};
            return find_hair({&all, 1}, cone, segments).found[0].hair;
        }
        ViewRectangle r;
        for (const Vec3& p : points) r.add(rectangle_of(ball(view, p), projection_of(view)));
        return cut(r, lit);
    }

    /// What is wanted of a pinhole within `limits`.
    ViewRectangle wanted_of(const LightView& view, const ViewRectangle& limits) const {
        if (points.empty()) return limits;
        ViewRectangle r;
        for (const Vec3& p : points)
            if (const auto part = clip(ball(view, p), limits, Projection::pinhole))
                r.add(cut(rectangle_of(*part, Projection::pinhole), limits));
        return r;
    }

    ViewRectangle lit_part(const LightView& view) const {
        if (view.parallel) return kEverywhere;
        return rectangle_of(cone, to_local(view, view.origin + cone.axis));
    }
};

/// Sets the view's texels so that they cover `r`; its longer side has `resolution`.
void set_texels(LightView& view, const ViewRectangle& r, int resolution) {
    const glm::dvec2 corner = glm::max(abs(r.low), abs(r.high));
    const double coordinates = glm::max(glm::max(corner.x, corner.y), view.parallel ? 0.0 : 1.0);
    const double smallest = glm::max(kSmallestTexel * coordinates, double(std::numeric_limits<float>::min()));
    const double texel = glm::max(longer(r) / resolution, smallest);
    const auto texels = [&](double side) { return int(glm::clamp(std::ceil(side / texel), 1.0, double(resolution))); };
    view.low = r.low;
    view.texel = glm::dvec2(texel);
    view.width = texels(r.extent().x);
    view.height = texels(r.extent().y);
}

void set_start(LightView& view, double nearest) { view.start = view.parallel ? nearest : glm::max(nearest, 0.0); }

/// One view of all that is seen, which fills `seen` of it.
LampViews one_view(const Fitting& f, const LightView& view, const ViewRectangle& seen) {
    HairWindow window{view, kEverywhere, f.lit_part(view), {}, {}};
    const double texel = longer(seen) / f.resolution;
    window.wanted = cut(with_margin(seen, texel), window.lit);
    window.reach = grown(window.wanted, longer(window.wanted) / f.resolution);
    const HairSearch search = find_hair({&window, 1}, f.cone, f.segments);
    LampViews fitted{{}, !search.left_out};
    const HairFound& found = search.found[0];
    if (found.hair.empty()) return fitted;
    LightView& result = fitted.views.emplace_back(view);
    set_texels(result, cut(grown(found.hair, kHairMargin * longer(found.hair)), window.wanted), f.resolution);
    set_start(result, found.nearest);
    return fitted;
}

/// Texel lines of a cube's face, which run from -1 to 1.
struct FaceLines {
    int resolution;
    double texel() const { return 2.0 / resolution; }

    ViewRectangle snapped(const ViewRectangle& r) const {
        const glm::dvec2 low = floor((r.low + 1.0) / texel()), high = ceil((r.high + 1.0) / texel());
        const glm::dvec2 first = clamp(low, 0.0, resolution - 1.0);
        return {at(first), at(clamp(high, first + 1.0, glm::dvec2(resolution)))};
    }
    /// Exactly -1 and 1 at the ends.
    glm::dvec2 at(const glm::dvec2& line) const { return (2.0 * line - double(resolution)) / double(resolution); }

    int count(double side) const { return int(std::lround(side / texel())); }
};

LampViews cube_views(const Fitting& f, const LightView& about) {
    const ViewRectangle whole_face{glm::dvec2(-1), glm::dvec2(1)};
    const FaceLines lines{f.resolution};
    std::vector<HairWindow> windows;
    for (int face = 0; face < 6; ++face) {
        HairWindow w{cube_face(about, face), whole_face, {}, {}, {}};
        w.lit = cut(f.lit_part(w.view), whole_face);
        if (!w.lit.empty()) w.wanted = f.wanted_of(w.view, w.lit);
        if (!w.wanted.empty()) w.wanted = lines.snapped(cut(with_margin(w.wanted, lines.texel()), w.lit));
        w.reach = w.wanted;
        windows.push_back(w);
    }
    const HairSearch search = find_hair(windows, f.cone, f.segments);
    LampViews fitted{{}, !search.left_out};
    for (size_t i = 0; i < windows.size(); ++i) {
        const HairFound& found = search.found[i];
        if (found.hair.empty()) continue;
        const ViewRectangle r = cut(lines.snapped(grown(found.hair, lines.texel())), windows[i].wanted);
        LightView& view = fitted.views.emplace_back(windows[i].view);
        view.low = r.low;
        view.texel = glm::dvec2(lines.texel());
        view.width = lines.count(r.extent().x);
        view.height = lines.count(r.extent().y);
        set_start(view, found.nearest);
    }
    return fitted;
}

Fitting make_fitting(const LitCone& cone, const SegmentView& segments, const SeenHair& seen, int resolution) {
    Fitting f{segments, cone, {}, 0, {DVec3(seen.bounds.lo), DVec3(seen.bounds.hi)}, resolution};
    f.point_radius = kSeenShare * length(f.bounds.extent());
    for (const Vec3& p : seen.points)
        if (cone.reaches(DVec3(p), 0)) f.points.push_back(p);
    return f;
}

LampViews fit_pinholes(const Light& light, const DVec3& point, const SegmentView& segments, const SeenHair& seen,
                       int resolution) {
    const std::optional<LitCone> cone = lit_cone(light, point);
    if (!cone) return {};
    const Fitting f = make_fitting(*cone, segments, seen, resolution);
    if (f.points.empty() && !seen.points.empty()) return {{}, !f.any_lit()};  // all that is seen is in the dark
    const LightView view = looking(point, f.middle_from(point), false);
    const ViewRectangle wanted = f.wanted_of(view);
    if (wanted.empty()) return {};
    const ViewRectangle widest{glm::dvec2(-kWidest), glm::dvec2(kWidest)};
    return widest.contains(wanted) ? one_view(f, view, wanted) : cube_views(f, view);
}

LampViews fit_beam(const DistantLight& light, const SegmentView& segments, const SeenHair& seen, int resolution) {
    if (!(length(light.direction) > 0)) return {};
    const Fitting f = make_fitting({}, segments, seen, resolution);
    const LightView view = looking(f.bounds.center(), normalize(light.direction), true);
    return one_view(f, view, f.wanted_of(view));
}

}  // namespace

LampViews fit_views(const Light& light, const DVec3& point, const SegmentView& segments, const SeenHair& seen,
                    int resolution) {
    if (segments.size() == 0 || std::holds_alternative<EnvironmentLight>(light)) return {};
    if (const auto* distant = std::get_if<DistantLight>(&light)) return fit_beam(*distant, segments, seen, resolution);
    return fit_pinholes(light, point, segments, seen, resolution);
}

}  // namespace tress
