// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/fit_views.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <string>

#include "core/hair_points.h"
#include "core/rng.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr float kRadius = 0.004f;
constexpr int kResolution = 256;

/// Hair with what fitting needs of it.
struct Hair {
    StrandSet strands;
    SegmentList list;

    explicit Hair(StrandSet from) : strands(std::move(from)), list(list_segments(strands)) {}
    SegmentView segments() const { return view(strands, list); }
    SeenHair all() const { return {bounds(segments()), {}}; }

    /// The eye far out on +z sees the half of the hair that is in front.
    SeenHair from_front() const {
        SeenHair seen = all();
        for (const Vec3& p : spread_points(segments(), 2000).position)
            if (p.z > seen.bounds.center().z) seen.points.push_back(p);
        return seen;
    }
};

/// Strands between `from` and `to`, which draw points from a key.
template <class From, class To>
StrandSet strands_between(int count, const From& from, const To& to) {
    StrandSet strands;
    strands.constant_radius = kRadius;
    strands.first = {0};
    for (int s = 0; s < count; ++s) {
        const uint64_t key = hash(7, uint64_t(s));
        strands.add_point(from(key));
        strands.add_point(to(key));
        strands.first.push_back(uint32_t(strands.points()));
    }
    return strands;
}

Vec3 on_sphere(uint64_t key) {
    const float z = 2 * random(key, 0) - 1, phi = 2 * kPi * random(key, 1), r = safe_sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Short strands that stand on the unit ball all round: its outline is a circle of 1.1.
StrandSet fur(int strands) {
    return strands_between(strands, on_sphere, [](uint64_t key) { return 1.1f * on_sphere(key); });
}

Hair tuft() { return Hair(ball_of_hair(300, 4, 1, kRadius, {0, 0, 0}, 1, white_fiber()).strands); }

struct Lamp {
    std::string name;
    Light light;
};

SpotLight spot(const DVec3& position, const DVec3& to, double angle) { return {position, to, angle, Rgb(1)}; }

/// A quad about a point, shining towards the origin.
QuadLight quad_at(const DVec3& at, double side) {
    const Frame f = frame_about(Vec3(normalize(-at)));
    const DVec3 x = side * DVec3(f.x), y = side * DVec3(f.y);
    return {at - 0.5 * (x + y), {x, y}, Rgb(1)};
}

/// Far and near, in and about hair of size 1, on every axis and off.
std::vector<Lamp> lamps(const SegmentView& hair) {
    std::vector<Lamp> lamps;
    for (const DVec3& way : {DVec3(0, 1, 0), DVec3(0, -1, 0), DVec3(0, 0, -1), DVec3(0, 0, 1), DVec3(1, 0, 0),
                             DVec3(-1, 0, 0), normalize(DVec3(1, 2, 3)), normalize(DVec3(-3, 1, -2))}) {
        for (const double far : {0.5, 1.2, 3.0, 100.0, 1e6, 1e8})
            lamps.push_back({"point " + std::to_string(far), PointLight{way * far}});
        for (const double far : {0.7, 3.0, 1e6})
            for (const double angle : {1e-3, 10.0, 90.0, 179.0})
                lamps.push_back({"spot " + std::to_string(far), spot(way * far, DVec3(0.1, 0.2, 0), angle)});
        for (const double far : {0.6, 2.0, 50.0})
            lamps.push_back({"quad " + std::to_string(far), quad_at(way * far, 0.5)});
        lamps.push_back({"distant", DistantLight{way * 3.0}});
        lamps.push_back({"distant", DistantLight{way + DVec3(1e-9)}});
    }
    lamps.push_back({"in the middle", PointLight{DVec3(0)}});
    for (const uint32_t s : {0u, 17u, 100u})
        if (s < hair.size()) lamps.push_back({"at a hair point", PointLight{DVec3(hair.start(s))}});
    return lamps;
}

/// Written from what lamps are, apart from how views are fitted.
bool is_lit(const Light& light, const DVec3& point, const Vec3& p) {
    if (const auto* s = std::get_if<SpotLight>(&light)) {
        const DVec3 v = DVec3(p) - s->position, axis = s->to - s->position;
        return dot(v, axis) > std::cos(0.5 * glm::radians(s->angle)) * length(v) * length(axis);
    }
    if (const auto* q = std::get_if<QuadLight>(&light)) return dot(DVec3(p) - point, cross(q->edge[0], q->edge[1])) > 0;
    return true;
}

int containing(const LampViews& fitted, const Vec3& p) {
    return int(std::count_if(fitted.views.begin(), fitted.views.end(),
                             [&](const LightView& view) { return contains(view, project(view, p)); }));
}

void check_valid(const LampViews& fitted, int resolution) {
    CHECK(fitted.views.size() <= 6);
    for (const LightView& view : fitted.views) {
        for (const int side : {view.width, view.height}) {
            CHECK(side >= 1);
            CHECK(side <= resolution);
        }
        CHECK(view.texel.x > 0);
        CHECK(std::isfinite(view.texel.x));
        CHECK(view.texel.x == view.texel.y);
        CHECK(std::isfinite(view.low.x + view.low.y));
        CHECK(std::isfinite(view.start));
        if (!view.parallel) CHECK(view.start >= 0);
        CHECK(is_finite(view.frame.x + view.frame.y + view.frame.z));
        // Texels that double tells apart: from a far lamp they are small beside the coordinates.
        CHECK(view.low.x + view.texel.x > view.low.x);
        CHECK(view.low.y + view.texel.y > view.low.y);
    }
}

/// Points of a fiber's surface, at its ends and between.
std::vector<Vec3> surface_points(const SegmentView& hair) {
    std::vector<Vec3> points;
    for (uint32_t s = 0; s < hair.size(); ++s)
        for (const float u : {0.0f, 0.37f, 1.0f}) {
            const Vec3 across = on_sphere(hash(11, s));
            points.push_back(glm::mix(hair.start(s), hair.end(s), u) +
                             glm::mix(hair.start_radius(s), hair.end_radius(s), u) * across);
        }
    return points;
}

/// What holds for every lamp and all hair.
void check_fit(const Hair& hair, const SeenHair& seen, int resolution) {
    const SegmentView segments = hair.segments();
    const std::vector<Vec3> surface = surface_points(segments);
    for (const Lamp& lamp : lamps(segments)) {
        for (const DVec3& point : view_points(lamp.light, 2)) {
            CAPTURE(lamp.name);
            CAPTURE(point.x);
            CAPTURE(point.y);
            CAPTURE(point.z);
            const LampViews fitted = fit_views(lamp.light, point, segments, seen, resolution);
            check_valid(fitted, resolution);
            // Of points at the very lamp, or at a spot's or quad's rim, either answer will do.
            const auto counts = [&](const Vec3& p) {
                return distance(DVec3(p), point) > 2 * double(kRadius) && is_lit(lamp.light, point, p);
            };
            int seen_lost = 0, lost = 0, twice = 0, before = 0;
            for (const Vec3& p : seen.points) {
                const int n = counts(p) ? containing(fitted, p) : 1;
                seen_lost += n == 0, twice += n > 1;
            }
            for (const Vec3& p : surface) {
                const int n = containing(fitted, p);
                lost += n == 0 && counts(p), twice += n > 1;
                for (const LightView& view : fitted.views) {
                    const ViewPoint at = project(view, p);
                    before += contains(view, at) && double(at.depth) < -1e-7 * (1 + length(point));
                }
            }
            CHECK(seen_lost == 0);
            CHECK(twice == 0);
            CHECK(before == 0);
            if (fitted.complete) CHECK(lost == 0);
            if (seen.points.empty()) CHECK(fitted.complete);
        }
    }
}

LampViews fit(const Light& light, const Hair& hair, const SeenHair& seen, int resolution = kResolution) {
    return fit_views(light, view_points(light, 1)[0], hair.segments(), seen, resolution);
}

}  // namespace

TEST_CASE("what is seen of the hair lies in one view, and so does all hair that is not said to be left out") {
    const Hair hair = tuft();
    check_fit(hair, hair.from_front(), kResolution);
    check_fit(hair, hair.all(), kResolution);
}

TEST_CASE("hair of no extent has views as well, at any resolution") {
    const auto origin = [](uint64_t) { return Vec3(0); };
    const auto short_of = [](const Vec3& by) { return [=](uint64_t key) { return (0.01f + random(key, 2)) * by; }; };
    const auto in_plane = [](uint64_t key) { return Vec3(random(key, 0), 0, random(key, 1)); };
    const Hair cases[] = {
        Hair(strands_between(1, origin, short_of({0, 1, 0}))),                                      // one
        Hair(strands_between(40, origin, short_of({0, 1e-6f, 0}))),                                 // at one point
        Hair(strands_between(40, origin, short_of({1, 0, 0}))),                                     // in a line
        Hair(strands_between(40, in_plane, [&](uint64_t key) { return in_plane(hash(key, 1)); })),  // in a plane
    };
    for (const Hair& hair : cases) {
        for (const int resolution : {1, 2, 3, 64}) {
            CAPTURE(&hair - cases);
            CAPTURE(resolution);
            check_fit(hair, hair.all(), resolution);
            SeenHair one = hair.all();
            if (hair.segments().size() == 0) continue;
            one.points = {hair.segments().start(0)};
            check_fit(hair, one, resolution);
        }
    }
}

TEST_CASE("hair of no thickness has views as well") {
    Hair hair(strands_between(
        3, [](uint64_t) { return Vec3(0); }, [](uint64_t) { return Vec3(0, 1, 0); }));
    SegmentView segments = hair.segments();
    segments.constant_radius = 0;
    for (const Lamp& lamp : lamps(segments)) {
        CAPTURE(lamp.name);
        const SeenHair seen{bounds(segments), {}};
        check_valid(fit_views(lamp.light, view_points(lamp.light, 1)[0], segments, seen, 64), 64);
    }
}

TEST_CASE("the longer side of a single view has all texels") {
    const Hair hair = tuft();
    for (const SeenHair& seen : {hair.all(), hair.from_front()}) {
        for (const double far : {3.0, 100.0, 1e6, 1e8}) {
            for (const Light& light : {Light(PointLight{{far, 2 * far, -far}}), Light(DistantLight{{far, 1, 1}})}) {
                const LampViews fitted = fit(light, hair, seen);
                CAPTURE(far);
                REQUIRE(fitted.views.size() == 1);
                CHECK(std::max(fitted.views[0].width, fitted.views[0].height) == kResolution);
            }
        }
    }
}

TEST_CASE("a view of all hair fits it to within its margin") {
    // The outline of a ball of 1.1 and a fiber's radius: as a tangent from a pinhole at distance d, and from afar.
    const Hair hair(fur(3000));
    for (const double far : {2.0, 5.0, 1e6}) {
        const LampViews fitted = fit(PointLight{{0, 0, far}}, hair, hair.all());
        REQUIRE(fitted.views.size() == 1);
        const LightView& view = fitted.views[0];
        const double outline = 1.1 + double(kRadius), tangent = outline / std::sqrt(far * far - outline * outline);
        CAPTURE(far);
        // 3000 strands leave no gap of more than 0.1 radians at the outline's four outermost places (a cap of that
        // size holds 7.5 of them), where it bends away by 0.5 %; the margin adds 1/128 of the side.
        CHECK(view.texel.x * view.width <= 2 * tangent * (1 + 1.0 / 128) * (1 + 1e-9));
        CHECK(view.texel.x * view.width >= 2 * tangent * 0.99);
        CHECK(view.start == doctest::Approx(far - outline).epsilon(0.01 / far));
    }
}

TEST_CASE("turning hair and lamp together changes the size of texels little") {
    const StrandSet straight = fur(3000);
    const auto texel = [](const StrandSet& strands, const DVec3& lamp) {
        const Hair hair(strands);
        const LampViews fitted = fit(PointLight{lamp}, hair, hair.all());
        REQUIRE(fitted.views.size() == 1);
        return fitted.views[0].texel.x;
    };
    const double expected = texel(straight, {0, 0, 3});
    for (uint64_t key = 0; key < 30; ++key) {
        const Frame f = frame_about(on_sphere(key));
        StrandSet turned = straight;
        for (size_t p = 0; p < turned.points(); ++p) {
            const Vec3 at = f.to_world(straight.point(uint32_t(p)));
            turned.x[p] = at.x, turned.y[p] = at.y, turned.z[p] = at.z;
        }
        CAPTURE(key);
        // Its outline is round to within 0.5 % (above), at either end, and so is the middle of its box.
        CHECK(texel(turned, 3.0 * DVec3(f.z)) == doctest::Approx(expected).epsilon(0.02));
    }
}

TEST_CASE("a pinhole sees less of the hair, but for a margin, when less of it is seen by the eye") {
    const Hair hair = tuft();
    SeenHair seen = hair.all();
    for (const Vec3& p : spread_points(hair.segments(), 20000).position)
        if (glm::length(p) < 0.3f) seen.points.push_back(p);
    const PointLight light{{3, 3, 3}};
    const LampViews part = fit(light, hair, seen), whole = fit(light, hair, hair.all());
    REQUIRE(part.views.size() == 1);
    REQUIRE(whole.views.size() == 1);
    const LightView& view = part.views[0];
    CHECK(!part.complete);
    CHECK(view.texel.x < 0.5 * whole.views[0].texel.x);
    constexpr float margin = 0.03f * kResolution;
    for (const Vec3& p : seen.points) {
        const ViewPoint at = project(view, p);
        CHECK(std::min(at.x, at.y) >= margin);
        CHECK(at.x <= float(view.width) - margin);
        CHECK(at.y <= float(view.height) - margin);
    }
}

TEST_CASE("hair behind a lone pinhole is said to be left out") {
    const auto at = [](float x) { return [=](uint64_t key) { return Vec3(x, 0, key == hash(7, 0) ? 3 : -3); }; };
    const Hair hair(strands_between(2, at(0), at(0.5f)));  // one before it, one behind
    SeenHair seen = hair.all();
    seen.points = {{0, 0, 3}, {0.5f, 0, 3}};
    const LampViews fitted = fit(PointLight{}, hair, seen);
    CHECK(fitted.views.size() == 1);
    CHECK(!fitted.complete);
    CHECK(fit(spot({0, 0, 0}, {0, 0, 1}, 90), hair, seen).complete);  // it is dark behind a spot
}

TEST_CASE("the very edge of a hair lies in its view, rounded as it may be") {
    for (uint64_t key = 0; key < 1000; ++key) {
        const Vec3 a = on_sphere(hash(key, 0)), b = on_sphere(hash(key, 1)), way = on_sphere(hash(key, 2));
        StrandSet strand;
        strand.constant_radius = kRadius;
        strand.first = {0, 2};
        strand.add_point(a);
        strand.add_point(b);
        const Hair hair(strand);
        const Vec3 across = kRadius * normalize(cross(b - a, way));
        for (const Light& light : {Light(DistantLight{DVec3(way), Rgb(1)}), Light(PointLight{-1e6 * DVec3(way)})}) {
            const LampViews fitted = fit(light, hair, hair.all(), 2);
            CAPTURE(key);
            for (const Vec3& p : {a + across, a - across, b + across, b - across}) CHECK(containing(fitted, p) == 1);
            for (const LightView& view : fitted.views)
                for (const Vec3& side : {view.frame.x, view.frame.y})
                    for (const float r : {-kRadius, kRadius}) CHECK(containing(fitted, a + r * side) == 1);
        }
    }
}

TEST_CASE("hair in the dark needs no view") {
    const Hair hair = tuft();
    QuadLight away = quad_at({0, 5, 0}, 1);
    std::swap(away.edge[0], away.edge[1]);
    const QuadLight no_area{{0, 5, 0}, {{1, 0, 0}, {2, 0, 0}}, Rgb(1)};
    for (const SeenHair& seen : {hair.all(), hair.from_front()}) {
        for (const Light& light :
             {Light(away), Light(no_area), Light(spot({0, 5, 0}, {0, 9, 0}, 20)), Light(spot({0, 5, 0}, {5, 5, 0}, 60)),
              Light(EnvironmentLight{}), Light(DistantLight{DVec3(0), Rgb(1)})}) {
            const LampViews fitted = fit(light, hair, seen);
            CHECK(fitted.views.empty());
            CHECK(fitted.complete);
        }
    }
    CHECK(fit(PointLight{{0, 5, 0}}, Hair(StrandSet{}), SeenHair{}).views.empty());
}

TEST_CASE("a spot's view is no wider than its cone") {
    const Hair hair = tuft();
    const LampViews fitted = fit(spot({0, 4, 0}, {0, 0, 0}, 10), hair, hair.all());
    REQUIRE(fitted.views.size() == 1);
    const LightView& view = fitted.views[0];
    CHECK(view.texel.x * view.width <= 2 * std::tan(glm::radians(5.0)) * (1 + 1e-6));  // axes rounded to float
    CHECK(fitted.complete);
}

TEST_CASE("a lamp amid hair sees it through six faces, and each direction through one of them") {
    const Hair hair(fur(3000));
    SeenHair seen = hair.all();
    seen.bounds = {Vec3(-1.2f), Vec3(1.2f)};  // so that the faces lie along the axes
    const LampViews fitted = fit(PointLight{}, hair, seen);
    REQUIRE(fitted.views.size() == 6);
    CHECK(fitted.complete);
    for (const LightView& view : fitted.views) {
        CHECK(view.width == kResolution);
        CHECK(view.height == kResolution);
        CHECK(distance(cross(view.frame.x, view.frame.y), view.frame.z) == 0);
    }
    for (uint64_t key = 0; key < 10000; ++key) REQUIRE(containing(fitted, on_sphere(key)) == 1);
    const auto signs = {-1.0f, 1.0f};
    for (const float a : signs) {
        for (const float b : signs) {
            for (const float c : {-0.9f, 0.0f, 0.5f})  // along the edges
                for (const Vec3& p : {Vec3(a, b, c), Vec3(b, c, a), Vec3(c, a, b)}) CHECK(containing(fitted, p) == 1);
            for (const float c : signs) CHECK(containing(fitted, {a, b, c}) == (a == b && b == c ? 0 : 1));
        }
    }
}

TEST_CASE("faces of a cube that see no hair are left out") {
    // A curtain right before the lamp, too wide for one view, and all on one side.
    const auto from = [](uint64_t key) { return Vec3(10 * random(key, 0) - 5, -5, -1); };
    const auto to = [](uint64_t key) { return Vec3(10 * random(key, 0) - 5, 5, -1); };
    const Hair hair(strands_between(200, from, to));
    const LampViews fitted = fit(PointLight{}, hair, hair.all());
    CHECK(fitted.views.size() == 5);
    CHECK(fitted.complete);
    for (const LightView& view : fitted.views) CHECK(view.texel.x == 2.0 / kResolution);
}
