"""Tiny levels whose answer is derived on paper and written into them: of surfaces here, of lights in lights.py, of media in air.py.

Made by this script, no third-party content; stated.py says how an answer is written."""
import math
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parent.parent)]
import air
import lights
from algebra import subtract, turn
from mesh import Shape, inside_out
from shapes import box, icosphere, quad
from stated import grey, irradiance, level_of, radiance


def furnace_of(name, emission, albedo, bounces, more=()):
    """Closed icosahedron-like room, everything emits and reflects alike."""
    answer = emission / (1 - albedo)
    why = "closed diffuse enclosure of any shape, emission Le = %g and albedo rho = %g everywhere: L = Le + rho L, so L = Le / (1 - rho)" % (
        emission, albedo)
    cut = why + " (1 - rho^(n + 2)) where paths end after n surfaces and the light that reaches one more"
    level = level_of(name, [radiance("Camera", grey(answer), why, bounces=1024),
                            *(radiance("Camera", grey(answer * (1 - albedo**(n + 2))), cut, bounces=n) for n in bounces),
                            *(row(why, answer) for row in more)])
    wall = level.material("wall", grey(albedo), emission=grey(emission), lambert=True)
    level.place("shell", inside_out(icosphere(1.0, 2)), wall)
    level.camera("Camera", eye=(0, 0, 0.2), target=(0, 0, -1), fov_y_deg=60, aspect=1.0)
    return level


def furnace():
    return furnace_of("furnace", 0.5, 0.5, (0, 1, 7), [lambda why, answer: irradiance([0.1, 0.2, -0.3], [0, 1, 0], grey(math.pi * answer),
                                                                                      why + "; E = pi L")])


def furnace_bright():
    return furnace_of("furnace_bright", 1.0, 0.9, (4, 16))


def furnace_clutter():
    """The furnace with blocks standing in it: occlusion must not show."""
    why = "a furnace stays uniform whatever stands in it, if that too has Le = 0.1 and rho = 0.9: L = Le / (1 - rho) = 1"
    level = level_of("furnace_clutter", [radiance("Camera", grey(1.0), why, bounces=1024)])
    wall = level.material("wall", grey(0.9), emission=grey(0.1), lambert=True)
    level.place("room", inside_out(box((-2, 0, -2), (2, 3, 2))), wall)
    for k, (x, z, size, height) in enumerate(((-0.8, -0.7, 0.5, 1.9), (0.7, -0.9, 0.4, 1.1), (0.2, 0.4, 0.3, 0.5))):
        level.place(f"block_{k}", box((x - size, 0, z - size), (x + size, height, z + size)), wall)
    level.camera("Camera", eye=(1.6, 1.8, 1.7), target=(-0.4, 0.7, -0.6), fov_y_deg=60, aspect=1.0)
    return level


def sphere_point_light():
    """Flat faces, as glTF asks for when normals are absent."""
    why = ("point light of intensity I = pi at the centre of a diffuse sphere, R = 1, rho = 0.5: the wall sends out L = rho I / (pi"
           " R^2) / (1 - rho) = 1."
           " The sphere is a polyhedron of 1280 faces with area 4 pi: the mean over its wall is exact, one place is off by the square"
           " of a face's size")
    level = level_of("sphere_point_light", [radiance("Camera", grey(1.0), why, 0.01)])
    wall = level.material("wall", grey(0.5), lambert=True)
    shell = icosphere(1.0, 3)
    size = math.sqrt(4 * math.pi / area(shell))
    level.place("shell", inside_out(icosphere(size, 3)), wall)
    level.light("light", "point", (1.0, 1.0, 1.0), math.pi, ag_bake="all")
    level.camera("Camera", eye=(0, 0, 0.2), target=(0, 0, -1), fov_y_deg=60, aspect=1.0)
    return level


def area(shape):
    total = 0.0
    for a, b, c in shape.faces:
        (ax, ay, az), (bx, by, bz) = subtract(shape.positions[b], shape.positions[a]), subtract(shape.positions[c], shape.positions[a])
        total += 0.5 * math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    return total


def parallel_plates(name="parallel_plates", turned=lambda v: v):
    why = ("two parallel diffuse plates, plate 1 (below) emits L1 = 1, albedos 0.5 and 0.8: B1 = L1 + rho1 B2 and B2 = rho2 B1, so B1"
           " = L1 / (1 - rho1 rho2) = 5/3,"
           " B2 = 4/3. 400 m wide, 1 m apart: the open rim takes less than 1e-4 at the middle")
    level = level_of(name, [radiance("CameraDown", grey(5 / 3), why, 1e-3), radiance("CameraUp", grey(4 / 3), why, 1e-3)])
    below = level.material("below", grey(0.5), emission=grey(1.0), lambert=True)
    above = level.material("above", grey(0.8), lambert=True)
    level.place("plate_below", quad(turned((-200, 0, 200)), turned((400, 0, 0)), turned((0, 0, -400))), below, ag_texels_per_metre=0.2)
    level.place("plate_above", quad(turned((-200, 1, -200)), turned((400, 0, 0)), turned((0, 0, 400))), above, ag_texels_per_metre=0.2)
    level.camera("CameraDown", eye=turned((0, 0.5, 0)), target=(0, 0, 0), fov_y_deg=40, aspect=1.0)
    level.camera("CameraUp", eye=turned((0, 0.5, 0)), target=turned((0, 1, 0)), fov_y_deg=40, aspect=1.0)
    return level


def turned_plates():
    """Along no axis: what meets so large a triangle rounds by its size, and a ray that leaves it must not meet it again."""
    rows = ((2, 3, 6), (3, -6, 2), (6, 2, -3))  # sevenths: a rotation
    return parallel_plates("turned_plates", lambda v: tuple(sum(r * x for r, x in zip(row, v)) / 7 for row in rows))


def mirror_corridor():
    why = ("between facing mirrors of reflectance r = 0.9 at x = -1 and 1, a ray that has gone 20 m across meets the emitter (L = 1)"
           " at z = -2 after 10 reflections:"
           " L r^10. The camera's pixels all have gone 19.3 to 20.7 m there, within the tenth image; at 6 degrees Fresnel's edge adds"
           " less than 1e-10")
    level = level_of("mirror_corridor", [radiance("Camera", grey(0.9 ** 10), why)])
    mirror = level.material("mirror", grey(0.9), metallic=1.0, roughness=0.0)
    lamp = level.material("lamp", grey(0.0), emission=grey(1.0), lambert=True)
    level.place("mirror_left", quad((-1, -1, 1), (0, 0, -3), (0, 2, 0)), mirror)
    level.place("mirror_right", quad((1, -1, -2), (0, 0, 3), (0, 2, 0)), mirror)
    level.place("emitter", quad((-1, -1, -2), (2, 0, 0), (0, 2, 0)), lamp)
    level.camera("Camera", eye=(0, 0, 0), target=(20, 0, -2), fov_y_deg=0.4, aspect=1.0)
    return level


def portal():
    why = ("a door at z = -1 that leads to its twin 20 m aside, turned by a right angle: the camera's ray along -z leaves the twin along"
           " +x and meets the lamp there, L = 0.75; a portal dims nothing. Behind the door stands a lamp of 9 that must not be seen, and"
           " before the twin, on its back, one of 5")
    level = level_of("portal", [radiance("Camera", grey(0.75), why)])
    door = level.material("door", grey(0.5), lambert=True)
    lamps = {name: level.material(name, grey(0.0), emission=grey(value), lambert=True, double_sided=True)
             for name, value in (("lamp", 0.75), ("hidden", 9.0), ("back", 5.0))}
    side = turn((0, 1, 0), 90)  # the twin faces +x
    level.place("door", quad((-1, -1, 0), (2, 0, 0), (0, 2, 0)), door, at=(0, 0, -1), ag_portal="twin")
    level.place("twin", quad((-1, -1, 0), (2, 0, 0), (0, 2, 0)), door, at=(20, 0, 0), turn=side, ag_portal="door")
    level.place("hidden", quad((-1, -1, -2), (2, 0, 0), (0, 2, 0)), lamps["hidden"])
    level.place("lamp", quad((23, -1, -1), (0, 0, 2), (0, 2, 0)), lamps["lamp"])
    level.place("back", quad((19, -1, -1), (0, 0, 2), (0, 2, 0)), lamps["back"])
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=10, aspect=1.0)
    return level


def uniform_sky():
    sky = [0.5, 1.0, 2.0]
    why = "plane under a uniform sky of radiance L: E = pi L"
    level = level_of("uniform_sky", [irradiance([0.3, 0, -0.4], [0, 1, 0], [math.pi * x for x in sky], why),
                                     radiance("Camera", [0.6 * x for x in sky], why + "; an albedo of 0.6 sends out 0.6 L")], sky=sky)
    level.place("plane", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("plane", grey(0.6), lambert=True))
    level.camera("Camera", eye=(0, 2, 0), target=(0, 0, 0), fov_y_deg=50, aspect=1.0)
    return level


def white_sky():
    """Plates side by side under a sky of 1: what each sends to the eye is the share that it reflects of all light from there."""
    albedo = "directional albedo of GGX, F = 1, height-correlated Smith, by quadrature in slope space: "
    whole = "under a sky of radiance 1 whatever absorbs nothing sends out 1: "
    facets = whole + "what one facet loses others send back, by a fit that errs up to 1 % to the dark, "
    between = 0.2 * (1 - 0.87704635)  # of brushed metals: alpha's ratio, of what a round lobe of alpha 0.05^(1/2) loses at mu 0.5
    brushed_albedo = albedo + "and 0.2 of what a round lobe of the mean alpha loses, by a fit that errs up to 1 % to the dark, "
    thin = {"KHR_materials_transmission": {"transmissionFactor": 1.0}}
    solid = {**thin, "KHR_materials_ior": {"ior": 1.5}, "KHR_materials_volume": {"thicknessFactor": 0.1}}
    brushed = {"KHR_materials_anisotropy": {"anisotropyStrength": 2 / 3}}
    rows = (  # camera, value, derivation, eye seen from the plate, material
        ("Camera", 1.0, whole + "Lambert", (0.5, 1, 0), dict(lambert=True)),
        ("CameraRough", 1.0, whole + "EON of albedo 1 keeps its energy", (1.7, 1, 0), dict(lambert=True, ag_sigma_deg=60.0)),
        ("CameraGlazed", 1.0, whole + "what the layer does not send back the base receives, by a table that errs up to 1.2 % to the dark",
         (1, 1, 0), dict(roughness=0.5)),
        ("CameraMetal", 1.0, facets + "alpha 0.25, mu 0.5", (math.sqrt(3), 1, 0), dict(metallic=1.0, roughness=0.5)),
        ("CameraMetalUpright", 1.0, facets + "alpha 0.5, mu 1", (0, 1, 0), dict(metallic=1.0, roughness=math.sqrt(0.5))),
        ("CameraMetalRough", 1.0, facets + "alpha 1, mu 1", (0, 1, 0), dict(metallic=1.0, roughness=1.0)),
        ("CameraBrushed", 0.8057605942 + between, brushed_albedo + "alpha 0.5 and 0.1, mu 0.5 along the first", (math.sqrt(3), 1, 0),
         dict(metallic=1.0, roughness=math.sqrt(0.1), extensions=brushed)),
        ("CameraBrushedAcross", 0.8042691365 + between, brushed_albedo + "alpha 0.5 and 0.1, mu 0.5 along the second", (0, 1, math.sqrt(3)),
         dict(metallic=1.0, roughness=math.sqrt(0.1), extensions=brushed)),
        ("CameraPane", 1.0, whole + "a clear pane", (1, 1, 0), dict(roughness=0.0, extensions=thin)),
        ("CameraFrosted", 0.8572634356, albedo + "alpha 0.25, mu 0.5; F of it reflected, 1 - F turned through the pane", (math.sqrt(3), 1, 0),
         dict(roughness=0.5, extensions=thin)),
        ("CameraGlass", 1.0, whole + "a block of glass, all its inner reflections", (1, 1, 0), dict(roughness=0.0, extensions=solid)))
    level = level_of("white_sky", [radiance(name, grey(value), why, 0.012 if "table" in why else 0.01 if "fit" in why else 5e-4) for name, value, why, _, _ in rows], sky=(1.0, 1.0, 1.0))
    for k, (name, _, _, eye, look) in enumerate(rows):
        shape = quad((10 * k - 2, 0, 2), (4, 0, 0), (0, 0, -4)) if name != "CameraGlass" else box((10 * k - 2, -1, -2), (10 * k + 2, 0, 2))
        level.place(name.lower(), shape, level.material(name.lower(), grey(1.0), **look))
        level.camera(name, eye=(10 * k + eye[0], eye[1], eye[2]), target=(10 * k, 0, 0), fov_y_deg=0.2, aspect=1.0,
                     up=(0, 1, 0) if eye[0] or eye[2] else (0, 0, -1))
    return level


def triangle():
    why = ("one triangle of radiance 1 seen from the origin: Lambert's E = 1/2 |sum of angle_i (unit(v_i x v_i+1) . n)| = 0.302299894;"
           " the ray through the camera's middle meets it: radiance 1")
    level = level_of("triangle", [irradiance([0, 0, 0], [0, 1, 0], grey(0.302299894), why), radiance("Camera", grey(1.0), why)])
    corners = [(1, 1, 0), (0, 1, -1), (0, 2, 0)]  # its front, counter-clockwise, looks down at the origin
    level.place("triangle", Shape(corners, faces=[(0, 2, 1)]), level.material("light", grey(0.0), emission=grey(1.0), lambert=True))
    level.camera("Camera", eye=(0, 0, 0), target=(1 / 3, 4 / 3, -1 / 3), fov_y_deg=1, aspect=1.0)
    return level


def empty():
    sky = [0.2, 0.3, 0.4]
    level = level_of("empty", [radiance("Camera", sky, "no surface, no light: the sky alone")], sky=sky)
    level.camera("Camera", eye=(0, 1, 0), target=(0, 1, -1), fov_y_deg=60, aspect=1.0)
    return level


def nothing():
    level = level_of("nothing", [radiance("Camera", grey(0.0), "no surface, no light, a black sky")])
    level.camera("Camera", eye=(0, 1, 0), target=(0, 1, -1), fov_y_deg=60, aspect=1.0)
    return level


def closed_box():
    """Closed black room without a light, under a sky of radiance 50."""
    why = "no path leads from the sky into a closed box: exactly 0"
    level = level_of("closed_box", [radiance("Camera", grey(0.0), why)], sky=(50.0, 0.0, 50.0))
    level.place("box", inside_out(box((-1, 0, -1), (1, 2, 1))), level.material("wall", grey(0.8), lambert=True))
    level.camera("Camera", eye=(0.7, 1.2, 0.7), target=(-0.5, 0.5, -0.5), fov_y_deg=80, aspect=1.0)
    return level


def glass_before_light(name, truth, index, volume):
    """A slab of 0.1 m, seen straight, before an emitter."""
    level = level_of(name, [truth])
    glass = level.material("glass", grey(1.0), roughness=0.0, extensions={"KHR_materials_transmission": {"transmissionFactor": 1.0},
                           "KHR_materials_ior": {"ior": index}, "KHR_materials_volume": {"thicknessFactor": 0.1, **volume}})
    level.place("slab", box((-1, -1, -1.1), (1, 1, -1)), glass)
    level.place("emitter", quad((-1, -1, -2), (2, 0, 0), (0, 2, 0)), level.material("light", grey(0.0), emission=grey(1.0), lambert=True))
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=2, aspect=1.0)
    return level


def glass_slab():
    index = 1.5
    why = ("clear slab of index 1.5 before an emitter of radiance 1, all internal reflections, normal incidence: T = 2 eta / (eta^2 +"
           " 1) = 0.923077;"
           " the emitter reflects nothing, the sky is black")
    return glass_before_light("glass_slab", radiance("Camera", grey(2 * index / (index * index + 1)), why, 1e-4), index, {})


def glass_slab_tinted():
    index, tint = 1.5, (0.8, 0.5, 0.1)
    once = ((index - 1) / (index + 1))**2
    passes = [share**2 for share in tint]
    why = ("slab of index 1.5 and 0.1 m that lets 0.8, 0.5 and 0.1 through each 0.05 m, before an emitter of radiance 1, normal incidence:"
           " a pass leaves a = tint^2 (Beer), an interface reflects R = ((eta - 1) / (eta + 1))^2, so T = (1 - R)^2 a / (1 - R^2 a^2) with all"
           " internal reflections; the pixels' slant lengthens a pass by 5e-5 on average, which takes 2e-4 of the darkest")
    truth = radiance("Camera", [(1 - once)**2 * a / (1 - (once * a)**2) for a in passes], why, 3e-4)
    volume = {"attenuationColor": list(tint), "attenuationDistance": 0.05}
    return glass_before_light("glass_slab_tinted", truth, index, volume)


LEVELS = (furnace, furnace_bright, furnace_clutter, sphere_point_light, parallel_plates, turned_plates, mirror_corridor, uniform_sky,
          white_sky, triangle, empty, nothing, closed_box, glass_slab, glass_slab_tinted, portal, *lights.LEVELS, *air.LEVELS)


def write(folder):
    for level in LEVELS:
        level().write(folder / f"{level.__name__}.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
