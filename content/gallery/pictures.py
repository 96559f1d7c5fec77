"""The gallery's pictures, all computed: wood, stone, plaster, the rug, the paintings, a leaf, a glaze. Colours are sRGB."""
import math
from functools import lru_cache

from algebra import smoothstep
from patterns import Noise, blend, heights, normal_map, picture, ramp

OAK = [(0.0, (0.46, 0.31, 0.19)), (0.5, (0.65, 0.47, 0.30)), (1.0, (0.79, 0.62, 0.43))]
BLOCK = 5  # a herringbone block is 1 x 5 cells
CELLS = 20  # cells along one tile of the floor
FLOOR_TILE = 1.8  # m
noise, fine = Noise(1), Noise(2)


def herringbone(u, v):
    """Where a point of the floor lies: its block's two coordinates, along 0..1 and across 0..1, and whether the block lies along u."""
    i, j = int(u * CELLS), int(v * CELLS)
    fi, fj = u * CELLS - i, v * CELLS - j
    diagonal = (i - j) % (2 * BLOCK)
    if diagonal < BLOCK:
        return (i - diagonal) % CELLS, j, (diagonal + fi) / BLOCK, fj, True
    step = 2 * BLOCK - 1 - diagonal
    return i, (j - step) % CELLS, (step + fj) / BLOCK, fi, False


def oak_block(u, v):
    """Tone of the wood 0..1, and depth of the joint 0..1 between blocks."""
    a, b, along, across, flat = herringbone(u, v)
    seed = noise.table[a][b]
    drift = 7.0 * seed  # each block is cut from another place of the tree
    grain = fine.at(along * 4 + drift * 5, across * 15 + drift * 9 + 0.8 * noise.at(along * 3 + drift, across * 2, 64, 64), 64, 64)
    rings = noise.at(along * 1.5 + drift * 3, across * 4 + drift, 64, 64)
    tone = 0.25 + 0.46 * (noise.table[b][a] - 0.5) + 0.26 * rings + 0.26 * grain + (0.03 if flat else -0.03)
    edge = min(along * BLOCK, (1 - along) * BLOCK, across, 1 - across)
    return tone, 1 - smoothstep(0.0, 0.05, edge)


def oak_floor():
    def color(u, v):
        tone, joint = oak_block(u, v)
        return blend(ramp(OAK, tone), (0.16, 0.10, 0.06), 0.75 * joint)
    return picture(512, 512, color)


def oak_floor_normals():
    def height(u, v):
        tone, joint = oak_block(u, v)
        return 0.0012 * tone - 0.0018 * joint
    return normal_map(heights(384, 384, height), FLOOR_TILE)


def plaster_normals():
    """Trowel strokes, over a tile of 1.5 m."""
    return normal_map(heights(192, 192, lambda u, v: 0.010 * noise.sum(u, v, 5, 7, 5)), 1.5)


def walnut():
    def color(u, v):
        wave = noise.sum(u, v, 3, 2, 3)
        grain = fine.at(u * 48 + 4 * wave, v * 6, 48, 6)
        return ramp([(0, (0.16, 0.09, 0.05)), (0.5, (0.28, 0.17, 0.10)), (1, (0.42, 0.27, 0.17))], 0.55 * grain + 0.5 * wave)
    return picture(192, 192, color)


def marble():
    def color(u, v):
        bend = noise.sum(u, v, 3, 3, 4)
        vein = abs(math.sin(math.pi * (2 * u + v + 3.0 * bend)))
        cloud = noise.sum(v, u, 4, 4, 3)
        return blend((0.93, 0.92, 0.90), (0.60, 0.60, 0.62), 0.75 * (1 - smoothstep(0, 0.20, vein)) * smoothstep(0.3, 0.7,
                                                                                                                 cloud) + 0.18 * cloud)
    return picture(256, 256, color)


def limestone():
    def color(u, v):
        grain = fine.at(u * 60, v * 60, 60, 60)
        cloud = noise.sum(u, v, 4, 4, 4)
        return blend((0.80, 0.77, 0.71), (0.66, 0.62, 0.56), 0.45 * grain + 0.9 * (cloud - 0.3))
    return picture(192, 192, color)


def rug():
    """A border, a field of lozenges, a medallion; woven in knots of a few millimetres."""
    ground, indigo, ivory, rust = (0.44, 0.11, 0.09), (0.10, 0.14, 0.26), (0.83, 0.76, 0.62), (0.70, 0.33, 0.16)
    def color(u, v):
        knot_u, knot_v = math.floor(u * 192) / 192, math.floor(v * 128) / 128
        x, y = abs(knot_u - 0.5) * 3.4, abs(knot_v - 0.5) * 2.27  # metres from the middle
        edge = min(1.7 - x, 1.135 - y)
        lozenge = (x * 4.4) % 1 + (y * 4.4) % 1
        if edge < 0.04:
            shade = ivory
        elif edge < 0.30:
            wave = math.sin(math.pi * ((x + y) / 0.13))
            shade = rust if abs(wave) < 0.35 else ivory if edge > 0.265 or edge < 0.075 else indigo
        else:
            radius = x / 1.05 + y / 0.72
            ring = (radius * 5) % 1
            if radius < 1:
                shade = (indigo if ring < 0.55 else ivory if ring < 0.68 else rust) if radius > 0.2 else ivory
            else:
                shade = ivory if abs(lozenge - 1) < 0.09 else rust if lozenge < 0.35 or lozenge > 1.65 else ground
        wear = 0.82 + 0.30 * noise.at(u * 40, v * 27, 64, 64) - 0.12 * fine.table[int(knot_u * 192) % 64][int(knot_v * 128) % 64]
        return tuple(c * wear for c in shade)
    return picture(480, 320, color)


def sunset():
    """The large painting: afterglow over still water."""
    sky = [(0.0, (0.09, 0.13, 0.30)), (0.22, (0.25, 0.22, 0.42)), (0.38, (0.62, 0.31, 0.40)), (0.50, (0.92, 0.47, 0.28)),
           (0.58, (0.99, 0.72, 0.36)), (0.62, (1.0, 0.87, 0.58))]
    def color(u, v):
        brush = 0.05 * (noise.sum(u, v, 4, 14, 4) - 0.5)
        if v < 0.62:
            cloud = smoothstep(0.54, 0.74, noise.sum(u, v, 3, 10, 5)) * smoothstep(0.05, 0.3, v)
            shade = blend(ramp(sky, v + brush), (0.98, 0.52, 0.36), 0.55 * cloud)
            sun = math.hypot((u - 0.64) * 1.6, v - 0.575)
            shade = blend(shade, (1.0, 0.95, 0.76), 1 - smoothstep(0.045, 0.055, sun))
            hill = 0.60 - 0.05 * noise.sum(u, 0.3, 5, 1, 4) - 0.06 * smoothstep(0.45, 0.0, u)
            return blend(shade, (0.20, 0.13, 0.24), smoothstep(hill - 0.002, hill + 0.002, v))
        ripple = 0.05 * (noise.sum(u, v, 5, 60, 2) - 0.5) / (v - 0.58)
        depth = 0.62 - (v - 0.62) * 1.25 + ripple
        path = math.exp(-((u - 0.64) / (0.03 + 0.16 * (v - 0.6))) ** 2) * smoothstep(0.42, 0.62, noise.sum(u, v, 6, 50, 2))
        return blend(blend(ramp(sky, depth), (0.08, 0.10, 0.20), 0.35), (1.0, 0.86, 0.60), 0.9 * path)
    return picture(448, 280, color)


def circles():
    """Concentric rings in a grid of nine, no two rows alike."""
    palette = [(0.85, 0.30, 0.18), (0.95, 0.72, 0.26), (0.13, 0.30, 0.45), (0.90, 0.86, 0.76), (0.20, 0.50, 0.46), (0.48, 0.14, 0.24)]
    def color(u, v):
        i, j = int(u * 3), int(v * 3)
        radius = math.hypot(u * 3 - i - 0.5, v * 3 - j - 0.5) + 0.04 * (noise.sum(u, v, 6, 6, 3) - 0.5)
        ring = min(3, int(radius / 0.135))
        tint = 0.92 + 0.16 * noise.sum(u, v, 5, 5, 4)
        return tuple(c * tint for c in palette[(i * 2 + j * 5 + ring * (1 + (i + j) % 2)) % 6])
    return picture(224, 224, color)


def planes():
    """Rectangles and black bars."""
    verticals, horizontals = (0.22, 0.62, 0.86), (0.30, 0.55, 0.82)
    fills = {(0, 1): (0.80, 0.14, 0.10), (1, 3): (0.95, 0.80, 0.20), (2, 0): (0.12, 0.24, 0.55), (3, 2): (0.80, 0.14, 0.10),
             (3, 0): (0.95, 0.80, 0.20)}
    def color(u, v):
        if min(*(abs(u - x) for x in verticals), *(abs(v - y) for y in horizontals)) < 0.014:
            return (0.06, 0.06, 0.07)
        cell = (sum(u > x for x in verticals), sum(v > y for y in horizontals))
        paint = 0.95 + 0.07 * noise.sum(u, v, 6, 6, 4)
        return tuple(c * paint for c in fills.get(cell, (0.93, 0.91, 0.86)))
    return picture(192, 240, color)


def dunes():
    """Layer before layer of hills, paler with distance."""
    @lru_cache(maxsize=None)
    def ridges(u):
        return [0.34 + 0.11 * layer - 0.14 * (noise.sum(u, 0.11 + 0.13 * layer, 3 + layer, 8, 3) - 0.35) for layer in range(6)]
    def color(u, v):
        shade = blend((0.96, 0.84, 0.70), (0.55, 0.68, 0.75), 1 - 1.6 * v)
        for layer, ridge in enumerate(ridges(u)):
            near = layer / 5
            tone = blend((0.78, 0.62, 0.55), (0.16, 0.20, 0.27), near)
            shade = blend(shade, tone, smoothstep(ridge - 0.003, ridge + 0.003, v))
        return tuple(c * (0.97 + 0.06 * fine.at(u * 60, v * 60, 64, 64)) for c in shade)
    return picture(288, 192, color)


def glaze():
    """Blue brush on white porcelain: bands and a scroll."""
    def color(u, v):
        scroll = abs(math.sin(12 * math.pi * u + 2.2 * math.sin(14 * math.pi * v))) * abs(math.sin(7 * math.pi * v))
        band = min(abs(v - b) for b in (0.12, 0.15, 0.80, 0.84, 0.30))
        ink = 1 - smoothstep(0.006, 0.012, band)
        if 0.34 < v < 0.77:
            ink = max(ink, smoothstep(0.60, 0.72, scroll))
        return blend((0.92, 0.93, 0.92), (0.08, 0.16, 0.46), ink * (0.7 + 0.5 * (noise.sum(u, v, 8, 8, 3) - 0.3)))
    return picture(256, 256, color)


def leaf():
    """A leaf from its stalk (bottom) to its tip, RGBA: alpha is the outline with notches between the veins."""
    def color(u, v):
        along, side = 1 - v, abs(u - 0.5) * 2
        width = 0.95 * math.sin(math.pi * along ** 0.75) ** 0.8
        vein = (along * 9 - side * 2.2) % 1
        notch = 0.30 * smoothstep(0.80, 1.0, vein) * smoothstep(0.25, 1.0, side / max(width, 1e-3))
        rib = max(1 - smoothstep(0.03, 0.07, side), 0.5 * (1 - smoothstep(0.04, 0.10, abs(vein - 0.45))))
        green = blend((0.13, 0.34, 0.14), (0.30, 0.52, 0.22), 0.8 * noise.sum(u, v, 4, 8, 3))
        return (*blend(green, (0.50, 0.64, 0.34), 0.6 * rib), 1.0 if side < width * (1 - notch) else 0.0)
    return picture(96, 192, color)


def hedge():
    def color(u, v):
        leaves = fine.at(u * 30, v * 30, 30, 30) * 0.6 + noise.sum(u, v, 8, 8, 3) * 0.5
        return ramp([(0, (0.05, 0.10, 0.04)), (0.5, (0.16, 0.27, 0.11)), (1, (0.36, 0.46, 0.20))], leaves)
    return picture(128, 128, color)
