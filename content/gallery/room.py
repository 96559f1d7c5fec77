"""The gallery's room: 14 x 8 m, 4.6 m high, five tall windows towards -z with a terrace before them, beams, skirting, a partition.

Walls are thick boxes. Floor and ceiling slabs reach under and over all walls; walls along z stand between those along x."""
from algebra import turn
from mesh import Shape, joined, without_strays
from shapes import box, lathe, rounded_box

LENGTH, DEPTH, HEIGHT = 14.0, 8.0, 4.6  # m, inside
SHELL = 0.3  # m, thickness of walls and slabs
WINDOW_WALL = 0.45  # m
WINDOWS = [2.0 + 2.5 * k for k in range(5)]  # their centres along x
HALF_WIDTH, SILL, TOP = 0.8, 0.45, 3.8  # m, of an opening
PARTITION = (9.2, 9.45, 5.35, 7.45, 3.0)  # x0, x1, z0, z1, height
TUCK = 0.005  # m that a bar or a frame's piece reaches into its neighbour: no two share an edge
WALL_TILE = 1.5  # m, one tile of the plaster's normals


def build_room(level, m):
    outer, low = SHELL, -WINDOW_WALL
    place_shell(level, "floor", floor_slab(), m.floor, sides=[(0, 1, 0)])
    ceiling = box((-outer, HEIGHT, low), (LENGTH + outer, HEIGHT + outer, DEPTH + outer))
    place_shell(level, "ceiling", ceiling, m.ceiling, sides=[(0, -1, 0)])
    place_shell(level, "wall_near", box((-outer, 0, 0), (0, HEIGHT, DEPTH), WALL_TILE), m.plaster, sides=[(1, 0, 0)])
    place_shell(level, "wall_end", box((LENGTH, 0, 0), (LENGTH + outer, HEIGHT, DEPTH), WALL_TILE), m.slate, sides=[(-1, 0, 0)])
    right = box((-outer, 0, DEPTH), (LENGTH + outer, HEIGHT, DEPTH + outer), WALL_TILE)
    place_shell(level, "wall_right", right, m.plaster, sides=[(0, 0, -1)])
    x0, x1, z0, z1, height = PARTITION
    level.place("partition", box((x0, 0, z0), (x1, height, z1), WALL_TILE), m.plaster)
    build_window_wall(level, m)
    build_beams(level, m)
    for name, lower, upper in (("skirting_right", (0, 0, DEPTH - 0.02), (LENGTH, 0.12, DEPTH)),
                               ("skirting_end", (LENGTH - 0.02, 0, 0), (LENGTH, 0.12, DEPTH - 0.02)),
                               ("skirting_near", (0, 0, 0), (0.02, 0.12, DEPTH - 0.02)),
                               ("skirting_left", (0.02, 0, 0), (LENGTH - 0.02, 0.12, 0.02))):
        level.place(name, box(lower, upper), m.white)
    build_door(level, m)
    build_terrace(level, m)


def place_shell(level, name, slab, material, sides):
    """A slab of the building as two nodes: the sides that the room sees, and the others, for which two texels a metre are enough."""
    def seen(face):
        normal = tuple(map(round, slab.normals[face[0]]))
        return normal in sides
    inside = Shape(slab.positions, slab.normals, slab.uvs, [face for face in slab.faces if seen(face)])
    outside = Shape(slab.positions, slab.normals, slab.uvs, [face for face in slab.faces if not seen(face)])
    level.place(name, without_strays(inside), material)
    level.place(f"{name}_outside", without_strays(outside), material, ag_texels_per_metre=2.0)


def floor_slab():
    """The parquet runs diagonally: its texture is turned by 45 degrees on the slab, one tile is 1.8 m."""
    slab = box((-SHELL, -SHELL, -WINDOW_WALL), (LENGTH + SHELL, 0, DEPTH + SHELL))
    slab.uvs = [((u - v) / (1.8 * 2 ** 0.5), (u + v) / (1.8 * 2 ** 0.5)) for u, v in slab.uvs]
    return slab


def build_window_wall(level, m):
    """A band below the windows, one above, and the piers between; each opening gets a bronze frame and a limestone sill."""
    z0, z1 = -WINDOW_WALL, 0.0
    below = box((-SHELL, 0, z0), (LENGTH + SHELL, SILL, z1), WALL_TILE)
    place_shell(level, "wall_left_below", below, m.plaster, sides=[(0, 0, 1), (0, 1, 0)])
    above = box((-SHELL, TOP, z0), (LENGTH + SHELL, HEIGHT, z1), WALL_TILE)
    place_shell(level, "wall_left_above", above, m.plaster, sides=[(0, 0, 1), (0, -1, 0)])
    edges = [-SHELL] + [edge for x in WINDOWS for edge in (x - HALF_WIDTH, x + HALF_WIDTH)] + [LENGTH + SHELL]
    for k, (start, end) in enumerate(zip(edges[::2], edges[1::2])):
        pier = box((start, SILL, z0), (end, TOP, z1), WALL_TILE)
        place_shell(level, f"pier_{k}", pier, m.plaster, sides=[(0, 0, 1), (1, 0, 0), (-1, 0, 0)])
    frame = level.mesh("window", (window_frame(), m.bronze_frame))
    sill = level.mesh("sill", (rounded_box((-HALF_WIDTH - 0.06, SILL, -0.24), (HALF_WIDTH + 0.06, SILL + 0.04, 0.09), 0.012), m.limestone))
    for k, x in enumerate(WINDOWS):
        level.node(f"window_{k}", mesh=frame, at=(x, 0, -0.30))
        level.node(f"sill_{k}", mesh=sill, at=(x, 0, 0))


def window_frame():
    """A casing, a mullion up the middle, three transoms; about the opening's middle, 5 to 9 cm deep. Each reaches into what it joins."""
    w, half, tuck = HALF_WIDTH, 0.045, TUCK
    casing = [box((-w, SILL, -half), (-w + 0.06, TOP, half)), box((w - 0.06, SILL, -half), (w, TOP, half)),
              box((-w + 0.06 - tuck, TOP - 0.06, -0.042), (w - 0.06 + tuck, TOP + tuck, 0.042)),
              box((-w + 0.06 - tuck, SILL - tuck, -0.042), (w - 0.06 + tuck, SILL + 0.06, 0.042))]
    bars = [box((-0.022, SILL + 0.06 - tuck, -0.03), (0.022, TOP - 0.06 + tuck, 0.03))]
    for k in (1, 2, 3):
        y = SILL + (TOP - SILL) * k / 4
        bars += [box((side[0], y - 0.018, -0.026), (side[1], y + 0.018, 0.026)) 
                 for side in ((-w + 0.06 - tuck, -0.022 + tuck), (0.022 - tuck, w - 0.06 + tuck))]
    return joined(*casing, *bars)


def build_beams(level, m):
    beam = level.mesh("beam", (turned_grain(box((-0.13, HEIGHT - 0.34, 0), (0.13, HEIGHT, DEPTH))), m.walnut))
    for k in range(6):  # over the piers
        level.node(f"beam_{k}", mesh=beam, at=(0.75 + 2.5 * k, 0, 0))


def turned_grain(shape):
    """The walnut's grain runs along v; along a beam it runs the other way."""
    return Shape(shape.positions, shape.normals, [(v, u) for u, v in shape.uvs], shape.faces)


def build_door(level, m):
    """In the wall behind the hero camera: two leaves in a frame."""
    frame = [box((0, 0, 2.502), (0.048, 2.65 + TUCK, 2.62)), box((0, 0, 4.18), (0.048, 2.65 + TUCK, 4.298)),
             box((0, 2.65, 2.5), (0.05, 2.77, 4.3))]
    leaves = [rounded_box((0, 0.005, z), (0.035, 2.65, z + 0.775), 0.008, 1) for z in (2.622, 3.403)]
    level.place("door", joined(*frame, *leaves), m.walnut)


def build_terrace(level, m):
    """What the windows look out on: paving, a hedge, cypresses. A few texels a metre are enough for it."""
    coarse = {"ag_texels_per_metre": 3.0}
    level.place("terrace", box((-1.5, -SHELL - 0.1, -5.0), (15.5, -SHELL, -WINDOW_WALL), 1.2), m.limestone, **coarse)
    level.place("hedge", rounded_box((-1.5, -SHELL, -4.9), (15.5, 1.15, -4.1), 0.15, tile=1.0), m.hedge, **coarse)
    cypress = level.mesh("cypress", (lathe([(0.02, -SHELL), (0.30, -0.1), (0.44, 0.5), (0.46, 1.1), (0.38, 1.9), (0.22, 2.8), (0.0, 3.6)],
                                           20, (3, 4)), m.hedge))
    for k, (x, z, size) in enumerate(((3.1, -3.4, 0.9), (5.9, -3.6, 1.0), (8.3, -3.3, 0.85), (10.9, -3.6, 1.0), (13.4, -3.4, 0.9))):
        level.node(f"cypress_{k}", mesh=cypress, at=(x, SHELL * (size - 1), z), turn=turn((0, 1, 0), 70.0 * k), scale=(size, size, size),
                   **coarse)
