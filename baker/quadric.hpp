// The sum of squared distances to planes, weighted by their areas: what a vertex costs when it moves (Garland, Heckbert 1997).
#pragma once
#include "shaders/glsl.h"

namespace afterglow
{
using namespace shared;

struct Quadric {
    // q(p) = p^T A p + 2 b^T p + c, m4: A = sum area n n^T, b = sum area d n, c = sum area d^2 of the planes n^T p + d = 0
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    dvec3 b{0.0};
    double c = 0;
    double area = 0; // m2

    double operator()(const dvec3& p) const
    {
        dvec3 ap(xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z, xz * p.x + yz * p.y + zz * p.z);
        return max(dot(p, ap) + 2 * dot(b, p) + c, 0.0);
    }
};

inline Quadric operator+(const Quadric& q, const Quadric& r)
{
    return {q.xx + r.xx, q.xy + r.xy, q.xz + r.xz, q.yy + r.yy, q.yz + r.yz, q.zz + r.zz, q.b + r.b, q.c + r.c, q.area + r.area};
}

// Of a triangle's plane, weighted by its area; nothing when it has none.
inline Quadric triangleQuadric(const dvec3& p0, const dvec3& p1, const dvec3& p2)
{
    dvec3 n = cross(p1 - p0, p2 - p0);
    double twice = length(n), area = twice / 2;
    if (!(twice > 0.0)) return {};
    n /= twice;
    double d = -dot(n, p0);
    return {area * n.x * n.x, area * n.x * n.y, area * n.x * n.z,
            area * n.y * n.y, area * n.y * n.z, area * n.z * n.z,
            area * d * n,     area * d * d,     area};
}
}
