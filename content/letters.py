"""Capital letters as strokes, for bent neon tubes: unit height, corners rounded as glass would bend."""
import math

from algebra import add, dot, length, scaled, subtract, unit


def arc(x, y, rx, ry, start, end, pieces=20):
    angles = [math.radians(start + (end - start) * k / pieces) for k in range(pieces + 1)]
    return [(x + rx * math.cos(a), y + ry * math.sin(a), 0.0) for a in angles]


def line(*points):
    return [(x, y, 0.0) for x, y in points]


# letter: (width, strokes); a stroke is (points, corner radius)
STROKES = {
    "A": (0.72, [(line((0, 0), (0.36, 1), (0.72, 0)), 0.05), (line((0.14, 0.33), (0.58, 0.33)), 0)]),
    "E": (0.52, [(line((0.52, 0), (0, 0), (0, 1), (0.52, 1)), 0.08), (line((0.06, 0.52), (0.44, 0.52)), 0)]),
    "F": (0.50, [(line((0, 0), (0, 1), (0.50, 1)), 0.08), (line((0.06, 0.52), (0.42, 0.52)), 0)]),
    "G": (0.76, [(arc(0.38, 0.5, 0.38, 0.5, 48, 330, 40) + line((0.73, 0.44), (0.44, 0.44)), 0)]),
    "L": (0.46, [(line((0, 1), (0, 0), (0.46, 0)), 0.08)]),
    "O": (0.80, [(arc(0.40, 0.5, 0.40, 0.5, 95, 445, 48), 0)]),
    "R": (0.58, [(line((0, 0), (0, 1), (0.30, 1)) + arc(0.30, 0.74, 0.26, 0.26, 84, -90, 20) + line((0.06, 0.48)), 0.06),
                 (line((0.28, 0.42), (0.58, 0)), 0)]),
    "T": (0.60, [(line((0, 1), (0.60, 1)), 0), (line((0.30, 0.94), (0.30, 0)), 0)]),
    "W": (0.98, [(line((0, 1), (0.25, 0), (0.49, 0.8), (0.73, 0), (0.98, 1)), 0.05)]),
}


def strokes(text, height, gap):
    """Polylines of a line of text in the xy plane, centred on x = 0, standing on y = 0; `gap`: between letters, in letter heights."""
    width = sum(STROKES[letter][0] + gap for letter in text) - gap
    x = -width / 2
    lines = []
    for letter in text:
        advance, letter_strokes = STROKES[letter]
        for points, radius in letter_strokes:
            bent = bend(points, radius) if radius else points
            lines.append([scaled(add(p, (x, 0, 0)), height) for p in bent])
        x += advance + gap
    return lines


def bend(points, radius, pieces=6):
    """The polyline with each sharp corner replaced by a parabola that leaves it `radius` before and after."""
    bent = [points[0]]
    for before, corner, after in zip(points, points[1:], points[2:]):
        back, on = subtract(before, corner), subtract(after, corner)
        reach = min(radius, 0.45 * length(back), 0.45 * length(on))
        if dot(unit(back), unit(on)) < -0.9:  # nearly straight: already part of an arc
            bent.append(corner)
            continue
        start, end = add(corner, scaled(unit(back), reach)), add(corner, scaled(unit(on), reach))
        for k in range(pieces + 1):
            t = k / pieces
            bent.append(add(scaled(start, (1 - t) ** 2), add(scaled(corner, 2 * t * (1 - t)), scaled(end, t * t))))
    return bent + [points[-1]]
