"""A bright and a dark room behind a 5 cm wall with a door, open in one level and shut in the other: where a bake that leaks is caught.

Made by this script, no third-party content. All surfaces are Lambertian; the only light is a panel in the bright room. The sky outside
is a loud magenta that the closed shell keeps out: inside, any light whose green is less than its blue is a leak. With the door shut every
value in the dark room is exactly 0, which is what `ag_truth` says."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import turn
from gltf_writer import Level
from mesh import joined, moved
from shapes import box, quad, rounded_box, sphere

LENGTH, DEPTH, HEIGHT = 7.0, 4.0, 2.6  # m, inside
SHELL = 0.1  # m
WALL = (3.475, 3.525)  # m, the dividing wall's faces
DOOR = (1.4, 2.3, 2.05)  # m: the opening's sides in z, its height
TUCK = 0.01  # m that a piece reaches into the wall it joins


def two_rooms(door_open):
    name = "two_rooms_open" if door_open else "two_rooms_closed"
    extras = {} if door_open else {"ag_truth": [{
        "derivation": "no path leads from the lamp or the sky into the closed dark room",
        "quantity": "irradiance", "position": [5.2, 1.0, 2.0], "normal": [-1, 0, 0], "value": [0, 0, 0], "relative_tolerance": 0}]}
    level = Level(name, ag_sky_radiance=[20.0, 0.0, 20.0], ag_exposure_ev=-1.0, **extras)
    floor = level.material("floor", (0.46, 0.36, 0.27), lambert=True)
    plaster = level.material("plaster", (0.76, 0.74, 0.70), lambert=True)
    divider = level.material("divider", (0.70, 0.70, 0.70), lambert=True)
    ochre = level.material("ochre", (0.68, 0.36, 0.08), lambert=True)
    blue = level.material("blue", (0.09, 0.20, 0.48), lambert=True)
    wood = level.material("wood", (0.38, 0.23, 0.12), lambert=True)
    lamp = level.material("lamp", (0.0, 0.0, 0.0), emission=(18.0, 16.0, 13.0), lambert=True)

    # The shell: floor and ceiling reach under and over the walls; walls along x stand between those along z.
    s = SHELL
    level.place("floor", box((-s, -s, -s), (LENGTH + s, 0, DEPTH + s)), floor)
    level.place("ceiling", box((-s, HEIGHT, -s), (LENGTH + s, HEIGHT + s, DEPTH + s)), plaster)
    level.place("wall_xn", box((-s, 0, -s), (0, HEIGHT, DEPTH + s)), ochre)
    level.place("wall_xp", box((LENGTH, 0, -s), (LENGTH + s, HEIGHT, DEPTH + s)), plaster)
    level.place("wall_zn", box((0, 0, -s), (LENGTH, HEIGHT, 0)), plaster)
    level.place("wall_zp", box((0, 0, DEPTH), (LENGTH, HEIGHT, DEPTH + s)), plaster)

    # The divider: two panels and a lintel, touching floor, ceiling and walls exactly.
    x0, x1 = WALL
    z0, z1, top = DOOR
    level.place("divider_near", box((x0, 0, 0), (x1, HEIGHT, z0)), divider)
    level.place("divider_far", box((x0, 0, z1), (x1, HEIGHT, DEPTH)), divider)
    level.place("divider_lintel", box((x0, top, z0), (x1, HEIGHT, z1)), divider)
    place_door(level, wood, door_open)

    level.place("lamp", quad((1.2, HEIGHT - 0.06, 1.6), (1.0, 0, 0), (0, 0, 0.8)), lamp)
    level.place("lamp_body", box((1.15, HEIGHT - 0.05, 1.55), (2.25, HEIGHT, 2.45)), plaster)
    furnish(level, wood, blue, ochre, plaster)

    level.camera("CameraBright", eye=(0.35, 1.6, 0.4), target=(3.4, 0.95, 2.4), fov_y_deg=58, aspect=4 / 3)
    level.camera("CameraDark", eye=(6.65, 1.6, 0.4), target=(3.6, 0.9, 2.3), fov_y_deg=60, aspect=4 / 3)
    return level


def place_door(level, wood, door_open):
    z0, z1, top = DOOR
    if not door_open:  # a leaf within the wall's thickness, tucked into its frame and the floor
        level.place("door", box((3.48, -TUCK, z0 - TUCK), (3.52, top + TUCK, z1 + TUCK)), wood)
        return
    leaf = box((0, 0, 0), (0.04, top - 0.02, z1 - z0 - 0.02))
    level.place("door", moved(leaf, turn=turn((0, 1, 0), 62), by=(WALL[1] + 0.01, 0.01, z0)), wood)


def furnish(level, wood, blue, ochre, plaster):
    legs = [box((x, 0, z), (x + 0.05, 0.72, z + 0.05)) for x in (0.9, 2.05) for z in (2.75, 3.4)]
    level.place("table", joined(rounded_box((0.85, 0.72, 2.7), (2.15, 0.76, 3.5), 0.008), *legs), wood)
    level.place("ball", sphere(0.16, 40, 20, (1.3, 0.92, 3.05)), ochre)
    level.place("crate_at_divider", box((3.025, 0, 3.1), (WALL[0], 0.45, 3.7)), blue)  # its back touches the wall
    level.place("shelf_at_divider", box((WALL[1], 0.9, 2.8), (3.825, 0.94, 3.8)), wood)
    level.place("ball_dark", sphere(0.2, 40, 20, (5.0, 0.2, 2.6)), ochre)
    level.place("block_dark", moved(box((-0.3, 0, -0.3), (0.3, 0.9, 0.3)), turn=turn((0, 1, 0), 25), by=(6.0, 0, 3.0)), plaster)


def write(folder):
    two_rooms(door_open=True).write(folder / "two_rooms_open.glb")
    two_rooms(door_open=False).write(folder / "two_rooms_closed.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
