// SPDX-License-Identifier: MIT
#include "core/hair_path.h"

#include "core/hair_noise.h"

namespace tress {
namespace {

constexpr Vec3 kDown(0, -1, 0);
constexpr Vec3 kWhorl(0.6f, 10.2f, -5.2f);               // where the hair of the crown turns about
constexpr float kWhorlRadius = 3;                        // within which it has no direction
constexpr float kPartingX = 2.6f;                        // of the parting, left of the middle
constexpr float kPartingEnd = -3.5f;                     // z at which the parting has faded
constexpr float kCombReach = 9;                          // cm of arc length over which combing fades
constexpr float kFallStart = 8;                          // cm of arc length over which the weight comes to bear
constexpr float kRelax = 1.6f;                           // cm over which a hair settles to its height above the head
constexpr float kRootRamp = 3.5f;                        // cm of arc length over which it rises to that height
constexpr float kLeastClearance = 0.05f;                 // cm
constexpr int kPushes = 4;                               // one is enough but near creases and deep inside
constexpr float kLowestRoot = -7, kHighestRoot = 10.5f;  // heights of the hair line at the nape and of the crown

Vec3 along_surface(const Vec3& v, const Vec3& normal) { return v - dot(v, normal) * normal; }

Vec3 unit_or(const Vec3& v, const Vec3& fallback) {
    const float length2 = dot(v, v);
    return length2 > 1e-12f ? v / std::sqrt(length2) : fallback;
}

/// The direction in which hair rooted at `root` is combed, in the plane of the scalp.
Vec3 combed(const GroomStyle& style, const Vec3& root, const Vec3& normal) {
    const Vec3 away = unit_or(along_surface(root - kWhorl, normal), kDown);
    if (style.combing == Combing::whorl) {
        const Vec3 sideways(0.45f * glm::smoothstep(0.0f, 6.0f, root.z), 0, 0);
        return unit_or(along_surface(away + 0.55f * cross(normal, away) + sideways, normal), kDown);
    }
    const float parted = parting_strength(style, root);
    const Vec3 aside(parting_side(style, root), 0, -0.95f);
    const float low = 1 - glm::smoothstep(1.0f, 7.0f, root.y);
    const Vec3 v = glm::mix(away + 0.25f * cross(normal, away), aside, parted);
    return unit_or(along_surface(glm::mix(v, Vec3(0, -1, -0.35f), low), normal), kDown);
}

/// Keeps hair off the face: a turn (1/cm) aside and back for what hangs before it.
Vec3 off_the_face(const Vec3& p, float side) {
    const float before = glm::smoothstep(2.0f, 6.0f, p.z);
    const float across = 1 - glm::smoothstep(5.5f, 8.5f, std::abs(p.x));
    const float below = 1 - glm::smoothstep(5.5f, 8.5f, p.y);
    const float above = glm::smoothstep(-14.0f, -9.0f, p.y);
    const float toward = std::abs(p.x) > 2 ? std::copysign(1.0f, p.x) : side;
    return before * across * below * above * Vec3(0.9f * toward, 0, -0.45f);
}

/// The height above the head at which a hair comes to lie: the higher its root, the more hair lies beneath it.
float resting_height(const GroomStyle& style, const Vec3& root, const HairCharacter& character, float s) {
    const float layer = 0.1f + 0.9f * character.layer + 0.3f * character.unruly;
    const float height = style.volume * layer * (0.4f + 0.6f * root_height(root));
    return kLeastClearance + height * glm::smoothstep(0.0f, kRootRamp, s);
}

}  // namespace

Vec3 HairPath::at(float s) const {
    const float t = glm::clamp(s / step, 0.0f, float(kNodes - 1));
    const int i = glm::min(int(t), kNodes - 2);
    return glm::mix(node[i], node[i + 1], t - float(i));
}

float root_height(const Vec3& root) { return glm::smoothstep(kLowestRoot, kHighestRoot, root.y); }

float longest_strand(const GroomStyle& style) { return 1.1f * glm::max(style.crown_length, style.nape_length); }

float parting_strength(const GroomStyle& style, const Vec3& root) {
    if (style.combing != Combing::parted) return 0;
    return glm::smoothstep(kPartingEnd, kPartingEnd + 5, root.z);
}

float parting_side(const GroomStyle& style, const Vec3& root) {
    const float x = style.combing == Combing::parted ? kPartingX : 0;
    return root.x < x ? -1.0f : 1.0f;
}

HairPath grow_path(const GroomStyle& style, const Scalp& scalp, const Vec3& root, const Vec3& normal,
                   const HairCharacter& character) {
    HairPath path;
    path.step = longest_strand(style) / float(HairPath::kNodes - 1);
    path.node[0] = root;
    const uint64_t noise = hash(character.key, 7);
    const float stray = 0.05f + 0.1f * character.unruly;
    const float weight = style.weight * (1 - 0.3f * character.unruly);
    const float side = parting_side(style, root);
    const float lift = glm::clamp(style.lift + 0.2f * signed_random(character.key, 3), 0.05f, 1.0f);
    const float unsure = 0.2f + 1.2f * glm::max(0.0f, 1 - distance(root, kWhorl) / kWhorlRadius);
    const Vec3 jitter(signed_random(character.key, 8), signed_random(character.key, 9),
                      signed_random(character.key, 10));
    const Vec3 comb = unit_or(along_surface(combed(style, root, normal) + unsure * jitter, normal), kDown);
    Vec3 p = root, direction = normalize(lift * normal + (1.05f - lift) * comb);
    for (int i = 1; i < HairPath::kNodes; ++i) {
        const float s = path.step * float(i);
        const GridValue head = interpolate(scalp.field, p);
        const Vec3 out = unit_or(head.gradient, normal);
        Vec3 turn = weight * glm::smoothstep(-3.0f, kFallStart, s) * kDown + off_the_face(p, side);
        turn += style.comb * glm::max(0.0f, 1 - s / kCombReach) * unit_or(along_surface(comb, out), comb);
        turn += stray * line_noise3(noise, 0.25f * s);
        direction = normalize(direction + path.step * turn);
        // Never nearer than the resting height, and slower the nearer.
        const float slowest = (resting_height(style, root, character, s) - head.value) / kRelax;
        const float leaving = dot(direction, out);
        if (leaving < slowest) direction = normalize(direction + (glm::min(slowest, 1.0f) - leaving) * out);
        p = push_out(scalp, p + path.step * direction, kLeastClearance * glm::min(1.0f, s));
        path.node[i] = p;
    }
    return path;
}

Vec3 push_out(const Scalp& scalp, const Vec3& p, float clearance) {
    Vec3 q = p;
    for (int step = 0; step < kPushes; ++step) {
        const GridValue head = interpolate(scalp.field, q);
        if (head.value >= clearance) break;
        q += (clearance - head.value) * unit_or(head.gradient, Vec3(0, 1, 0));
    }
    return q;
}

}  // namespace tress
