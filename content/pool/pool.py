"""A courtyard with still water, a mirror on its wall and a door to a room that is not behind it: planar reflection and portals.

Made by this script, no third-party content. The water is a dielectric of roughness 0 whose normal map ripples it a little; the vault that the
door shows lies 30 m away, and nothing of it lies behind the door."""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import turn
from gltf_writer import Level
from mesh import joined
from patterns import heights, normal_map
from shapes import box, cylinder, quad, sphere

TILE = 2.0  # m, one tile of the ripples
VAULT = (30.0, 0.0, 0.0)  # where the door leads
LAMP = (6.0, 4.0, 2.5)  # radiance of the vault's end wall


def ripples():
    """Waves of a few lengths that close over the tile; the steepest slope is about 0.04."""
    waves = ((2, 1, 0.0024, 0.3), (-1, 3, 0.0020, 1.1), (3, -2, 0.0014, 2.0), (4, 3, 0.0009, 4.2), (-5, 4, 0.0006, 5.1), (7, 2, 0.0004, 0.7))
    def height(u, v):
        return sum(a * math.sin(2 * math.pi * (i * u + j * v) + phase) for i, j, a, phase in waves)
    return normal_map(heights(256, 256, height), TILE)


def pool():
    level = Level("pool", ag_sky_radiance=[0.55, 0.75, 1.1], ag_exposure_ev=0.6)
    paving = level.material("paving", (0.52, 0.49, 0.45), lambert=True)
    wall = level.material("wall", (0.68, 0.62, 0.53), lambert=True)
    colors = {"red": (0.62, 0.10, 0.07), "ochre": (0.68, 0.42, 0.10), "green": (0.14, 0.40, 0.16), "blue": (0.10, 0.20, 0.52)}
    paints = [level.material(name, color, lambert=True) for name, color in colors.items()]
    frame = level.material("frame", (0.12, 0.10, 0.09), lambert=True)
    water = level.material("water", (0.006, 0.016, 0.018), roughness=0.0, normal=level.texture("ripples", ripples()),
                           extensions={"KHR_materials_ior": {"ior": 1.33}})
    silver = level.material("silver", (0.9, 0.9, 0.9), metallic=1.0, roughness=0.0)
    door = level.material("door", (0.02, 0.02, 0.02), lambert=True)
    lamp = level.material("lamp", (0, 0, 0), emission=(3.0, 3.0, 3.0), lambert=True)
    glow = level.material("glow", (0, 0, 0), emission=LAMP, lambert=True)

    # The court: a rim around the water, a wall behind it, columns between them
    level.place("paving", joined(box((-6, -0.3, -4), (6, 0, -2)), box((-6, -0.3, 2), (6, 0, 6)), box((-6, -0.3, -2), (-3.5, 0, 2)),
                                 box((3.5, -0.3, -2), (6, 0, 2))), paving)
    level.place("basin", box((-3.5, -0.9, -2), (3.5, -0.6, 2)), frame)
    level.place("water", quad((-3.5, -0.08, 2), (7, 0, 0), (0, 0, -4), tile=TILE), water, ag_mirror=True)
    level.place("back", box((-6, 0, -4.3), (6, 3.4, -4)), wall)
    level.place("side", box((-6.3, 0, -4.3), (-6, 3.4, 6)), wall)
    for k, paint in enumerate(paints):
        level.place(f"column_{k}", joined(cylinder(0.22, 2.4, 32, (-3.0 + 1.6 * k, 0, -2.9)), box((-3.3 + 1.6 * k, 2.4, -3.2), (-2.7 + 1.6 * k, 2.55, -2.6))),
                    paint)
    level.place("ball", sphere(0.45, 48, 24, (-1.2, 0.45 - 0.3, 0.2)), paints[1])  # half in the water: its mirror image closes it
    # The mirror on the side wall, and a lamp across the court that it shows
    level.place("mirror", quad((-5.97, 0.6, 4.6), (0, 0, -1.8), (0, 1.8, 0)), silver, ag_mirror=True)
    level.place("mirror_frame", joined(box((-6, 0.5, 4.6), (-5.95, 2.5, 4.7)), box((-6, 0.5, 2.7), (-5.95, 2.5, 2.8)),
                                       box((-6, 0.5, 2.8), (-5.95, 0.6, 4.6)), box((-6, 2.4, 2.8), (-5.95, 2.5, 4.6))), frame)
    level.place("lamp", quad((5.6, 0.9, 3.1), (0, 0, 1.2), (0, 1.2, 0)), lamp)  # faces the mirror

    # The door: a frame with nothing behind it, and its twin in the vault
    level.place("door", quad((-0.8, -1.1, 0), (1.6, 0, 0), (0, 2.2, 0)), door, at=(4.5, 1.1, -1.2), ag_portal="gate")
    level.place("door_frame", joined(box((3.55, 0, -1.3), (3.7, 2.35, -1.1)), box((5.3, 0, -1.3), (5.45, 2.35, -1.1)),
                                     box((3.55, 2.2, -1.3), (5.45, 2.35, -1.1))), frame)
    build_vault(level, wall, paving, paints, door, glow)

    level.light("sun", "directional", (1.0, 0.86, 0.66), 4.0, towards=(-0.5, -0.75, -0.43), ag_sun_angle_deg=0.53)
    level.camera("CameraMain", eye=(1.2, 1.5, 5.6), target=(0.3, 0.55, -2.0), fov_y_deg=52, aspect=16 / 9)
    level.camera("CameraDoor", eye=(3.6, 1.5, 2.6), target=(4.45, 1.05, -1.2), fov_y_deg=50, aspect=16 / 9)
    level.camera("CameraMirror", eye=(-2.2, 1.6, 5.2), target=(-5.97, 1.45, 3.6), fov_y_deg=48, aspect=16 / 9)
    return level


def build_vault(level, wall, paving, paints, door, glow):
    """A room of its own, 6 m long, lit by the wall at its end; its gate is at z = 3 and faces that wall."""
    x, y, z = VAULT
    level.place("vault", joined(box((x - 2, y - 0.2, z - 3), (x + 2, y, z + 3)), box((x - 2, y + 2.6, z - 3), (x + 2, y + 2.8, z + 3)),
                                box((x - 2.2, y - 0.2, z - 3), (x - 2, y + 2.8, z + 3)), box((x + 2, y - 0.2, z - 3), (x + 2.2, y + 2.8, z + 3))), wall)
    level.place("vault_end", quad((x - 2, y, z - 3), (4, 0, 0), (0, 2.6, 0)), glow)
    level.place("vault_front", box((x - 2.2, y - 0.2, z + 3.02), (x + 2.2, y + 2.8, z + 3.2)), wall)
    level.place("vault_left", sphere(0.4, 48, 24, (x - 1.2, y + 0.4, z - 0.6)), paints[0])
    level.place("vault_right", box((x + 0.8, y, z - 1.4), (x + 1.5, y + 1.1, z - 0.7)), paints[3])
    level.place("vault_step", box((x - 1.0, y, z - 2.4), (x + 1.0, y + 0.12, z - 1.9)), paving)
    level.place("gate", quad((-0.8, -1.1, 0), (1.6, 0, 0), (0, 2.2, 0)), door, at=(x, y + 1.1, z + 3), turn=turn((0, 1, 0), 180), ag_portal="door")


def write(folder):
    pool().write(folder / "pool.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
