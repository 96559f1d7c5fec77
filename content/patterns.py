"""Pictures computed pixel by pixel: tileable noise, colour and normal maps. Colours are sRGB 0..1, u to the right, v downwards, 0..1."""
import math
import random

from png import png


class Noise:
    """Smooth value noise on a lattice that repeats after `period` cells: tiles seamlessly over 0 <= u, v < 1 at period cells."""

    def __init__(self, seed, size=64):
        source = random.Random(seed)  # random() of a seeded Random is the same in every Python 3
        self.size = size
        self.table = [[source.random() for _ in range(size)] for _ in range(size)]

    def at(self, x, y, period_x, period_y):
        column, row = math.floor(x), math.floor(y)
        fx, fy = x - column, y - row
        fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        upper, lower = self.table[row % period_y % self.size], self.table[(row + 1) % period_y % self.size]
        c0, c1 = column % period_x % self.size, (column + 1) % period_x % self.size
        top = upper[c0] + (upper[c1] - upper[c0]) * fx
        return top + (lower[c0] + (lower[c1] - lower[c0]) * fx - top) * fy

    def sum(self, u, v, cells_x, cells_y, octaves):
        """Octaves of halved size and weight, mean 1/2; cells count along one tile."""
        total = weight = 0.0
        share = 0.5
        for _ in range(octaves):
            total += share * self.at(u * cells_x, v * cells_y, cells_x, cells_y)
            weight += share
            share, cells_x, cells_y = share / 2, cells_x * 2, cells_y * 2
        return total / weight


def byte(x):
    return 0 if x <= 0 else 255 if x >= 1 else int(x * 255 + 0.5)


def picture(width, height, color_at):
    """color_at(u, v) gives a tuple of 3 or 4 channels at each pixel's centre."""
    return png([[tuple(map(byte, color_at((x + 0.5) / width, (y + 0.5) / height))) for x in range(width)] for y in range(height)])


def heights(width, height, height_at):
    """height_at(u, v): metres."""
    return [[height_at((x + 0.5) / width, (y + 0.5) / height) for x in range(width)] for y in range(height)]


def normal_map(field, tile):
    """Of a height field that repeats every `tile` metres. glTF: x along u, y towards the top of the picture, z out."""
    rows, columns = len(field), len(field[0])
    across, down = 2 * tile / columns, 2 * tile / rows  # the metres that a central difference spans
    def normal(x, y):
        slope_x = (field[y][(x + 1) % columns] - field[y][x - 1]) / across
        slope_y = (field[(y + 1) % rows][x] - field[y - 1][x]) / down
        inverse = 1 / math.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
        return tuple(byte(0.5 + 0.5 * n * inverse) for n in (-slope_x, slope_y, 1))
    return png([[normal(x, y) for x in range(columns)] for y in range(rows)])


def blend(a, b, t):
    t = min(1.0, max(0.0, t))
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t)


def ramp(stops, x):
    """Colour at x along (position, colour) stops."""
    for (low, below), (high, above) in zip(stops, stops[1:]):
        if x <= high:
            return blend(below, above, (x - low) / (high - low))
    return stops[-1][1]
