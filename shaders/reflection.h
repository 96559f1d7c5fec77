// Reflection probes: cubemaps whose mips hold radiance blurred by GGX of growing roughness, seen through a box (parallax corrected).
#ifndef AFTERGLOW_REFLECTION_H
#define AFTERGLOW_REFLECTION_H
#include "shaders/formfactor.h"
SHARED_BEGIN

// Screen-space reflection serves surfaces smoother than this; of a rougher one the probes' blur tells as much.
const float kScreenRoughness = 0.35f;

// Probes are placed for metals and for dielectrics up to this roughness; where there are none of them, others mirror their irradiance.
const float kGlossyRoughness = 0.5f;

// Mip <-> perceptual roughness (alpha = roughness^2), linear: mip 0 is the mirror, the last mip is roughness 1.
FN float reflectionRoughness(float mip, float mipCount) { return mipCount > 1.0f ? clamp(mip / (mipCount - 1.0f), 0.0f, 1.0f) : 0.0f; }
FN float reflectionMip(float roughness, float mipCount) { return clamp(roughness, 0.0f, 1.0f) * max(mipCount - 1.0f, 0.0f); }

// Where a lobe looks as a whole: half of a rough one's facets would send light from below the surface, so that it leans from the mirror
// direction to the normal (Lagarde & de Rousiers 2014, "Moving Frostbite to PBR"). Probes are looked up there. All unit, away from the
// surface.
FN vec3 lobeAxis(vec3 mirror, vec3 normal, float roughness)
{
    float r = clamp(roughness, 0.0f, 1.0f), alpha = r * r, smoothness = 1.0f - alpha;
    return normalize(mix(normal, mirror, smoothness * (sqrt(smoothness) + alpha)));
}

// Direction through a point of a cube face, not normalised; faces in the order +x -x +y -y +z -z, uv in [0,1]^2 from the top left of the
// face's image, as Vulkan and KTX lay them out.
FN vec3 cubeDirection(int face, vec2 uv)
{
    float s = 2.0f * uv.x - 1.0f, t = 2.0f * uv.y - 1.0f;
    if (face == 0) return vec3(1.0f, -t, -s);
    if (face == 1) return vec3(-1.0f, -t, s);
    if (face == 2) return vec3(s, 1.0f, t);
    if (face == 3) return vec3(s, -1.0f, -t);
    if (face == 4) return vec3(s, -t, 1.0f);
    return vec3(-s, -t, -1.0f);
}

// The inverse: xy = uv, z = face.
FN vec3 cubeFace(vec3 d)
{
    vec3 a = vec3(abs(d.x), abs(d.y), abs(d.z));
    float face, s, t, m;
    if (a.x >= a.y && a.x >= a.z) {
        m = a.x;
        face = d.x > 0.0f ? 0.0f : 1.0f;
        s = d.x > 0.0f ? -d.z : d.z;
        t = -d.y;
    } else if (a.y >= a.z) {
        m = a.y;
        face = d.y > 0.0f ? 2.0f : 3.0f;
        s = d.x;
        t = d.y > 0.0f ? d.z : -d.z;
    } else {
        m = a.z;
        face = d.z > 0.0f ? 4.0f : 5.0f;
        s = d.z > 0.0f ? d.x : -d.x;
        t = -d.y;
    }
    return vec3(0.5f + 0.5f * s / m, 0.5f + 0.5f * t / m, face);
}

// Solid angle of the texel (i, j) of a face with n x n texels; all 6 n^2 sum to 4 pi. Two triangles: differences of areas up to the corner
// would lose a fifth of a texel at n = 1024.
FN float cubeTexelSolidAngle(int i, int j, int n)
{
    float x0 = 2.0f * float(i) / float(n) - 1.0f, x1 = 2.0f * float(i + 1) / float(n) - 1.0f;
    float y0 = 2.0f * float(j) / float(n) - 1.0f, y1 = 2.0f * float(j + 1) / float(n) - 1.0f;
    vec3 a = vec3(x0, y0, 1.0f), b = vec3(x1, y1, 1.0f);
    return triangleSolidAngle(a, vec3(x1, y0, 1.0f), b) + triangleSolidAngle(a, b, vec3(x0, y1, 1.0f));
}

// Distance along d at which a ray from p leaves the box; axes along which it does not move are skipped; never negative.
FN float boxExit(vec3 p, vec3 d, vec3 lower, vec3 upper)
{
    float t = kFloatMax;
    for (int a = 0; a < 3; ++a)
        if (d[a] != 0.0f) t = min(t, ((d[a] > 0.0f ? upper[a] : lower[a]) - p[a]) / d[a]);
    return t < kFloatMax ? max(t, 0.0f) : 0.0f;
}

// Where the probe must be looked up so that its image lies on the walls of the box: direction from the probe to the ray's exit. Outside
// the box, or in an inverted one, the plain direction.
FN vec3 boxParallax(vec3 p, vec3 d, vec3 lower, vec3 upper, vec3 probe)
{
    if (!(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z)) return d;
    vec3 toward = p + d * boxExit(p, d, lower, upper) - probe;
    float l = length(toward);
    return l > 0.0f ? toward / l : d;
}

// Share of a box at a point of its unit space [-1/2, 1/2]^3: 1 inside, 0 outside, and a short ramp between beyond its walls.
FN float boxShare(vec3 unitPosition, vec3 ramp)
{
    vec3 inside = clamp((0.5f + ramp - abs(unitPosition)) / ramp, 0.0f, 1.0f);
    return inside.x * inside.y * inside.z;
}

// The proxy of a reflection probe.
struct ReflectionBox {
    vec3 position; // of the probe, m
    float mips;
    vec3 lower; // m
    vec3 upper;
};

// What a box has to say at a point. x: its share, 1 within, that fades over a tenth of its extent beyond its walls. y: its weight among
// boxes, (share / d)^4: the nearest probe has the say, for a farther one may stand behind a wall, where it sees another world. Both are
// continuous, a weight is 0 where its share is, and by the power a near probe fades in over most of its ramp, not at its very beginning.
FN vec2 reflectionInfluence(IN(ReflectionBox) box, vec3 position)
{
    const float kNearest = 1e-4f; // m^4: a tenth of a metre, nearer than which no probe gains
    vec3 extent = max(box.upper - box.lower, vec3(1e-6f));
    float share = boxShare((position - box.lower) / extent - 0.5f, vec3(0.1f));
    vec3 apart = position - box.position;
    float power = share * share * share * share;
    return vec2(share, power / (kNearest + dot(apart, apart) * dot(apart, apart)));
}

// Where the probe is looked up for what a point mirrors from d. A point beyond a wall stretches the box to itself: what it mirrors is then
// continuous across the wall.
FN vec3 reflectionDirection(IN(ReflectionBox) box, vec3 position, vec3 d)
{
    return boxParallax(position, d, min(box.lower, position), max(box.upper, position), box.position);
}

SHARED_END
#endif
