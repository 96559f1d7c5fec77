"""A Cornell box of our own: one metre, three colours, an emissive ceiling panel, a tall and a short block, all Lambertian.

Made by this script, no third-party content; dimensions and colours are our own choice. Walls are 5 cm boxes, so no light leaks."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import turn
from gltf_writer import Level
from mesh import moved
from shapes import box, quad

WALL = 0.05  # m, thickness


def cornell():
    level = Level("cornell", ag_sky_radiance=[0.0, 0.0, 0.0], ag_exposure_ev=-0.5)
    white = level.material("white", (0.73, 0.72, 0.69), lambert=True)
    red = level.material("red", (0.60, 0.07, 0.05), lambert=True)
    green = level.material("green", (0.12, 0.44, 0.10), lambert=True)
    light = level.material("light", (0.0, 0.0, 0.0), emission=(16.0, 11.5, 6.5), lambert=True)

    # The room spans -0.5..0.5, 0..1, -0.5..0.5 and is open towards +z; side walls stand on the floor and carry the ceiling.
    level.place("floor", box((-0.5 - WALL, -WALL, -0.5 - WALL), (0.5 + WALL, 0, 0.5)), white)
    level.place("ceiling", box((-0.5 - WALL, 1, -0.5 - WALL), (0.5 + WALL, 1 + WALL, 0.5)), white)
    level.place("back", box((-0.5, 0, -0.5 - WALL), (0.5, 1, -0.5)), white)
    level.place("left_red", box((-0.5 - WALL, 0, -0.5 - WALL), (-0.5, 1, 0.5)), red)
    level.place("right_green", box((0.5, 0, -0.5 - WALL), (0.5 + WALL, 1, 0.5)), green)
    level.place("light", quad((-0.13, 0.999, -0.11), (0.26, 0, 0), (0, 0, 0.22)), light)  # faces down, 1 mm below the ceiling

    tall = moved(box((-0.14, 0, -0.14), (0.14, 0.6, 0.14)), turn=turn((0, 1, 0), 18), by=(-0.18, 0, -0.16))
    short = moved(box((-0.145, 0, -0.145), (0.145, 0.29, 0.145)), turn=turn((0, 1, 0), -17), by=(0.19, 0, 0.16))
    level.place("tall_block", tall, white)
    level.place("short_block", short, white)
    level.camera("Camera", eye=(0, 0.5, 1.95), target=(0, 0.5, 0), fov_y_deg=38.5, aspect=1.0)
    return level


def write(folder):
    cornell().write(folder / "cornell.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
