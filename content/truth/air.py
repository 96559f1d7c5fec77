"""The tiny levels of air: what media leave of light and what they scatter, once and by all orders, in bodies and without end."""
import math

from mesh import inside_out
from shapes import box, icosphere, quad
from stated import grey, irradiance, level_of, radiance

WHITE = (1.0, 1.0, 1.0)
FAR = 5000.0  # m: half of the width of what is meant to be endless, thousands of free flights


def cloud(level, name, lower, upper, scattering, absorption, g=0.0, **extras):
    """A box of air; coefficients in 1/m."""
    level.place(name, box(lower, upper), level.material(name, grey(1.0)), ag_fog_scattering=list(scattering),
                ag_fog_absorption=list(absorption), ag_fog_g=g, **extras)


def slanted(level, name, height, cosine, pixels_deg=0.01):
    """A camera at that height that looks down (cosine < 0) or up at an angle to the vertical."""
    level.camera(name, eye=(0, height, 0), target=(0, height + cosine, -math.sqrt(1 - cosine * cosine)), fov_y_deg=pixels_deg, aspect=1.0,
                 up=(0, 0, 1))


def fog_absorbing():
    why = ("a slab of 2 m that absorbs 0.6, 0.3 and 0.1 per metre before a sky of radiance 1: L = exp(-sigma d); a pixel's slant adds"
           " less than 1e-4")
    level = level_of("fog_absorbing", [radiance("Camera", [math.exp(-2 * s) for s in (0.6, 0.3, 0.1)], why, 1e-4)], sky=WHITE)
    air = level.material("air", grey(1.0))
    level.place("slab", box((-5, -5, -4), (5, 5, -2)), air, ag_fog_scattering=grey(0.0), ag_fog_absorption=[0.6, 0.3, 0.1], ag_fog_g=0.0)
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=0.5, aspect=1.0)
    return level


def level_in_fog(name, truths, absorption, **extras):
    """One matte plane, 10 m square, in fog that fills the level: the plane's box and a tenth of its diagonal, sqrt 2 m, on every side."""
    level = level_of(name, truths, ag_fog_scattering=grey(0.0), ag_fog_absorption=grey(absorption), **extras)
    level.place("plane", quad((-5, 0, 5), (10, 0, 0), (0, 0, -10)), level.material("plane", grey(0.5), lambert=True))
    return level


def fog_sky():
    absorption, way = 0.1, 5 + math.sqrt(2)
    why = ("fog that absorbs 0.1 per metre fills a level of one plane, 10 m square, and a tenth of its diagonal around it: from the middle"
           " level with the plane, 5 m + sqrt 2 m of it lie before the sky of radiance 1, L = exp(-sigma d); a pixel's slant adds less than"
           " 1e-4")
    level = level_in_fog("fog_sky", [radiance("Camera", grey(math.exp(-absorption * way)), why, 1e-4)], absorption, sky=WHITE)
    level.camera("Camera", eye=(0, 0.5, 0), target=(0, 0.5, -1), fov_y_deg=0.5, aspect=1.0)
    return level


def fog_sun():
    absorption, way = 0.3, math.sqrt(2)
    why = ("fog that absorbs 0.3 per metre fills a level of one plane, 10 m square, and a tenth of its diagonal around it: a sun of"
           " irradiance 2 at the zenith crosses sqrt 2 m of it, E = 2 exp(-sigma d)")
    lit = 2 * math.exp(-absorption * way)
    seen = 0.5 / math.pi * lit * math.exp(-absorption)
    level = level_in_fog("fog_sun", [irradiance([0.3, 0, -0.4], [0, 1, 0], grey(lit), why),
                                     radiance("Camera", grey(seen), why + "; an albedo of 0.5 sends out 0.5 E / pi, dimmed by 1 m", 1e-4)],
                         absorption)
    level.light("sun", "directional", (1.0, 1.0, 1.0), 2.0, towards=(0, -1, 0), ag_bake="all")
    level.camera("Camera", eye=(0, 1, 0), target=(0, 0, 0), fov_y_deg=0.5, aspect=1.0)
    return level


def fog_furnace():
    why = ("a medium that absorbs nothing, under a uniform sky of radiance 1: scattering exchanges equal for equal, L = 1 everywhere,"
           " whatever g and density, of each colour its own")
    level = level_of("fog_furnace", [radiance("Camera", grey(1.0), why)], sky=WHITE)
    air = level.material("air", grey(1.0))
    level.place("cloud", box((-1, -1, -4), (1, 1, -2)), air, ag_fog_scattering=[0.5, 1.5, 4.0], ag_fog_absorption=grey(0.0), ag_fog_g=0.6)
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -3), fov_y_deg=60, aspect=1.0)
    return level


def fog_room():
    why = ("the furnace, Le = 0.5 and rho = 0.5, full of air that scatters without loss: what arrives anywhere from anywhere is still L = Le"
           " / (1 - rho) = 1")
    level = level_of("fog_room", [radiance("Camera", grey(1.0), why)], ag_fog_scattering=[0.3, 1.0, 3.0], ag_fog_absorption=grey(0.0),
                     ag_fog_g=-0.5)
    wall = level.material("wall", grey(0.5), emission=grey(0.5), lambert=True)
    level.place("shell", inside_out(icosphere(1.0, 2)), wall)
    level.camera("Camera", eye=(0, 0, 0.2), target=(0, 0, -1), fov_y_deg=60, aspect=1.0)
    return level


def fog_glow():
    emission, absorption = (1.0, 1.0, 0.5), (0.5, 1.0, 0.25)
    why = "endless air that sends out e and swallows sigma_a per metre: L = e / sigma_a, whatever it scatters"
    level = level_of("fog_glow", [radiance("Camera", [e / a for e, a in zip(emission, absorption)], why)])
    cloud(level, "air", (-99, -99, -99), (99, 99, 99), (2.0, 0.5, 1.0), absorption, 0.3, ag_fog_emission=list(emission))
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=60, aspect=1.0)
    return level


def fog_transmittance():
    through = math.exp(-0.1 * 7.0)
    why = "a body of air of depth d before a sky of radiance 1, nothing scattered into the way: L = exp(-sigma_t d)"
    level = level_of("fog_transmittance", [
        radiance("Camera", grey(through), why + ", sigma_t d = 0.1 * 7; paths end where they collide", 1e-5, scatterings=0),
        radiance("CameraWall", grey(0.0), why + ", of 1e6: nothing"), radiance("CameraHaze", grey(1.0), why + ", of 1e-11: all")], sky=WHITE)
    cloud(level, "mist", (-5, -5, -8), (5, 5, -1), grey(0.06), grey(0.04))
    cloud(level, "wall", (1, -5, 10), (2, 5, 20), grey(0.0), grey(1e6))
    cloud(level, "haze", (-11, -5, 10), (-1, 5, 20), grey(0.0), grey(1e-12))
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=0.1, aspect=1.0)
    level.camera("CameraWall", eye=(0, 0, 15), target=(1, 0, 15), fov_y_deg=1, aspect=1.0)
    level.camera("CameraHaze", eye=(0, 0, 15), target=(-1, 0, 15), fov_y_deg=1, aspect=1.0)
    return level


def henyey_greenstein(g, cosine):
    return (1 - g * g) / (4 * math.pi * (1 + g * g - 2 * g * cosine)**1.5)


def fog_beam():
    scattering, absorption, g, cosine, length = (0.08, 0.16, 0.04), (0.02, 0.04, 0.06), 0.5, 0.3, 30.0
    why = ("a thread of air, 30 m long and 8 mm wide, seen along itself in a sun of irradiance pi whose light crosses too little of it to be"
           " dimmed: L = sigma_s / sigma_t p(cos, g) E0 (1 - exp(-sigma_t d)); 4 mm take 4e-4 of the light, 8e-4 where it is densest")
    value = [s / (s + a) * henyey_greenstein(g, cosine) * math.pi * -math.expm1(-(s + a) * length) for s, a in zip(scattering, absorption)]
    level = level_of("fog_beam", [radiance("Camera", value, why, 1e-3)])
    cloud(level, "thread", (-0.004, -0.004, -length), (0.004, 0.004, 0), scattering, absorption, g)
    level.light("sun", "directional", WHITE, math.pi, towards=(math.sqrt(1 - cosine * cosine), 0, cosine), ag_bake="all")
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=0.006, aspect=1.0)
    return level


def slab_once(name, to_sun, scattering, absorption):
    """A slab of 1 m without an end, in a sun of irradiance pi at the cosine `to_sun`, seen from both sides at the cosine 0.5."""
    mu, mu0 = 0.5, to_sun
    back, on = [], []
    for s, a in zip(scattering, absorption):
        tau = s + a
        lit = s / tau / (4 * math.pi) * math.pi
        back.append(lit * mu0 / (mu + mu0) * -math.expm1(-tau * (1 / mu + 1 / mu0)))
        on.append(lit * tau / mu * math.exp(-tau / mu) if mu == mu0 else lit * mu0 / (mu0 - mu) * (math.exp(-tau / mu0) - math.exp(-tau / mu)))
    why = "single scattering of a plane-parallel slab (Chandrasekhar 1960), w = sigma_s / sigma_t, isotropic, E0 = pi: "
    level = level_of(name, [
        radiance("Camera", back, why + "w p E0 mu0 / (mu + mu0) (1 - exp(-tau (1 / mu + 1 / mu0))) goes back", 1e-4, scatterings=1),
        radiance("CameraBelow", on, why + "w p E0 mu0 / (mu0 - mu) (exp(-tau / mu0) - exp(-tau / mu)) goes on, at mu = mu0 its limit", 1e-4,
                 scatterings=1)])
    cloud(level, "slab", (-FAR, -1, -FAR), (FAR, 0, FAR), scattering, absorption)
    level.light("sun", "directional", WHITE, math.pi, towards=(math.sqrt(1 - mu0 * mu0), -mu0, 0), ag_bake="all")
    slanted(level, "Camera", 2, -mu)
    slanted(level, "CameraBelow", -3, mu)
    return level


def fog_slab():
    return slab_once("fog_slab", 0.8, (0.9, 0.45, 1.6), (0.1, 0.05, 0.4))


def fog_slab_even():
    return slab_once("fog_slab_even", 0.5, (0.9, 0.3, 1.0), (0.1, 0.7, 0.0))


def airlight(sigma_s, sigma_t, along, beside, length, g, steps=20000):
    """int_0^D sigma_s p(cos) exp(-sigma_t (x + r)) / r^2 dx of a lamp of intensity 1, by x = s + h tan(a): smooth, so the midpoint rule."""
    first, last = math.atan(-along / beside), math.atan((length - along) / beside)
    total = 0.0
    for k in range(steps):
        a = first + (last - first) * (k + 0.5) / steps
        total += henyey_greenstein(g, -math.sin(a)) * math.exp(-sigma_t * (along + beside * math.tan(a) + beside / math.cos(a)))
    return sigma_s * total * (last - first) / steps / beside


def about_a_lamp(name, sigma_s, sigma_t, beside, g):
    why = ("20 m of air, a lamp of intensity 1 beside the ray at 5 m, single scattering, dimmed both ways: int sigma_s p(cos) exp(-sigma_t (x"
           " + r)) / r^2 dx (Pegoraro and Parker 2009), by quadrature in the angle at the lamp")
    value = airlight(sigma_s, sigma_t, 5.0, beside, 20.0, g)
    level = level_of(name, [radiance("Camera", grey(value), why, 1e-3, scatterings=1)])
    cloud(level, "air", (-99, -99, -20), (99, 99, 99), grey(sigma_s), grey(sigma_t - sigma_s), g)
    level.light("lamp", "point", WHITE, 1.0, at=(beside, 0, -5), ag_bake="all")
    level.camera("Camera", eye=(0, 0, 0), target=(0, 0, -1), fov_y_deg=0.006, aspect=1.0)
    return level


def fog_lamp():
    return about_a_lamp("fog_lamp", 0.08, 0.1, 2.0, 0.0)


def fog_lamp_forward():
    return about_a_lamp("fog_lamp_forward", 0.08, 0.1, 2.0, 0.7)


def fog_lamp_near():
    return about_a_lamp("fog_lamp_near", 0.01, 0.01, 0.01, 0.9)


def fog_lamp_thin():
    return about_a_lamp("fog_lamp_thin", 1e-6, 1e-6, 2.0, 0.0)


def under_a_white_sky(name, depth, scattering, absorption, views):
    """A layer of air without an end, over a black floor under a sky of radiance 1. `views`: camera's name, cosine, value, derivation; what
    arrives at the cosine mu from such a sky is the share of a beam of that cosine that gets there the other way round."""
    level = level_of(name, [radiance(camera, value, why, 5e-4) for camera, _, value, why in views], sky=WHITE)
    cloud(level, "layer", (-FAR, -depth, -FAR), (FAR, 0, FAR), scattering, absorption)
    floor = level.material("black", grey(0.0), lambert=True)
    level.place("floor", quad((-FAR, -depth - 1, FAR), (2 * FAR, 0, 0), (0, 0, -2 * FAR)), floor)
    for camera, cosine, _, _ in views:
        slanted(level, camera, -depth - 0.5 if camera.endswith("Below") else 1.0, cosine if camera.endswith("Below") else -cosine)
    return level


def fog_layer(name="fog_layer", albedo=1.0, depth=1.0, cosine=1.0, shares=(0.3413288, 0.6586712)):
    why = "a slab of optical depth %g and albedo %g, isotropic, all orders, by the integral equation of its source function: " % (depth, albedo)
    return under_a_white_sky(name, depth, grey(albedo), grey(1.0 - albedo),
                             [("Camera", cosine, grey(shares[0]), why + "of a beam this share goes back"),
                              ("CameraBelow", cosine, grey(shares[1]), why + "of a beam this share gets through, unscattered or not")])


def fog_layer_dim():
    return fog_layer("fog_layer_dim", 0.8, 2.0, 0.5, (0.3571388, 0.1491755))


def chandrasekhar_h(albedo, cosine, steps=20000):
    """exp(-mu / pi int_0^inf ln(1 - w atan(t) / t) / (1 + mu^2 t^2) dt), by t = tan(b)."""
    total = 0.0
    for k in range(steps):
        t = math.tan(math.pi / 2 * (k + 0.5) / steps)
        total += math.log(1 - albedo * math.atan(t) / t) * (1 + t * t) / (1 + cosine * cosine * t * t)
    return math.exp(-cosine / math.pi * total * math.pi / 2 / steps)


def fog_half_space():
    albedo, extinction = (0.9, 0.5, 0.99), (1.0, 2.0, 0.5)
    why = "endlessly deep air, isotropic: 1 - sqrt(1 - w) H(mu) of a beam goes back, H of Chandrasekhar"
    views = [(camera, mu, [1 - math.sqrt(1 - w) * chandrasekhar_h(w, mu) for w in albedo], why)
             for camera, mu in (("Camera", 1.0), ("CameraSlanted", 0.5))]
    return under_a_white_sky("fog_half_space", 200.0, [w * e for w, e in zip(albedo, extinction)],
                             [(1 - w) * e for w, e in zip(albedo, extinction)], views)


def fog_thick():
    depth, extrapolation = 10.0, 0.7104460896
    why = ("air that absorbs nothing, thick, isotropic: H(mu) / (sqrt 3 (tau + 2 q)) of a beam gets through, H(1) = 2.90781053 and Milne's"
           " q = 0.71044609, but for exp(-tau)")
    value = 2.90781053 / (math.sqrt(3) * (depth + 2 * extrapolation))
    return under_a_white_sky("fog_thick", depth, grey(1.0), grey(0.0), [("CameraBelow", 1.0, grey(value), why)])


def fog_height(name="fog_height", slope=0.5):
    """Air that thins with height, in layers that are as dense as it is in the mean: through whole ones the depth is the integral's."""
    ground, scale, first, far = 0.1, 10.0, 2.0, 30.0
    k = slope * far / scale
    depth = ground * math.exp(-first / scale) * far * (-math.expm1(-k) / k if k else 1.0)
    why = ("a sun of irradiance pi before a wall of albedo 0.5, and between them 30 m of air of extinction 0.1 exp(-y / H), H = 10 m, from y ="
           " 2 m at the slope dy = %g: L = 0.5 exp(-depth), depth = 0.1 exp(-0.2) D (1 - exp(-k)) / k, k = dy D / H" % slope)
    level = level_of(name, [radiance("Camera", grey(0.5 * math.exp(-depth)), why, bounces=0)])
    thickness = 1.0 if slope else 0.02  # m; what goes level stays in the middle of one, and what rises or falls ends with the last
    rim = 1.0 if slope else 0.0
    for n in range(round(max(abs(slope) * far, thickness) / thickness)):
        low = first + thickness * (n if slope > 0 else -n - 1 if slope < 0 else -0.5)
        mean = ground * scale * (math.exp(-low / scale) - math.exp(-(low + thickness) / scale)) / thickness
        cloud(level, f"layer_{n}", (-rim, low, -1), (far + rim, low + thickness, 1), grey(0.0), grey(mean))
    way = (math.sqrt(1 - slope * slope), slope, 0.0)

    def before(metres):
        return [-metres * way[0], first - metres * way[1], 0.0]

    x, y, _ = before(0.6)
    wall = level.material("wall", grey(0.5), lambert=True)
    level.place("wall", quad((x + 0.1 * slope, y - 0.1 * way[0], -0.1), (-0.2 * slope, 0.2 * way[0], 0), (0, 0, 0.2)), wall)
    level.light("sun", "directional", WHITE, math.pi, towards=[-c for c in way], ag_bake="all")
    level.camera("Camera", eye=before(0.3), target=before(0.6), fov_y_deg=1, aspect=1.0)
    return level


def fog_height_level():
    return fog_height("fog_height_level", 0.0)


def fog_height_falling():
    return fog_height("fog_height_falling", -0.3)


LEVELS = (fog_absorbing, fog_sky, fog_sun, fog_furnace, fog_room, fog_glow, fog_transmittance, fog_beam, fog_slab, fog_slab_even, fog_lamp,
          fog_lamp_forward, fog_lamp_near, fog_lamp_thin, fog_layer, fog_layer_dim, fog_half_space, fog_thick, fog_height, fog_height_level,
          fog_height_falling)
