"""A still life in ink and few tones: what a drawn line has to tell apart, on one table.

Made by this script, no third-party content. A ball whose uvs have a seam, a crate whose faces have normals of their own, a torus, a gem
whose faces meet at 109 degrees (creases) and one at 138 (none), a drum with sharp rims, a bowl with an open border, a ball of two
materials, a ball sunk into the table (no mesh has the edge where they meet), and rods thinner than a pixel. One material brings its own
ramp; the wall behind stays out of the style."""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import turn
from gltf_writer import Level
from mesh import Shape, faceted, joined, moved
from shapes import box, cylinder, icosphere, lathe, quad, sphere, torus


def octahedron(radius):
    points = [(radius, 0, 0), (-radius, 0, 0), (0, radius, 0), (0, -radius, 0), (0, 0, radius), (0, 0, -radius)]
    faces = [(x, y, z) if (x + y + z) % 2 == 0 else (y, x, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    return faceted(Shape(points, faces=faces))


def bowl(radius):
    """A thin shell, open above: its rim is a border of the mesh."""
    steps = 12
    profile = [(radius * math.sin(math.pi / 2 * k / steps), radius - radius * math.cos(math.pi / 2 * k / steps)) for k in range(steps + 1)]
    return lathe(profile, 40)


def halves(radius):
    """A ball in two pieces that share a ring."""
    steps = 10
    def half(first):
        angles = [math.pi * (first + k / steps) / 2 for k in range(steps + 1)]
        return lathe([(radius * math.sin(a) if 1e-6 < a < math.pi - 1e-6 else 0.0, -radius * math.cos(a)) for a in angles], 40)
    return half(0), half(1)


def still_life():
    level = Level("still_life", ag_sky_radiance=[0.25, 0.28, 0.34], ag_exposure_ev=0.0, ag_tone_curve="none",
                  ag_style="toon", ag_toon_steps=3, ag_outline_px=2.0)
    table = level.material("table", (0.62, 0.47, 0.30), lambert=True)
    wall = level.material("wall", (0.55, 0.62, 0.60), lambert=True, ag_toon=False)
    red = level.material("red", (0.70, 0.13, 0.09), lambert=True)
    blue = level.material("blue", (0.10, 0.25, 0.60), lambert=True)
    cream = level.material("cream", (0.85, 0.78, 0.62), lambert=True)
    green = level.material("green", (0.20, 0.50, 0.22), lambert=True)
    glaze = level.material("glaze", (0.12, 0.35, 0.38), roughness=0.35)
    skin = level.material("skin", (0.90, 0.55, 0.10), lambert=True, ag_toon_ramp=[[0.25, 0.1, 0.3], [0.7, 0.6, 0.6], [1.0, 1.0, 0.9], [1.3, 1.3, 1.2]],
                          ag_toon_edges=[0.2, 0.5, 0.9])

    level.place("table", box((-1.6, -0.1, -1.0), (1.6, 0, 1.0)), table)
    level.place("wall", quad((-3.0, -0.6, -1.4), (6.0, 0, 0), (0, 3.0, 0)), wall)
    level.place("ball", sphere(0.26), red, at=(-0.95, 0.26, 0.15))
    level.place("crate", moved(box((-0.22, 0, -0.22), (0.22, 0.44, 0.22)), turn=turn((0, 1, 0), 28)), cream, at=(-0.35, 0, -0.35))
    level.place("ring", moved(torus(0.22, 0.08, 48, 20), turn=turn((1, 0, 0), 62)), skin, at=(0.25, 0.23, 0.45))
    level.place("gem", octahedron(0.26), green, at=(0.85, 0.26, 0.42))
    level.place("stone", faceted(icosphere(0.24, 0)), blue, at=(-0.45, 0.2, 0.55), turn=turn((0, 0, 1), 20))
    level.place("drum", cylinder(0.2, 0.5), blue, at=(0.95, 0, -0.45))
    level.place("bowl", bowl(0.28), glaze, at=(0.30, 0, -0.30))
    lower, upper = halves(0.17)
    level.node("two_coloured_ball", mesh=level.mesh("two_coloured_ball", (lower, cream), (upper, red)), at=(0.30, 0.30, -0.30))
    level.place("sunken_ball", sphere(0.3), green, at=(1.25, -0.12, 0.0))
    rods = [cylinder(0.004, 0.9, 8, base=(x, 0, -0.8)) for x in (-1.3, -1.2, -1.1)]
    level.place("rods", joined(*rods), red)

    level.light("sun", "directional", (1.0, 0.96, 0.88), 2.6, towards=(0.55, -0.75, -0.45), ag_sun_angle_deg=0.5)
    level.camera("Camera", eye=(0.3, 1.35, 3.0), target=(0.0, 0.22, -0.1), fov_y_deg=36, aspect=16 / 9)
    level.camera("CameraNear", eye=(0.9, 0.75, 1.5), target=(0.45, 0.2, 0.0), fov_y_deg=40, aspect=16 / 9)
    return level


def write(folder):
    still_life().write(folder / "still_life.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
