"""Tiny levels whose answer is derived on paper and written into them.

Made by this script, no third-party content. The scene's extras hold `ag_truth`, a list of
  {"derivation": in words and formulas, "quantity": "radiance" or "irradiance", "value": [r, g, b], "relative_tolerance": t, and where:
   "camera": name        every pixel of that camera (radiance), or
   "position", "normal"  a point on a surface or in the air and the direction it faces (irradiance)}
The tolerance covers what the level itself approximates (a finite plate, a pixel's angle); a Monte Carlo estimate adds its own error."""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from algebra import subtract, turn
from gltf_writer import Level
from mesh import Shape, inside_out
from shapes import box, icosphere, quad


def grey(x):
    return [x, x, x]


def radiance(camera, value, derivation, tolerance=1e-5):
    return {"derivation": derivation, "quantity": "radiance", "camera": camera, "value": value, "relative_tolerance": tolerance}


def irradiance(position, normal, value, derivation, tolerance=1e-5):
    return {"derivation": derivation, "quantity": "irradiance", "position": position, "normal": normal, "value": value,
            "relative_tolerance": tolerance}


def level_of(name, truths, sky=(0.0, 0.0, 0.0), **extras):
    return Level(name, ag_sky_radiance=list(sky), ag_exposure_ev=0.0, ag_tone_curve="none", ag_truth=truths, **extras)


def furnace():
    """Closed icosahedron-like room, everything emits and reflects alike."""
    emission, albedo = 0.5, 0.5
    answer = emission / (1 - albedo)
    why = ("closed diffuse enclosure of any shape, emission Le = 0.5 and albedo rho = 0.5 everywhere: L = Le + rho L, so L = Le / (1"
           " - rho) = 1")
    level = level_of("furnace", [radiance("Camera", grey(answer), why),
                                 irradiance([0.1, 0.2, -0.3], [0, 1, 0], grey(math.pi * answer), why + "; E = pi L")])
    wall = level.material("wall", grey(albedo), emission=grey(emission), lambert=True)
    level.place("shell", inside_out(icosphere(1.0, 2)), wall)
    level.camera("Camera", eye=(0, 0, 0.2), target=(0, 0, -1), fov_y_deg=60, aspect=1.0)
    return level


def furnace_clutter():
    """The furnace with blocks standing in it: occlusion must not show."""
    why = "a furnace stays uniform whatever stands in it, if that too has Le = 0.1 and rho = 0.9: L = Le / (1 - rho) = 1"
    level = level_of("furnace_clutter", [radiance("Camera", grey(1.0), why)])
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


def parallel_plates():
    why = ("two parallel diffuse plates, plate 1 (below) emits L1 = 1, albedos 0.5 and 0.8: B1 = L1 + rho1 B2 and B2 = rho2 B1, so B1"
           " = L1 / (1 - rho1 rho2) = 5/3,"
           " B2 = 4/3. 400 m wide, 1 m apart: the open rim takes less than 1e-4 at the middle")
    level = level_of("parallel_plates", [radiance("CameraDown", grey(5 / 3), why, 1e-3), radiance("CameraUp", grey(4 / 3), why, 1e-3)])
    below = level.material("below", grey(0.5), emission=grey(1.0), lambert=True)
    above = level.material("above", grey(0.8), lambert=True)
    level.place("plate_below", quad((-200, 0, 200), (400, 0, 0), (0, 0, -400)), below, ag_texels_per_metre=0.2)
    level.place("plate_above", quad((-200, 1, -200), (400, 0, 0), (0, 0, 400)), above, ag_texels_per_metre=0.2)
    level.camera("CameraDown", eye=(0, 0.5, 0), target=(0, 0, 0), fov_y_deg=40, aspect=1.0)
    level.camera("CameraUp", eye=(0, 0.5, 0), target=(0, 1, 0), fov_y_deg=40, aspect=1.0)
    return level


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


def sun_plane():
    why = "directional light of irradiance 2 on a facing surface, 60 degrees from the vertical: E = 2 cos 60 = 1 on the plane"
    level = level_of("sun_plane", [irradiance([0.3, 0, -0.4], [0, 1, 0], grey(1.0), why),
                                   radiance("Camera", grey(0.6 / math.pi), why + "; an albedo of 0.6 sends out 0.6 E / pi")])
    level.place("plane", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("plane", grey(0.6), lambert=True))
    level.light("sun", "directional", (1.0, 1.0, 1.0), 2.0, towards=(math.sin(math.pi / 3), -0.5, 0), ag_bake="all")
    level.camera("Camera", eye=(0, 2, 0), target=(0, 0, 0), fov_y_deg=50, aspect=1.0)
    return level


def rectangle_light():
    factor = 0.138531606
    why = ("element below the corner of a parallel 1 x 1 rectangle at height 1, one quarter of a 2 x 2 one: F = [a/A atan(b/A) + b/B"
           " atan(a/B)] / (2 pi),"
           " a = b = 1, A = B = sqrt 2: 0.138531606; E = pi L F for each quarter, L = 2 (Howell B-3)")
    a = math.sqrt(2.0)
    exact = 2 * (1 / a) * math.atan(1 / a) / (2 * math.pi)
    assert abs(exact - factor) < 1e-9
    level = level_of("rectangle_light", [irradiance([0, 0, 0], [0, 1, 0], grey(4 * math.pi * 2.0 * exact), why)])
    level.place("floor", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("black", grey(0.0), lambert=True))
    level.place("light", quad((-1, 1, -1), (2, 0, 0), (0, 0, 2)), level.material("light", grey(0.0), emission=grey(2.0), lambert=True))
    level.camera("Camera", eye=(0, 0.6, 3), target=(0, 0.4, 0), fov_y_deg=50, aspect=1.0)
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


def fog_absorbing():
    why = ("a slab of 2 m that absorbs 0.6, 0.3 and 0.1 per metre before a sky of radiance 1: L = exp(-sigma d); a pixel's slant adds"
           " less than 1e-4")
    level = level_of("fog_absorbing", [radiance("Camera", [math.exp(-2 * s) for s in (0.6, 0.3, 0.1)], why, 1e-4)], sky=(1.0, 1.0, 1.0))
    air = level.material("air", grey(1.0))
    level.place("slab", box((-5, -5, -4), (5, 5, -2)), air, ag_fog_scattering=grey(0.0), ag_fog_absorption=[0.6, 0.3, 0.1], ag_fog_g=0.0)
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=0.5, aspect=1.0)
    return level


def level_in_fog(name, truth, absorption, **extras):
    """One matte plane, 10 m square, in fog that fills the level: the plane's box and a tenth of its diagonal, sqrt 2 m, on every side."""
    level = level_of(name, [truth], ag_fog_scattering=grey(0.0), ag_fog_absorption=grey(absorption), **extras)
    level.place("plane", quad((-5, 0, 5), (10, 0, 0), (0, 0, -10)), level.material("plane", grey(0.5), lambert=True))
    return level


def fog_sky():
    absorption, way = 0.1, 5 + math.sqrt(2)
    why = ("fog that absorbs 0.1 per metre fills a level of one plane, 10 m square, and a tenth of its diagonal around it: from the middle"
           " level with the plane, 5 m + sqrt 2 m of it lie before the sky of radiance 1, L = exp(-sigma d); a pixel's slant adds less than"
           " 1e-4")
    level = level_in_fog("fog_sky", radiance("Camera", grey(math.exp(-absorption * way)), why, 1e-4), absorption, sky=(1.0, 1.0, 1.0))
    level.camera("Camera", eye=(0, 0.5, 0), target=(0, 0.5, -1), fov_y_deg=0.5, aspect=1.0)
    return level


def fog_sun():
    absorption, way = 0.3, math.sqrt(2)
    why = ("fog that absorbs 0.3 per metre fills a level of one plane, 10 m square, and a tenth of its diagonal around it: a sun of"
           " irradiance 2 at the zenith crosses sqrt 2 m of it, E = 2 exp(-sigma d)")
    level = level_in_fog("fog_sun", irradiance([0.3, 0, -0.4], [0, 1, 0], grey(2 * math.exp(-absorption * way)), why), absorption)
    level.light("sun", "directional", (1.0, 1.0, 1.0), 2.0, towards=(0, -1, 0), ag_bake="all")
    return level


def fog_furnace():
    why = ("a medium that absorbs nothing, under a uniform sky of radiance 1: scattering exchanges equal for equal, L = 1 everywhere,"
           " whatever g and density")
    level = level_of("fog_furnace", [radiance("Camera", grey(1.0), why)], sky=(1.0, 1.0, 1.0))
    air = level.material("air", grey(1.0))
    level.place("cloud", box((-1, -1, -4), (1, 1, -2)), air, ag_fog_scattering=grey(1.5), ag_fog_absorption=grey(0.0), ag_fog_g=0.6)
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -3), fov_y_deg=60, aspect=1.0)
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


LEVELS = (furnace, furnace_clutter, sphere_point_light, parallel_plates, mirror_corridor, uniform_sky, sun_plane, rectangle_light, triangle,
          empty, nothing, closed_box, fog_absorbing, fog_sky, fog_sun, fog_furnace, glass_slab, glass_slab_tinted, portal)


def write(folder):
    for level in LEVELS:
        level().write(folder / f"{level.__name__}.glb")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
