"""The gallery's sculptures as shapes that stand on y = 0, each about half a metre high."""
import math
import random

from algebra import add, scaled, turn
from mesh import Shape, faceted, joined, moved, smooth, surface
from shapes import cylinder, lathe, sphere, torus
from tubes import carried_axes, spline, tube


def torus_knot(p=2, q=3, pieces=240):
    path = []
    for k in range(pieces):
        a = 2 * math.pi * k / pieces
        r = 0.17 + 0.075 * math.cos(q * a)
        path.append((r * math.cos(p * a), 0.075 * math.sin(q * a), r * math.sin(p * a)))
    knot = moved(tube(path, 0.042, 20, closed=True), turn=turn((1, 0, 0), 78))
    return joined(moved(knot, by=(0, 0.33, 0)), cylinder(0.016, 0.10, 24), cylinder(0.09, 0.02, 48))


def head():
    """A head asleep on a long neck: elliptic sections from the shoulders up, with a nose, a brow and a chin pressed into them. Faces +x."""
    sections = [(0.0, 0.115, 0.205, -0.010), (0.03, 0.118, 0.212, -0.010), (0.075, 0.105, 0.185, -0.008), (0.115, 0.070, 0.098, -0.004),
                (0.155, 0.054, 0.058, 0.002), (0.225, 0.050, 0.052, 0.008), (0.275, 0.060, 0.056, 0.018), (0.315, 0.084, 0.070, 0.028),
                (0.365, 0.100, 0.080, 0.026), (0.420, 0.108, 0.085, 0.018), (0.475, 0.106, 0.083, 0.010), (0.525, 0.088, 0.070, 0.000),
                (0.558, 0.056, 0.046, -0.006), (0.572, 0.022, 0.019, -0.008), (0.575, 0.0, 0.0, -0.008)]  # height, depth, width, forward
    curve = spline(sections, 5)
    rows = len(curve) - 1
    features = [(0.395, 0.028, 0.024, 0.16), (0.378, 0.014, 0.014, 0.20), (0.447, -0.006, 0.020, 0.30), (0.345, 0.008, 0.010, 0.28),
                (0.330, 0.007, 0.010, 0.28), (0.300, 0.012, 0.020,
                                              0.40)]  # height, push (m), reach in height (m), reach about the axis (rad)
    def point(u, v):
        height, depth, width, forward = curve[round(v * rows)]
        angle = 2 * math.pi * (round(u * 72) % 72) / 72
        x, z = max(0.0, depth) * math.cos(angle), -max(0.0, width) * math.sin(angle)
        side = math.remainder(angle, 2 * math.pi)
        push = sum(p * math.exp(-((height - h) / dh) ** 2 - (side / da) ** 2) for h, p, dh, da in features)
        socket = sum(math.exp(-((height - 0.428) / 0.018) ** 2 - ((side - s) / 0.22) ** 2) for s in (-0.48, 0.48))
        return (x + forward + push - 0.011 * socket, height, z)
    return joined(moved(surface(point, 72, rows, (1, 1)), by=(0, 0.03, 0)), lathe([(0.0, 0.0), (0.13, 0.0), (0.13, 0.03), (0.0, 0.03)], 48))


def vase(profile, segments=56, steps=5, tiles=(1, 1)):
    """`profile` outside from foot to lip; the inside follows it 6 mm deeper, down to the foot."""
    outside = spline(profile, steps)
    radius, height = outside[-1]
    lip = [(radius - 0.003, height + 0.004)]
    inside = [(max(0.004, r - 0.006), h) for r, h in reversed(outside[steps:])]
    foot = [(0.0, 0.0), (profile[0][0] - 0.004, 0.0)]
    return joined(lathe(foot, segments), lathe([(profile[0][0] - 0.004, 0.0)] + outside, segments, tiles),
                  lathe([outside[-1], *lip, inside[0]], segments),
                  lathe(inside + [(0.0, inside[-1][1])], segments))


def bottle_vase():
    return vase([(0.085, 0.004), (0.10, 0.03), (0.165, 0.16), (0.155, 0.28), (0.075, 0.37), (0.05, 0.45), (0.055, 0.52), (0.085, 0.56)],
                tiles=(1, 1))


def ribbed_vase():
    shape = vase([(0.09, 0.004), (0.13, 0.06), (0.19, 0.18), (0.20, 0.28), (0.16, 0.37), (0.12, 0.40), (0.135, 0.43)], 96)
    def rib(p):
        wave = 1 + 0.035 * math.cos(16 * math.atan2(p[2], p[0])) * math.sin(math.pi * min(1, max(0, p[1] / 0.40)))
        return (p[0] * wave, p[1], p[2] * wave)
    ribbed = Shape([rib(p) for p in shape.positions], shape.normals, shape.uvs, shape.faces)
    return smooth(ribbed)


def crystal(seed=5):
    """A cluster of six-sided prisms with pointed ends."""
    source = random.Random(seed)
    prisms = []
    for k in range(9):
        lean = 0.0 if k == 0 else 12 + 26 * source.random()
        height, radius = (0.50, 0.085) if k == 0 else (0.18 + 0.20 * source.random(), 0.035 + 0.03 * source.random())
        prism = lathe([(0.0, -0.05), (radius * 0.9, -0.05), (radius, height * 0.75), (0.0, height)], 6)
        prisms.append(moved(prism, turn=turn((0, 0, 1), -lean), by=(0, 0.03, 0)))
        prisms[-1] = moved(prisms[-1], turn=turn((0, 1, 0), 137.5 * k))
    return faceted(joined(*prisms))


def ribbon():
    """A band with half a twist, standing on its edge: one side, one rim."""
    count, width, thickness = 160, 0.085, 0.012
    angles = [2 * math.pi * k / count for k in range(count)]
    path = [(0.19 * math.cos(a), 0.24 + 0.19 * math.sin(a), 0.05 * math.sin(2 * a)) for a in angles]
    axes = carried_axes(path, closed=True)
    section = 20
    def point(u, v):
        k = round(v * count) % count
        x, y = axes[k]
        spin = math.pi * round(v * count) / count
        a = 2 * math.pi * (round(u * section) % section) / section
        p, q = width * signed_power(math.cos(a), 0.5), thickness * signed_power(math.sin(a), 0.7)
        p, q = p * math.cos(spin) - q * math.sin(spin), p * math.sin(spin) + q * math.cos(spin)
        return add(path[k], add(scaled(x, p), scaled(y, q)))
    return joined(surface(point, section, count), cylinder(0.10, 0.06, 48))


def signed_power(x, power):
    return math.copysign(abs(x) ** power, x)


def cairn(seed=9):
    """Five pebbles balanced on each other."""
    source = random.Random(seed)
    stones, y = [], 0.0
    for radius, flat in ((0.19, 0.52), (0.155, 0.55), (0.12, 0.62), (0.095, 0.6), (0.06, 0.8)):
        half = radius * flat
        width = radius * (0.85 + 0.15 * source.random())
        pebble = moved(sphere(1, 40, 20), scale=(radius, half, width), turn=turn((0, 1, 0), 360 * source.random()))
        stones.append(moved(pebble, by=(0.03 * (source.random() - 0.5), y + half, 0.03 * (source.random() - 0.5))))
        y += 1.97 * half
    return joined(*stones)


def ring():
    upright = moved(torus(0.21, 0.045, 96, 24), turn=turn((1, 0, 0), 90), by=(0, 0.285, 0))
    return joined(upright, cylinder(0.11, 0.035, 48))
