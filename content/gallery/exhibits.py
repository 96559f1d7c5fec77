"""What stands, hangs and grows in the gallery: sculptures, framed pictures, the mirror, bench, rug, ropes, plants, a mobile."""
import math
import random

import sculptures
from algebra import add, combined, rotated, scaled, turn
from mesh import joined, moved, surface
from shapes import box, cylinder, lathe, quad, rounded_box, sphere
from tubes import spline, tube
from room import DEPTH, LENGTH, PARTITION, TUCK

UP = (0, 1, 0)


def build_exhibits(level, m):
    shown = [  # name, shape, its material, pedestal's material, x, z, pedestal's height, turn in degrees, size
        ("knot", sculptures.torus_knot(), m.gold, m.limestone, 4.6, 3.1, 1.00, 25, 1.35),
        ("head", sculptures.head(), m.marble, m.walnut, 6.5, 4.65, 1.02, 155, 1.3),
        ("bottle", sculptures.bottle_vase(), m.porcelain, m.white, 9.2, 3.1, 0.92, 0, 1.25),
        ("cairn", sculptures.cairn(), m.copper, m.limestone, 8.6, 1.5, 0.74, 40, 1.3),
        ("crystal", sculptures.crystal(), m.amethyst, m.white, 10.9, 4.75, 1.00, 0, 1.3),
        ("orb", moved(sphere(0.2, 64, 32), by=(0, 0.2, 0)), m.obsidian, m.white, 3.6, 7.0, 0.95, 0, 1.0),
        ("ribbed", sculptures.ribbed_vase(), m.celadon, m.walnut, 11.2, 1.2, 0.90, 0, 1.2),
        ("ring", sculptures.ring(), m.steel, m.limestone, 12.6, 5.7, 0.95, 20, 1.2),
        ("ribbon", sculptures.ribbon(), m.bronze, m.white, 2.6, 1.9, 1.00, 60, 1.2),
    ]
    for name, shape, material, pedestal, x, z, height, degrees, size in shown:
        level.place(f"pedestal_{name}", rounded_box((-0.24, 0, -0.24), (0.24, height, 0.24), 0.012, tile=0.9), pedestal, at=(x, 0, z))
        level.place(name, moved(shape, scale=(size, size, size)), material, at=(x, height, z), turn=turn(UP, degrees))
    build_roughness_row(level, m)
    build_pictures(level, m)
    build_furniture(level, m)
    build_ropes(level, m, 4.6, 3.1)
    for k, (x, z) in enumerate(((5.75, 0.55), (13.25, 0.6))):
        build_plant(level, m, f"plant_{k}", (x, 0, z), seed=31 + k)
    build_mobile(level, m, (5.75, 4.26, 3.3))


def build_roughness_row(level, m):
    """Five steel balls from mirror to matt, on a long plinth below the sign."""
    level.place("plinth", rounded_box((-0.2, 0, -1.5), (0.2, 0.85, 1.5), 0.012, tile=0.9), m.walnut, at=(LENGTH - 0.55, 0, 3.0))
    for k, material in enumerate(m.roughness_row):
        level.place(f"ball_{k}", sphere(0.17, 48, 24, (0, 0.17, 0)), material, at=(LENGTH - 0.55, 0.85, 1.8 + 0.6 * k))


def build_pictures(level, m):
    """`turn`: the wall's direction; a picture faces +z before it is turned."""
    x0, _, z0, z1, _ = PARTITION
    facing_near, facing_window = turn(UP, -90), turn(UP, 180)
    hang(level, "picture_sunset", m.canvas["sunset"], m.walnut, 1.76, 1.10, (x0, 1.62, (z0 + z1) / 2), facing_near)
    hang(level, "picture_dunes", m.canvas["dunes"], m.brass, 1.35, 0.90, (11.6, 1.65, DEPTH), facing_window)
    hang(level, "picture_circles", m.canvas["circles"], m.black, 1.0, 1.0, (2.2, 1.65, DEPTH), facing_window)
    hang(level, "picture_planes", m.canvas["planes"], m.black, 0.88, 1.10, (0.0, 1.65, 6.2), turn(UP, 90))
    hang(level, "picture_dusk", m.canvas["dunes"], m.walnut, 1.2, 0.8, (0.0, 1.65, 1.2), turn(UP, 90))
    hang(level, "mirror", m.mirror, m.brass, 1.9, 2.3, (6.2, 1.55, DEPTH), facing_window, border=0.09, ag_mirror=True)


def hang(level, name, material, frame_material, width, height, middle, facing, border=0.05, **extras):
    """The frame holds its picture as a node of its own, so that the mirror's frame is none."""
    w, h, deep = width / 2, height / 2, 0.04
    t = TUCK
    bars = [rounded_box((-w - border, h, 0), (w + border, h + border, deep), 0.008, 1),
            rounded_box((-w - border, -h - border, 0), (w + border, -h, deep), 0.008, 1),
            rounded_box((-w - border + 0.002, -h - t, 0), (-w, h + t, deep - 0.002), 0.008, 1),
            rounded_box((w, -h - t, 0), (w + border - 0.002, h + t, deep - 0.002), 0.008, 1)]
    level.place(f"{name}_frame", joined(*bars), frame_material, at=middle, turn=facing)
    canvas = quad((-w, -h, 0.018), (width, 0, 0), (0, height, 0))
    canvas.uvs = [(u / width, v / height) for u, v in canvas.uvs]
    level.place(name, canvas, material, at=middle, turn=facing, **({"ag_texels_per_metre": 24.0} | extras))


def build_furniture(level, m):
    carpet = rounded_box((-1.7, 0, -1.135), (1.7, 0.014, 1.135), 0.006, 1)
    carpet.uvs = [(0.5 + x / 3.4, 0.5 + z / 2.27) for x, _, z in carpet.positions]
    level.place("rug", carpet, m.rug, at=(4.7, 0.001, 5.75))
    legs = [box((x - 0.03, 0, z - 0.03), (x + 0.03, 0.38, z + 0.03)) for x in (-0.17, 0.17) for z in (-0.68, 0.68)]
    level.place("bench", joined(rounded_box((-0.24, 0.36, -0.8), (0.24, 0.40, 0.8), 0.008), *legs), m.walnut, at=(5.3, 0.015, 5.75))
    level.place("cushion", rounded_box((-0.23, 0.40, -0.78), (0.23, 0.48, 0.78), 0.035, 4), m.leather, at=(5.3, 0.015, 5.75))


def build_ropes(level, m, x, z):
    """Three brass posts towards the visitors, two velvet ropes between."""
    profile = [(0.0, 0.0), (0.14, 0.0), (0.14, 0.012), (0.03, 0.03), (0.018, 0.05), (0.018, 0.86), (0.03, 0.88), (0.018, 0.90),
               (0.03, 0.93), (0.0, 0.95)]
    post = level.mesh("post", (lathe(profile, 32), m.brass))
    places = [(x - 0.95, 0, z - 0.25), (x - 0.75, 0, z + 0.85), (x + 0.55, 0, z + 0.95)]
    for k, at in enumerate(places):
        level.node(f"post_{k}", mesh=post, at=at)
    for k, (a, b) in enumerate(zip(places, places[1:])):
        points = [add(add(a, scaled((b[0] - a[0], 0, b[2] - a[2]), t)),
                      (0, 0.86 - 0.75 * t * (1 - t), 0)) for t in (i / 24 for i in range(25))]
        level.place(f"rope_{k}", tube(points, 0.017, 12), m.rope)


def build_plant(level, m, name, at, seed):
    pot = lathe([(0.0, 0.0), (0.17, 0.0), (0.25, 0.42), (0.26, 0.45), (0.235, 0.45), (0.225, 0.40), (0.0, 0.40)], 40)
    level.place(f"{name}_pot", pot, m.terracotta, at=at)
    source = random.Random(seed)
    stems, leaves = [], []
    for k in range(16):
        about, lean = 137.5 * k + 20 * source.random(), 10 + 48 * (k / 16) + 8 * source.random()
        reach = 1.25 - 0.45 * (k / 16) + 0.2 * source.random()
        over = rotated(turn(UP, about), (math.sin(math.radians(lean)), 0, 0))
        tip = (over[0] * reach * 0.62, 0.40 + reach * math.cos(math.radians(lean * 0.8)), over[2] * reach * 0.62)
        stems.append(tube(spline([(over[0] * 0.06, 0.36, over[2] * 0.06), (over[0] * 0.2, 0.40 + 0.5 * (tip[1] - 0.40), over[2] * 0.2),
                                  tip], 6), 0.007, 6))
        leaves.append(moved(leaf(0.50 + 0.16 * source.random()), turn=combined(turn((0, 0, 1), 25 - lean), turn(UP, about)), by=tip))
    level.node(f"{name}_leaves", mesh=level.mesh(f"{name}_leaves", (joined(*leaves), m.leaf), (joined(*stems), m.stem)), at=at)


def leaf(size):
    """Grows from the origin towards +x, folded along its rib, its tip drooping."""
    def point(u, v):
        side = (u - 0.5) * 0.44 * size
        return (v * size * 0.95, 0.22 * abs(side) + size * (0.22 * v - 0.52 * v * v), -side)
    return surface(point, 4, 9)


def build_mobile(level, m, top):
    """Wire arms, each with a plate at one end and the next arm at the other: it moves, so it takes no part in the bake."""
    level.place("mobile_hook", tube([top, (top[0], top[1] - 0.8, top[2])], 0.004, 8), m.black, ag_static=False)
    joint = (top[0], top[1] - 0.8, top[2])
    for k, (paint, plate, left, right, about) in enumerate(zip(m.paints, (0.20, 0.17, 0.15, 0.13, 0.11), (0.75, 0.62, 0.52, 0.42, 0.34),
                                                               (0.55, 0.46, 0.38, 0.30, 0.26), (20, 75, -30, 140, 60))):
        direction = rotated(turn(UP, about), (1, 0, 0))
        plate_end, arm_end = add(joint, scaled(direction, -left)), add(add(joint, scaled(direction, right)), (0, 0.04, 0))
        arm = tube(spline([add(plate_end, (0, -0.02, 0)), add(joint, (0, 0.02, 0)), arm_end], 8), 0.008, 8)
        drop = tube([arm_end, add(arm_end, (0, -0.18, 0))], 0.005, 6)
        facing = combined(turn((0, 0, 1), 72), turn(UP, 50 * math.sin(2.1 * k)))  # its plate hangs on edge, more or less towards the door
        disc = moved(lathe([(0.0, -0.003), (plate, -0.003), (plate, 0.003), (0.0, 0.003)], 40), scale=(0.8, 1, 1.3), turn=facing)
        mesh = level.mesh(f"mobile_{k}", (joined(arm, drop), m.black), (moved(disc, by=add(plate_end, (0, -0.02 - 0.5 * plate, 0))), paint))
        level.node(f"mobile_{k}", mesh=mesh, ag_static=False)
        joint = add(arm_end, (0, -0.18, 0))
