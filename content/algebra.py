"""Vectors as tuples, rotations as quaternions (x, y, z, w): as much algebra as a level script needs."""
import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scaled(a, 1.0 / length(a))


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smoothstep(low, high, x):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def turn(axis, degrees):
    """Quaternion of a right-handed turn about a unit axis."""
    half = math.radians(degrees) / 2
    return (*scaled(axis, math.sin(half)), math.cos(half))


def combined(first, second):
    """The turn `first`, then `second`."""
    a, b = second, first
    xyz = add(add(scaled(b[:3], a[3]), scaled(a[:3], b[3])), cross(a[:3], b[:3]))
    return (*xyz, a[3] * b[3] - dot(a[:3], b[:3]))


def rotated(quaternion, vector):
    xyz, w = quaternion[:3], quaternion[3]
    t = scaled(cross(xyz, vector), 2.0)
    return add(add(vector, scaled(t, w)), cross(xyz, t))


def look_rotation(direction, up=(0, 1, 0)):
    """The turn that takes -z to `direction` and keeps `up` upwards: for cameras and lights."""
    back = scaled(unit(direction), -1.0)
    if abs(dot(back, up)) > 0.9999:
        up = (0, 0, -1)
    right = unit(cross(up, back))
    return quaternion_of(right, cross(back, right), back)


def quaternion_of(x, y, z):
    """Quaternion of the rotation whose columns are the unit vectors x, y, z (Shepperd's branches: the largest of w, x, y, z divides)."""
    trace = x[0] + y[1] + z[2]
    if trace > 0:
        s = 2 * math.sqrt(trace + 1)
        return ((y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4)
    if x[0] >= y[1] and x[0] >= z[2]:
        s = 2 * math.sqrt(1 + x[0] - y[1] - z[2])
        return (s / 4, (y[0] + x[1]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s)
    if y[1] >= z[2]:
        s = 2 * math.sqrt(1 + y[1] - x[0] - z[2])
        return ((y[0] + x[1]) / s, s / 4, (z[1] + y[2]) / s, (z[0] - x[2]) / s)
    s = 2 * math.sqrt(1 + z[2] - x[0] - y[1])
    return ((z[0] + x[2]) / s, (z[1] + y[2]) / s, s / 4, (x[1] - y[0]) / s)
