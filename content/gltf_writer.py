"""Writes a level as one .glb: nodes, meshes, materials, pictures, cameras, lights, and the `ag_` extras of Afterglow.

Python's own library only. Same input, same bytes: every number is rounded before it is packed, so that the last bit of a machine's
sin() never reaches the file. Metres, +Y up, linear Rec.709; light units are radiometric (see asset.extras)."""
import json
import math
import struct

from algebra import look_rotation, subtract

ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963
UNSIGNED_SHORT, UNSIGNED_INT, FLOAT = 5123, 5125, 5126


class Level:
    """One glTF scene under construction; every method returns the index that later calls refer to."""

    def __init__(self, name, **extras):
        self.bytes = bytearray()
        self.lights = []
        self.json = {
            "asset": {"version": "2.0", "generator": "Afterglow content scripts",
                      "extras": {"light_units": "W/sr, W/m2, W/(m2 sr), linear Rec.709"}},
            "scene": 0,
            "scenes": [{"name": name, "nodes": [], **with_extras(extras)}],
        }

    def append(self, kind, thing):
        things = self.json.setdefault(kind, [])
        things.append(thing)
        return len(things) - 1

    def view(self, data, target=None):
        """A range of the binary chunk, on a four byte boundary."""
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        view = {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.bytes += data
        return self.append("bufferViews", view)

    def attribute(self, rows, kind, digits, bounds=False):
        flat = [round(x, digits) + 0.0 for row in rows for x in row]  # + 0.0: no negative zero
        data = struct.pack(f"<{len(flat)}f", *flat)
        accessor = {"bufferView": self.view(data, ARRAY_BUFFER), "componentType": FLOAT, "count": len(rows), "type": kind}
        if bounds:  # of the values as stored
            stored = struct.unpack(f"<{len(flat)}f", data)
            accessor["min"] = [min(stored[axis::3]) for axis in range(3)]
            accessor["max"] = [max(stored[axis::3]) for axis in range(3)]
        return self.append("accessors", accessor)

    def indices(self, faces, vertices):
        short = vertices < 65535
        flat = [i for face in faces for i in face]
        view = self.view(struct.pack(f"<{len(flat)}{'H' if short else 'I'}", *flat), ELEMENT_BUFFER)
        kind = UNSIGNED_SHORT if short else UNSIGNED_INT
        return self.append("accessors", {"bufferView": view, "componentType": kind, "count": len(flat), "type": "SCALAR"})

    def texture(self, name, png, clamp=False):
        image = self.append("images", {"name": name, "mimeType": "image/png", "bufferView": self.view(png)})
        wrap = 33071 if clamp else 10497
        sampler = {"magFilter": 9729, "minFilter": 9987, "wrapS": wrap, "wrapT": wrap}
        samplers = self.json.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        return self.append("textures", {"name": name, "source": image, "sampler": samplers.index(sampler)})

    def material(self, name, color=(1, 1, 1), metallic=0.0, roughness=1.0, picture=None, normal=None, normal_scale=1.0, metal_rough=None,
                 emission=None, mask=None, double_sided=False, lambert=False, extensions=None, **extras):
        """`emission`: radiance. `mask`: alpha cutoff. `lambert`: no specular layer, for us and for those who only know core glTF."""
        surface = {"baseColorFactor": [*color, 1.0][:4], "metallicFactor": metallic, "roughnessFactor": roughness}
        thing = {"name": name, "pbrMetallicRoughness": surface}
        extensions = dict(extensions or {})
        if picture is not None:
            surface["baseColorTexture"] = {"index": picture}
        if metal_rough is not None:
            surface["metallicRoughnessTexture"] = {"index": metal_rough}
        if normal is not None:
            thing["normalTexture"] = {"index": normal, "scale": normal_scale}
        if emission is not None:
            strength = max(1.0, *emission)
            thing["emissiveFactor"] = [x / strength for x in emission]
            extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": strength}
        if mask is not None:
            thing.update(alphaMode="MASK", alphaCutoff=mask)
        if double_sided:
            thing["doubleSided"] = True
        if lambert:
            extras["ag_lambert"] = True
            extensions["KHR_materials_specular"] = {"specularFactor": 0.0}
        if extensions:
            thing["extensions"] = extensions
        return self.append("materials", {**thing, **with_extras(extras)})

    def mesh(self, name, *parts):
        """`parts`: pairs (shape, material), one primitive each. A shape without normals is drawn flat, without uvs untextured."""
        primitives = []
        for shape, material in parts:
            attributes = {"POSITION": self.attribute(shape.positions, "VEC3", 5, bounds=True)}
            if shape.normals:
                attributes["NORMAL"] = self.attribute(shape.normals, "VEC3", 6)
            if shape.uvs:
                attributes["TEXCOORD_0"] = self.attribute(shape.uvs, "VEC2", 5)
            primitives.append({"attributes": attributes, "indices": self.indices(shape.faces, len(shape.positions)), "material": material})
        return self.append("meshes", {"name": name, "primitives": primitives})

    def node(self, name, at=None, turn=None, scale=None, mesh=None, parent=None, **extras):
        """`turn`: unit quaternion x, y, z, w. Extras are the `ag_` keys of the node."""
        thing = {"name": name}
        if mesh is not None:
            thing["mesh"] = mesh
        for key, value in (("translation", at), ("rotation", turn), ("scale", scale)):
            if value is not None:
                thing[key] = list(value)
        index = self.append("nodes", {**thing, **with_extras(extras)})
        above = self.json["scenes"][0]["nodes"] if parent is None else self.json["nodes"][parent].setdefault("children", [])
        above.append(index)
        return index

    def place(self, name, shape, material, **where):
        """A mesh of one part and the node that holds it."""
        return self.node(name, mesh=self.mesh(name, (shape, material)), **where)

    def camera(self, name, eye, target, fov_y_deg, aspect, up=(0, 1, 0)):
        lens = {"yfov": math.radians(fov_y_deg), "aspectRatio": aspect, "znear": 0.05}
        camera = self.append("cameras", {"name": name, "type": "perspective", "perspective": lens})
        node = self.node(name, at=eye, turn=look_rotation(subtract(target, eye), up))
        self.json["nodes"][node]["camera"] = camera

    def light(self, name, kind, color, intensity, at=(0, 0, 0), towards=(0, -1, 0), cone_deg=None, **extras):
        """`towards`: the way the light travels. `cone_deg`: inner and outer half angle of a spot."""
        light = {"name": name, "type": kind, "color": list(color), "intensity": intensity}
        if cone_deg:
            light["spot"] = {"innerConeAngle": math.radians(cone_deg[0]), "outerConeAngle": math.radians(cone_deg[1])}
        self.lights.append(light)
        node = self.node(name, at=at, turn=look_rotation(towards), **extras)
        self.json["nodes"][node]["extensions"] = {"KHR_lights_punctual": {"light": len(self.lights) - 1}}

    def write(self, path):
        level = dict(self.json)
        if self.lights:
            level["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        used = sorted({key for key in find_keys(level) if key.startswith(("KHR_", "EXT_"))})
        if used:
            level["extensionsUsed"] = used
        if self.bytes:
            level["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(rounded(level), separators=(",", ":")).encode()
        chunks = chunk(b"JSON", text, b" ") + (chunk(b"BIN\0", bytes(self.bytes), b"\0") if self.bytes else b"")
        with open(path, "wb") as file:
            file.write(b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)


def with_extras(extras):
    return {"extras": extras} if extras else {}


def chunk(kind, data, padding):
    data += padding * (-len(data) % 4)
    return struct.pack("<I", len(data)) + kind + data


def rounded(value):
    """Nine digits are enough for any float32, and few enough to hide the last bit of a double."""
    if isinstance(value, float):
        return float(f"{value:.9g}") + 0.0
    if isinstance(value, dict):
        return {key: rounded(x) for key, x in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(x) for x in value]
    return value


def find_keys(value):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            yield from find_keys(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from find_keys(inner)
