"""What a picture can mirror of itself, and what it cannot: a cube hangs over a polished floor, and only the floor would show its red underside.

The floor's three strips have roughness 0.02, 0.12 and 0.24; the wall behind it shows whether the image of a far thing is where it must be.
Made by this script, no third-party content; after the lecture's example of the limits of screen-space reflection."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import turn
from gltf_writer import Level
from mesh import moved
from shapes import box, quad

EDGE = 0.5  # m, half of the cube's


def faces():
    """Each face of the cube by its colour."""
    e = EDGE
    return {
        "blue": [quad((-e, -e, e), (2 * e, 0, 0), (0, 2 * e, 0)), quad((e, -e, -e), (-2 * e, 0, 0), (0, 2 * e, 0))],
        "yellow": [quad((e, -e, e), (0, 0, -2 * e), (0, 2 * e, 0)), quad((-e, -e, -e), (0, 0, 2 * e), (0, 2 * e, 0))],
        "white": [quad((-e, e, e), (2 * e, 0, 0), (0, 0, -2 * e))],
        "red": [quad((-e, -e, -e), (2 * e, 0, 0), (0, 0, 2 * e))],
    }


def hanging_cube():
    level = Level("hanging_cube", ag_sky_radiance=[0.6, 0.7, 0.9], ag_exposure_ev=-0.5)
    colors = {"blue": (0.08, 0.2, 0.7), "yellow": (0.8, 0.6, 0.05), "white": (0.8, 0.8, 0.8), "red": (0.8, 0.05, 0.03)}
    paints = {name: level.material(name, color, lambert=True) for name, color in colors.items()}
    lamp = level.material("red_glow", (0.0, 0.0, 0.0), emission=(2.0, 0.08, 0.05), lambert=True)
    for k, roughness in enumerate((0.02, 0.12, 0.24)):
        strip = level.material(f"polished_{k}", (0.75, 0.75, 0.75), metallic=1.0, roughness=roughness)
        level.place(f"strip_{k}", quad((-3 + 2 * k, 0, 3), (2, 0, 0), (0, 0, -6)), strip)
    for k, (x, angle) in enumerate(((-2, 20), (0, 35), (2, 50))):
        for name, quads in faces().items():
            for i, face in enumerate(quads):
                shape = moved(face, turn=turn((0, 1, 0), angle), by=(x, 1.1, 0))
                level.place(f"cube_{k}_{name}_{i}", shape, lamp if name == "red" else paints[name])
    for k in range(6):
        level.place(f"wall_{k}", box((-3 + k, 0, -3.1), (-2 + k, 1.2 + 0.3 * (k % 3), -3.0)), paints["white" if k % 2 else "yellow"])
    level.camera("Camera", eye=(0, 2.2, 6.2), target=(0, 0.6, 0), fov_y_deg=42, aspect=16 / 9)
    return level


def write(folder):
    hanging_cube().write(folder / "hanging_cube.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
