// Frames and directions: which way is up at a point, how a direction fits in two numbers, where a ray may start.
// Based on: Duff et al. 2017 (basis), Cigolle et al. 2014 (octahedral map), Waechter & Binder 2019 (ray offset).
#ifndef AFTERGLOW_FRAME_H
#define AFTERGLOW_FRAME_H
#include "shaders/constants.h"
SHARED_BEGIN

// Right-handed orthonormal frame; `normal` is local +z.
struct Frame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};

// Branchless, continuous everywhere but across z = 0 of the normal, accurate at both poles.
FN Frame makeFrame(vec3 normal)
{
    float s = normal.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (s + normal.z);
    float b = normal.x * normal.y * a;
    Frame f;
    f.tangent = vec3(1.0f + s * normal.x * normal.x * a, s * b, -s * normal.x);
    f.bitangent = vec3(b, s + normal.y * normal.y * a, -normal.y);
    f.normal = normal;
    return f;
}

FN vec3 toLocal(Frame f, vec3 v) { return vec3(dot(v, f.tangent), dot(v, f.bitangent), dot(v, f.normal)); }
FN vec3 toWorld(Frame f, vec3 v) { return f.tangent * v.x + f.bitangent * v.y + f.normal * v.z; }

// Divides by the largest component first, so that neither 1e-23 nor 1e20 loses its direction; the zero vector gives `fallback`.
FN vec3 safeNormalize(vec3 v, vec3 fallback)
{
    float m = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(m > 0.0f && m <= kFloatMax)) return fallback;
    return normalize(v / m);
}

// The mesh's tangent where it has a usable one, the canonical frame otherwise; handedness = tangent.w of the vertex.
FN Frame makeTangentFrame(vec3 normal, vec4 tangent)
{
    Frame f = makeFrame(normal);
    vec3 flat_ = vec3(tangent) - normal * dot(normal, vec3(tangent));
    f.tangent = safeNormalize(flat_, f.tangent);
    f.bitangent = cross(normal, f.tangent) * (tangent.w < 0.0f ? -1.0f : 1.0f);
    return f;
}

// The tangent turned about the normal of the mesh's front, counter-clockwise from tangent to bitangent (KHR_materials_anisotropy).
FN vec4 turnTangent(vec3 normal, vec4 tangent, float angle)
{
    Frame f = makeTangentFrame(normal, tangent);
    return vec4(f.tangent * cos(angle) + f.bitangent * sin(angle), tangent.w);
}

// A shading normal that the viewer can see: one that is tilted away from the viewer is bent back to just above the horizon.
FN vec3 visibleNormal(vec3 shading, vec3 geometric, vec3 viewer)
{
    const float kLeastCosine = 1e-3f;
    vec3 n = dot(shading, geometric) < 0.0f ? -shading : shading;
    float c = dot(n, viewer);
    return c >= kLeastCosine ? n : safeNormalize(n + viewer * (kLeastCosine - c), geometric);
}

// Direction away from the surface -> its mirror image about the normal, also away from the surface.
FN vec3 mirrorDirection(vec3 outward, vec3 normal) { return normal * (2.0f * dot(outward, normal)) - outward; }

// Octahedral map: unit vector <-> [0,1]^2. The pole +z is the centre, -z the four corners.
FN vec2 octahedralEncode(vec3 d)
{
    float sum = abs(d.x) + abs(d.y) + abs(d.z);
    vec2 p = sum > 0.0f ? vec2(d.x, d.y) / sum : vec2(0.0f, 0.0f);
    if (d.z < 0.0f) p = vec2((1.0f - abs(p.y)) * (p.x < 0.0f ? -1.0f : 1.0f), (1.0f - abs(p.x)) * (p.y < 0.0f ? -1.0f : 1.0f));
    return p * 0.5f + 0.5f;
}

FN vec3 octahedralDecode(vec2 uv)
{
    vec2 p = uv * 2.0f - 1.0f;
    float z = 1.0f - abs(p.x) - abs(p.y);
    float fold = max(-z, 0.0f); // Lower half: fold the corners back
    return normalize(vec3(p.x + (p.x >= 0.0f ? -fold : fold), p.y + (p.y >= 0.0f ? -fold : fold), z));
}

FN float offsetComponent(float p, float n)
{
    const float kOrigin = 1.0f / 32.0f;        // below it one ulp is too small to step by: a fixed distance instead
    const float kFloatScale = 1.0f / 65536.0f; // m, at the origin
    const float kIntScale = 256.0f;            // ulp
    if (!(abs(p) >= kOrigin && abs(p) + abs(n) <= kFloatMax)) return p + kFloatScale * n; // no integer holds what is not finite
    int steps = int(kIntScale * n);
    return intBitsToFloat(floatBitsToInt(p) + (p < 0.0f ? -steps : steps));
}

// Where a ray that leaves a surface at `p` starts, so that it never meets that surface again: 256 ulp along `n`, the geometric normal on
// the side that the ray leaves to.
FN vec3 offsetRay(vec3 p, vec3 n) { return vec3(offsetComponent(p.x, n.x), offsetComponent(p.y, n.y), offsetComponent(p.z, n.z)); }

// The same where the point itself, or what meets its surface, may be so many metres off: past them first.
FN vec3 leaving(vec3 p, float off, vec3 n) { return offsetRay(p + off * n, n); }

SHARED_END
#endif
