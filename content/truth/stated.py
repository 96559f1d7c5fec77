"""How a tiny level says its answer. The scene's extras hold `ag_truth`, a list of
  {"derivation": in words and formulas, "quantity": "radiance" or "irradiance", "value": [r, g, b], "relative_tolerance": t, and where:
   "camera": name        every pixel of that camera (radiance), or
   "position", "normal"  a point on a surface or in the air and the direction it faces (irradiance);
   "bounces", "scatterings"  where the answer is that of paths cut short: surfaces that scatter, collisions with media}
The tolerance covers what the level itself approximates (a finite plate, a pixel's angle); a Monte Carlo estimate adds its own error."""
from gltf_writer import Level


def grey(x):
    return [x, x, x]


def radiance(camera, value, derivation, tolerance=1e-5, **cut):
    return {"derivation": derivation, "quantity": "radiance", "camera": camera, "value": value, "relative_tolerance": tolerance, **cut}


def irradiance(position, normal, value, derivation, tolerance=1e-5):
    return {"derivation": derivation, "quantity": "irradiance", "position": position, "normal": normal, "value": value,
            "relative_tolerance": tolerance}


def level_of(name, truths, sky=(0.0, 0.0, 0.0), **extras):
    return Level(name, ag_sky_radiance=list(sky), ag_exposure_ev=0.0, ag_tone_curve="none", ag_truth=truths, **extras)
