"""Curves through points and round tubes along them."""
import math

from algebra import add, cross, dot, scaled, subtract, unit
from mesh import surface


def tube(path, radius, sides=12, closed=False, caps=3, tiles=(1, 1)):
    """Round tube along the points of `path`; open ends are closed by half spheres of `caps` rings."""
    rings = [(center, radius, axes) for center, axes in zip(path, carried_axes(path, closed))]
    if not closed and caps:
        rings = cap(rings[0], -1, caps) + rings + cap(rings[-1], 1, caps)
    elif closed:
        rings.append(rings[0])
    last = len(rings) - 1
    def point(u, v):
        center, r, (x, y) = rings[round(v * last)]
        angle = 2 * math.pi * (round(u * sides) % sides) / sides
        return add(center, add(scaled(x, r * math.cos(angle)), scaled(y, r * math.sin(angle))))
    return surface(point, sides, last, tiles)


def cap(ring, side, count):
    center, radius, axes = ring
    outwards = scaled(cross(*axes), side)
    rings = []
    for k in range(1, count + 1):
        angle = math.pi / 2 * k / count
        rings.append((add(center, scaled(outwards, radius * math.sin(angle))), radius * math.cos(angle) if k < count else 0.0, axes))
    return rings if side > 0 else rings[::-1]


def carried_axes(path, closed):
    """Two axes across the path at each point, carried along without spin; what a closed path has turned by its end is spread evenly."""
    count = len(path)
    tangents = []
    for i in range(count):
        before = path[i - 1] if closed or i > 0 else path[i]
        after = path[(i + 1) % count] if closed or i < count - 1 else path[i]
        tangents.append(unit(subtract(after, before)))
    x = unit(cross(tangents[0], (0, 1, 0) if abs(tangents[0][1]) < 0.9 else (1, 0, 0)))
    carried = []
    for tangent in tangents:
        x = unit(subtract(x, scaled(tangent, dot(x, tangent))))
        carried.append(x)
    turned = 0.0
    if closed:
        back = unit(subtract(x, scaled(tangents[0], dot(x, tangents[0]))))
        turned = math.atan2(dot(cross(carried[0], back), tangents[0]), dot(carried[0], back))
    axes = []
    for i, (x, tangent) in enumerate(zip(carried, tangents)):
        y = cross(tangent, x)
        angle = -turned * i / count
        x, y = add(scaled(x, math.cos(angle)), scaled(y, math.sin(angle))), subtract(scaled(y, math.cos(angle)), scaled(x, math.sin(angle)))
        axes.append((x, y))
    return axes


def spline(points, steps):
    """Catmull-Rom curve through the points, `steps` pieces between neighbours."""
    padded = [points[0], *points, points[-1]]
    curve = []
    for i in range(1, len(padded) - 2):
        a, b, c, d = padded[i - 1:i + 3]
        for k in range(steps):
            t = k / steps
            curve.append(tuple(q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)))
                               for p, q, r, s in zip(a, b, c, d)))
    return curve + [tuple(map(float, points[-1]))]
