"""The tiny levels of lights: what suns, lamps and a shining rectangle leave on a plane."""
import math

from shapes import quad
from stated import grey, irradiance, level_of, radiance


def plane_in_the_sun(name, truths, towards, **light):
    level = level_of(name, truths)
    level.place("plane", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("plane", grey(0.6), lambert=True))
    level.light("sun", "directional", (1.0, 1.0, 1.0), 2.0, towards=towards, ag_bake="all", **light)
    level.camera("Camera", eye=(0, 2, 0), target=(0, 0, 0), fov_y_deg=50, aspect=1.0)
    return level


def sun_plane():
    why = "directional light of irradiance 2 on a facing surface, 60 degrees from the vertical: E = 2 cos 60 = 1 on the plane"
    return plane_in_the_sun("sun_plane", [irradiance([0.3, 0, -0.4], [0, 1, 0], grey(1.0), why),
                                          radiance("Camera", grey(0.6 / math.pi), why + "; an albedo of 0.6 sends out 0.6 E / pi")],
                            (math.sin(math.pi / 3), -0.5, 0))


def sun_wide():
    why = "a sun 60 degrees wide at the zenith, of irradiance 2 on a facing surface: E = 2 on the plane, an albedo of 0.6 sends out 0.6 E / pi"
    return plane_in_the_sun("sun_wide", [radiance("Camera", grey(1.2 / math.pi), why)], (0, -1, 0), ag_sun_angle_deg=60.0)


def lamps():
    """Plates under lamps of their own, 100 m apart."""
    albedo, away, inner, between, outer = 0.6, 100.0, *map(math.radians, (10, 15, 20))
    edge = ((math.cos(between) - math.cos(outer)) / (math.cos(inner) - math.cos(outer)))**2
    why = "on the axis of a lamp of intensity I at the distance d E = I / d^2, %s; an albedo of 0.6 sends out 0.6 E / pi"
    level = level_of("lamps", [
        radiance("Camera", grey(albedo / math.pi * 2.0 / 0.8**2), why % "of a point", 2e-3),
        radiance("CameraSphere", grey(albedo / math.pi * 1.0 / 0.7**2), why % "of a sphere of radius 0.6 above the horizon too", 2e-3),
        radiance("CameraSpot", grey(albedo / math.pi * 3.0), why % "within the inner cone of a spot", 2e-3),
        radiance("CameraEdge", grey(albedo / math.pi * 3.0 * edge * math.cos(between)**3), "1 m below a spot of 10 and 20 degrees, at 15: E = I"
                 " cos^3 of it, times glTF's falloff ((cos - cos 20) / (cos 10 - cos 20))^2", 5e-3)])
    matte = level.material("matte", grey(albedo), lambert=True)
    for k in range(3):
        level.place(f"plate_{k}", quad((away * k - 2, 0, 2), (4, 0, 0), (0, 0, -4)), matte)
    level.light("point", "point", (1.0, 1.0, 1.0), 2.0, at=(0, 0.8, 0), ag_bake="all")
    level.light("sphere", "point", (1.0, 1.0, 1.0), 1.0, at=(away, 0.7, 0), ag_radius_m=0.6, ag_bake="all")
    level.light("spot", "spot", (1.0, 1.0, 1.0), 3.0, at=(2 * away, 1, 0), cone_deg=(10, 20), ag_bake="all")
    for name, x, z in (("Camera", 0, 0), ("CameraSphere", away, 0), ("CameraSpot", 2 * away, 0), ("CameraEdge", 2 * away, math.tan(between))):
        level.camera(name, eye=(x, 0.05, z + 0.1), target=(x, 0, z), fov_y_deg=1, aspect=1.0)
    return level


def blackbody_color(kelvin):
    """Linear Rec.709 of luminance 1: Planck's law by the multi-lobe fit of the CIE 1931 observer (Wyman, Sloan & Shirley 2013), by 1 nm."""
    lobes = (((0.362, 442.0, 0.0624, 0.0374), (1.056, 599.8, 0.0264, 0.0323), (-0.065, 501.1, 0.0490, 0.0382)),
             ((0.821, 568.8, 0.0213, 0.0247), (0.286, 530.9, 0.0613, 0.0322)), ((1.217, 437.0, 0.0845, 0.0278), (0.681, 459.0, 0.0385, 0.0725)))
    xyz = [0.0, 0.0, 0.0]
    for nm in range(360, 831):
        power = (nm / 1e3)**-5 / math.expm1(14387.76877 / (nm / 1e3 * kelvin))
        for axis, of_axis in enumerate(lobes):
            for height, centre, below, above in of_axis:
                xyz[axis] += power * height * math.exp(-0.5 * ((nm - centre) * (below if nm < centre else above))**2)
    x, y, z = (value / xyz[1] for value in xyz)
    return [3.2409699419 * x - 1.5373831776 * y - 0.4986107603 * z, -0.9692436363 * x + 1.8759675015 * y + 0.0415550574 * z,
            0.0556300797 * x - 0.2039769589 * y + 1.0569715142 * z]


def lamp_plane():
    kelvin = 2856
    why = ("a lamp of 3 white units of intensity 1 m above a plane of albedo 0.5, that says 2856 K: a black body's colour c, of luminance 1 in"
           " linear Rec.709, with the luminance of 3 that it had: E = 3 c under it, L = 0.5 E / pi; the pixels' slant takes 1e-5")
    level = level_of("lamp_plane", [radiance("Camera", [0.5 * 3 / math.pi * c for c in blackbody_color(kelvin)], why, 1e-4)])
    level.place("plane", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("plane", grey(0.5), lambert=True))
    level.light("lamp", "point", (1.0, 1.0, 1.0), 3.0, at=(0, 1, 0), ag_kelvin=kelvin, ag_bake="all")
    level.camera("Camera", eye=(0, 2, 0), target=(0, 0, 0), fov_y_deg=0.2, aspect=1.0)
    return level


def rectangle_light():
    factor = 0.138531606
    why = ("element below the corner of a parallel 1 x 1 rectangle at height 1, one quarter of a 2 x 2 one: F = [a/A atan(b/A) + b/B"
           " atan(a/B)] / (2 pi),"
           " a = b = 1, A = B = sqrt 2: 0.138531606; E = pi L F for each quarter, L = 2 (Howell B-3)")
    a = math.sqrt(2.0)
    exact = 2 * (1 / a) * math.atan(1 / a) / (2 * math.pi)
    assert abs(exact - factor) < 1e-9
    level = level_of("rectangle_light", [irradiance([0, 0, 0], [0, 1, 0], grey(4 * math.pi * 2.0 * exact), why),
                                         radiance("CameraSpot", grey(0.5 * 4 * 2.0 * exact), why + "; an albedo of 0.5 sends out 0.5 E / pi"
                                                  ", and the light reflects nothing", 1e-3)])
    level.place("floor", quad((-2, 0, 2), (4, 0, 0), (0, 0, -4)), level.material("grey", grey(0.5), lambert=True))
    level.place("light", quad((-1, 1, -1), (2, 0, 0), (0, 0, 2)), level.material("light", grey(0.0), emission=grey(2.0), lambert=True))
    level.camera("Camera", eye=(0, 0.6, 3), target=(0, 0.4, 0), fov_y_deg=50, aspect=1.0)
    level.camera("CameraSpot", eye=(0, 0.5, 1), target=(0, 0, 0), fov_y_deg=1, aspect=1.0)
    return level


LEVELS = (sun_plane, sun_wide, lamps, lamp_plane, rectangle_light)
