// How much of what a point sees is a given shape: solid angles, and irradiance of shapes of constant radiance.
// A form factor F is the irradiance of unit radiance over pi. Based on: Lambert 1760, Van Oosterom & Strackee 1983, Howell's catalogue.
#ifndef AFTERGLOW_FORMFACTOR_H
#define AFTERGLOW_FORMFACTOR_H
#include "shaders/frame.h"
SHARED_BEGIN

// Solid angle of a triangle, sr; a, b, c are offsets from the point. The determinant is taken from the edges, whose differences are exact
// where the triangle is small.
FN float triangleSolidAngle(vec3 a, vec3 b, vec3 c)
{
    float la = length(a), lb = length(b), lc = length(c);
    return abs(2.0f * atan(dot(a, cross(b - a, c - a)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb));
}

// One edge of Lambert's sum: the angle it subtends (by atan2: a short edge keeps its digits) times the normal of its plane, along n.
FN float lambertEdge(vec3 a, vec3 b, vec3 n)
{
    vec3 c = cross(a, b);
    float sine = length(c);
    return sine > 0.0f ? atan(sine, dot(a, b)) * dot(c, n) / sine : 0.0f;
}

// Irradiance at the origin about unit n of a triangle of unit radiance, cut at the horizon; vertices are offsets from the point.
FN float triangleIrradiance(vec3 a, vec3 b, vec3 c, vec3 n)
{
    float sum = 0.0f;
    vec3 previous = vec3(0.0f), first = vec3(0.0f);
    uint kept = 0u;
    for (int e = 0; e < 3; ++e) {
        vec3 p = e == 0 ? a : (e == 1 ? b : c);
        vec3 q = e == 0 ? b : (e == 1 ? c : a);
        float hp = dot(p, n), hq = dot(q, n);
        // Sutherland-Hodgman: keep p when above; keep the crossing where the edge meets the horizon
        for (int k = 0; k < 2; ++k) {
            bool crossing = (hp > 0.0f) != (hq > 0.0f);
            if (k == 0 ? !(hp > 0.0f) : !crossing) continue;
            vec3 v = k == 0 ? p : p + (q - p) * (hp / (hp - hq));
            if (kept > 0u)
                sum += lambertEdge(previous, v, n);
            else
                first = v;
            previous = v;
            kept += 1u;
        }
    }
    return kept > 2u ? 0.5f * abs(sum + lambertEdge(previous, first, n)) : 0.0f;
}

// Element facing a coaxial disc of radius r at height h.
FN float discFormFactor(float r, float h) { return r * r / (r * r + h * h); }

// Element and sphere: H = distance / radius > 1, cosB between the element's normal and the centre; any tilt, cut at the horizon.
FN float sphereFormFactor(float h, float cosB)
{
    float b = clamp(cosB, -1.0f, 1.0f);
    if (b * h >= 1.0f) return b / (h * h);
    if (b * h <= -1.0f) return 0.0f;
    float x = sqrt((h - 1.0f) * (h + 1.0f));
    float sinB = sqrt((1.0f - b) * (1.0f + b));
    float y = -x * b / sinB;
    float w = sinB * sqrt(max((1.0f - y) * (1.0f + y), 0.0f));
    return (b * acos(clamp(y, -1.0f, 1.0f)) - x * w) * kInvPi / (h * h) + atan(w, x) * kInvPi;
}

// Element and parallel rectangle a x b at height 1, opposite its corner.
FN float parallelRectangleFormFactor(float a, float b)
{
    float p = sqrt(1.0f + a * a), q = sqrt(1.0f + b * b);
    return (a / p * atan(b / p) + b / q * atan(a / q)) * kInvTwoPi;
}
// Element and perpendicular rectangle of height h and width w, its lower edge in the element's plane at distance d, opposite its corner.
FN float perpendicularRectangleFormFactor(float h, float w, float d)
{
    float x = h / w, y = d / w;
    float s = sqrt(x * x + y * y);
    return (atan(1.0f / y) - y / s * atan(1.0f / s)) * kInvTwoPi;
}

// Between two equal, directly opposed a x b rectangles at distance h (Howell C-11).
FN float opposedRectanglesFormFactor(float a, float b, float h)
{
    float x = a / h, y = b / h;
    float p = 1.0f + x * x, q = 1.0f + y * y;
    return 2.0f / (kPi * x * y) *
           (0.5f * log(p * q / (p + y * y)) + x * sqrt(q) * atan(x / sqrt(q)) + y * sqrt(p) * atan(y / sqrt(p)) - x * atan(x) -
            y * atan(y));
}
// From a rectangle w x l to a perpendicular h x l that shares its edge l (Howell C-14).
FN float adjacentRectanglesFormFactor(float w, float l, float h)
{
    float H = h / l, W = w / l;
    float h2 = H * H, w2 = W * W, s = sqrt(h2 + w2);
    float a = (1.0f + w2) * (1.0f + h2) / (1.0f + w2 + h2);
    float b = w2 * (1.0f + w2 + h2) / ((1.0f + w2) * (w2 + h2));
    float c = h2 * (1.0f + h2 + w2) / ((1.0f + h2) * (h2 + w2));
    return (W * atan(1.0f / W) + H * atan(1.0f / H) - s * atan(1.0f / s) + 0.25f * (log(a) + w2 * log(b) + h2 * log(c))) / (kPi * W);
}
// From disc r1 to coaxial disc r2 at distance h.
FN float coaxialDiscsFormFactor(float r1, float r2, float h)
{
    float x = 1.0f + (h * h + r2 * r2) / (r1 * r1);
    float q = 2.0f * r2 / r1;
    return 0.5f * q * q / (x + sqrt(max(x * x - q * q, 0.0f)));
}

SHARED_END
#endif
