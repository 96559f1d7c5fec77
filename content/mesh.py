"""A triangle mesh and what can be done with any: join, move, turn inside out, facet, smooth; and the grid that most shapes are made of.

Faces run counter-clockwise seen from outside; uvs count texture tiles, v grows downwards as in glTF; metres."""
from algebra import add, cross, length, rotated, scaled, subtract, unit


class Shape:
    """Vertices as three parallel lists, faces as index triples. Empty `normals`: flat; empty `uvs`: untextured."""

    def __init__(self, positions=(), normals=(), uvs=(), faces=()):
        self.positions, self.normals, self.uvs, self.faces = list(positions), list(normals), list(uvs), list(faces)


def joined(*shapes):
    whole = Shape()
    for shape in shapes:
        first = len(whole.positions)
        whole.positions += shape.positions
        whole.normals += shape.normals
        whole.uvs += shape.uvs
        whole.faces += [(a + first, b + first, c + first) for a, b, c in shape.faces]
    return whole


def moved(shape, by=(0, 0, 0), turn=(0, 0, 0, 1), scale=(1, 1, 1)):
    """Scaled, then turned, then moved."""
    positions = [add(by, rotated(turn, (p[0] * scale[0], p[1] * scale[1], p[2] * scale[2]))) for p in shape.positions]
    normals = [rotated(turn, unit((n[0] / scale[0], n[1] / scale[1], n[2] / scale[2]))) for n in shape.normals]
    return Shape(positions, normals, shape.uvs, shape.faces)


def inside_out(shape):
    return Shape(shape.positions, [scaled(n, -1.0) for n in shape.normals], shape.uvs, [(a, c, b) for a, b, c in shape.faces])


def faceted(shape):
    """Every face its own three vertices and its own normal."""
    flat = Shape()
    for face in shape.faces:
        corners = [shape.positions[i] for i in face]
        normal = unit(cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0])))
        flat.faces.append(tuple(range(len(flat.positions), len(flat.positions) + 3)))
        flat.positions += corners
        flat.normals += [normal] * 3
        flat.uvs += [shape.uvs[i] for i in face] if shape.uvs else []
    return flat


def smooth(shape):
    """Normals as the area-weighted mean of the faces that meet at a place, across seams of uv."""
    def place(position):
        return tuple(round(x, 5) for x in position)
    sums = {}
    for a, b, c in shape.faces:
        pa, pb, pc = shape.positions[a], shape.positions[b], shape.positions[c]
        area = cross(subtract(pb, pa), subtract(pc, pa))
        for p in (pa, pb, pc):
            sums[place(p)] = add(sums.get(place(p), (0, 0, 0)), area)
    shape.normals = [unit(sums[place(p)]) for p in shape.positions]
    return shape


def surface(point, columns, rows, tiles=(1, 1)):
    """The smooth grid point(u, v), 0 <= u, v <= 1, with v towards the texture's top; the outside is where u turns left into v."""
    shape = Shape()
    for row in range(rows + 1):
        for column in range(columns + 1):
            u, v = column / columns, row / rows
            shape.positions.append(tuple(point(u, v)))
            shape.uvs.append((u * tiles[0], (1 - v) * tiles[1]))
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            shape.faces += [face for face in ((a, b, c), (a, c, d)) if area(shape, face) > 1e-10]
    return smooth(without_strays(shape))


def area(shape, face):
    a, b, c = (shape.positions[i] for i in face)
    return length(cross(subtract(b, a), subtract(c, a))) / 2


def without_strays(shape):
    """Drops vertices that no face uses, such as the first of a pole."""
    used = sorted({i for face in shape.faces for i in face})
    place = {old: new for new, old in enumerate(used)}
    def pick(rows):
        return [rows[i] for i in used] if rows else []
    return Shape(pick(shape.positions), pick(shape.normals), pick(shape.uvs), [tuple(place[i] for i in face) for face in shape.faces])
