"""The gallery: a small museum in late sun, the level of the demo and of the README's picture.

Made by this script and those beside it, no third-party content: every shape, picture and letter is computed here. 14 x 8 x 4.6 m; the sun
comes through five windows at 30 degrees; the air holds a little dust (a fog box inside the walls), so that the sun's beams show."""
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parent.parent)]
from algebra import combined, look_rotation, turn
from exhibits import build_exhibits
from gltf_writer import Level
from letters import strokes
from materials import Materials
from mesh import joined, moved
from room import DEPTH, HEIGHT, LENGTH, build_room
from shapes import box, cylinder, lathe
from tubes import tube

SUN_DIRECTION = (-0.40, -0.50, 0.78)  # the way the light travels: through the windows, towards the hero camera
WARM = (1.0, 0.76, 0.50)


def gallery():
    level = Level("gallery", ag_sky_radiance=[5.6, 6.5, 7.8], ag_exposure_ev=0.25, ag_bloom=0.04)
    m = Materials(level)
    build_room(level, m)
    build_exhibits(level, m)
    build_sign(level, m)
    build_spots(level, m)
    level.light("sun", "directional", (1.0, 0.80, 0.56), 26.0, at=(7, 8, -8), towards=SUN_DIRECTION, ag_sun_angle_deg=0.53)
    dust = box((0.02, 0.02, 0.02), (LENGTH - 0.02, HEIGHT - 0.02, DEPTH - 0.02))
    level.place("dust", dust, m.plaster, ag_fog_scattering=[0.008, 0.008, 0.008], ag_fog_absorption=[0.0, 0.0, 0.0], ag_fog_g=0.6)
    # Where light is kept for what moves and shines: a grid in the room, a panorama before the partition and one behind it
    level.node("probes", at=(LENGTH / 2, HEIGHT / 2, DEPTH / 2), scale=(13.5, 4.2, 7.5), ag_probe_volume={"spacing_m": 0.8})
    for name, start, end in (("reflection_hall", 0.0, 9.2), ("reflection_end", 9.2, LENGTH)):
        half = [(end - start) / 2, HEIGHT / 2, DEPTH / 2]
        level.node(name, at=(start + half[0], half[1], half[2]), ag_reflection_probe={"half_extents_m": half})
    level.camera("CameraMain", eye=(0.55, 1.55, 5.7), target=(9.0, 1.62, 4.25), fov_y_deg=47, aspect=16 / 9)
    level.camera("CameraSign", eye=(8.6, 1.6, 4.9), target=(14.0, 1.75, 2.9), fov_y_deg=44, aspect=16 / 9)
    level.camera("CameraMirror", eye=(7.7, 1.6, 5.0), target=(5.9, 1.5, 8.0), fov_y_deg=50, aspect=16 / 9)
    return level


def build_sign(level, m):
    """AFTERGLOW in neon, 6 cm before the end wall, on brass pins."""
    tubes, pins = [], []
    for stroke in strokes("AFTERGLOW", 0.54, 0.20):
        tubes.append(tube(stroke, 0.018, 8))
        for x, y, _ in (stroke[0], stroke[-1]):
            pins.append(moved(cylinder(0.006, 0.06, 6), turn=turn((1, 0, 0), -90), by=(x, y, -0.001)))
    facing = {"at": (LENGTH - 0.06, 2.45, 2.9), "turn": turn((0, 1, 0), -90)}
    level.place("sign", joined(*tubes), m.neon, **facing)
    level.place("sign_pins", joined(*pins), m.brass, **facing)


def build_spots(level, m):
    """A track below the beams; each head is a can with a glowing disc, a spot light at its mouth. The bake holds all their light: what
    they shine on does not move."""
    level.place("track", box((2.0, 4.16, 6.18), (12.6, 4.19, 6.22)), m.black)
    level.place("track_hangers", joined(*(cylinder(0.008, HEIGHT - 0.34 - 4.19, 8, (x, 4.19, 6.2)) for x in (3.25, 5.75, 8.25, 10.75))),
                m.black)
    can = lathe([(0.0, 0.21), (0.035, 0.21), (0.045, 0.07), (0.045, 0.012), (0.038, 0.012), (0.038, 0.04)][::-1], 24)
    head = level.mesh("spot_head", (can, m.black), (lathe([(0.0, 0.04), (0.038, 0.04)], 24), m.lamp))
    aims = {"sunset": ((6.6, 4.05, 6.2), (9.2, 1.6, 6.4), 26.0), "dunes": ((11.6, 4.05, 6.2), (11.6, 1.6, 8.0), 16.0),
            "circles": ((2.4, 4.05, 6.2), (2.2, 1.6, 8.0), 16.0), "orb": ((4.4, 4.05, 6.2), (3.6, 1.1, 7.0), 10.0)}
    for name, (at, target, power) in aims.items():
        towards = tuple(b - a for a, b in zip(at, target))
        level.light(f"spot_{name}", "spot", WARM, power, at=at, towards=towards, cone_deg=(14, 26), ag_radius_m=0.03, ag_bake="all")
        level.node(f"spot_head_{name}", mesh=head, at=at, turn=aimed(towards))


def aimed(towards):
    """A head's mouth looks along its own -y."""
    return combined(turn((1, 0, 0), 90), look_rotation(towards))


def write(folder):
    gallery().write(folder / "gallery.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
