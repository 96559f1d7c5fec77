"""Solids and sheets: quad, box, rounded box, lathe, sphere, cylinder, torus, icosphere."""
import math

from algebra import add, length, mix, scaled, unit
from mesh import Shape, joined, moved, surface


def quad(corner, along, up, tile=1.0, pieces=(1, 1)):
    """Flat rectangle from `corner`; its outside is along x up. `tile`: metres of one texture repeat, uvs start at the corner."""
    def point(u, v):
        return add(corner, add(scaled(along, u), scaled(up, v)))
    return surface(point, *pieces, tiles=(length(along) / tile, length(up) / tile))


def box(lower, upper, tile=1.0):
    """Six faces, textured by world position so that neighbouring boxes continue each other's pattern."""
    return rounded_box(lower, upper, 0.0, 0, tile)


def rounded_box(lower, upper, radius, steps=2, tile=1.0):
    """Box whose edges and corners are rounded with `steps` segments: a point of the sharp box, drawn to its inner box and pushed out."""
    inner = [(low + radius, high - radius) for low, high in zip(lower, upper)]
    whole = Shape()
    for axis in range(3):
        for side in (0, 1):
            whole = joined(whole, box_side(inner, axis, side, radius, steps, tile))
    return whole


def box_side(inner, axis, side, radius, steps, tile):
    along, across = ((1, 2), (2, 0), (0, 1))[axis]
    if side == 0:
        along, across = across, along
    half = [math.tan(math.pi / 4 * k / steps) for k in range(1, steps + 1)] if steps else []
    shape = Shape()
    stops = [(0, -h) for h in reversed(half)] + [(0, 0.0), (1, 0.0)] + [(1, h) for h in half]  # (edge of the inner box, offset)
    for q, dq in stops:
        for p, dp in stops:
            at, out = [0.0] * 3, [0.0] * 3
            at[axis], out[axis] = inner[axis][side], 1.0 if side else -1.0
            at[along], out[along] = inner[along][p], dp
            at[across], out[across] = inner[across][q], dq
            normal = unit(out)
            position = add(at, scaled(normal, radius))
            shape.positions.append(position)
            shape.normals.append(normal)
            shape.uvs.append(box_uv(position, axis, tile))
    count = len(stops)
    for q in range(count - 1):
        for p in range(count - 1):
            a = q * count + p
            b, c, d = a + 1, a + count + 1, a + count
            shape.faces += [(a, b, c), (a, c, d)]
    return shape


def box_uv(position, axis, tile):
    """Walls take their height as v, floors and ceilings x and z."""
    x, y, z = position
    u, v = ((z, -y), (x, z), (x, -y))[axis]
    return (u / tile, v / tile)


def lathe(profile, segments, tiles=(1, 1)):
    """Profile of (radius, height), from bottom to top, turned about +y."""
    rows = len(profile) - 1
    def point(u, v):
        radius, height = profile[round(v * rows)]
        angle = -2 * math.pi * (round(u * segments) % segments) / segments
        return (radius * math.cos(angle), height, radius * math.sin(angle))
    return surface(point, segments, rows, tiles)


def sphere(radius, segments=48, rings=24, center=(0, 0, 0), tiles=(2, 1)):
    profile = [(radius * math.sin(math.pi * k / rings) if 0 < k < rings else 0.0,
                -radius * math.cos(math.pi * k / rings)) for k in range(rings + 1)]
    return moved(lathe(profile, segments, tiles), by=center)


def cylinder(radius, height, segments=32, base=(0, 0, 0), tiles=(1, 1)):
    """Standing on `base`, with flat ends."""
    side = lathe([(radius, 0.0), (radius, height)], segments, tiles)
    top = lathe([(radius, height), (0.0, height)], segments)
    bottom = lathe([(0.0, 0.0), (radius, 0.0)], segments)
    return moved(joined(side, top, bottom), by=base)


def torus(radius, tube_radius, segments=64, sides=24, tiles=(1, 1)):
    """About the y axis."""
    def point(u, v):
        a, b = 2 * math.pi * (round(u * segments) % segments) / segments, 2 * math.pi * (round(v * sides) % sides) / sides
        r = radius - tube_radius * math.cos(b)
        return (r * math.cos(a), tube_radius * math.sin(b), r * math.sin(a))
    return surface(point, segments, sides, tiles)


def icosphere(radius, halvings):
    """Twenty equal faces, each split in four `halvings` times; no normals: flat."""
    g = (1 + math.sqrt(5)) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1),
              (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(halvings):
        between = {}
        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in between:
                between[key] = len(points)
                points.append(mix(points[a], points[b], 0.5))
            return between[key]
        points = [unit(p) for p in points]
        faces = [f for a, b, c in faces for ab, bc, ca in [(middle(a, b), middle(b, c), middle(c, a))]
                 for f in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]
    return Shape([scaled(unit(p), radius) for p in points], faces=faces)
