#!/usr/bin/env python3
"""Checks .glb files: content/check.py FILE.glb ...  One line per fault, exit 1 if there is any.

Held: chunks and lengths, every reference in range, alignment, accessor bounds as stored, finite values, unit normals, indices in range, no
triangle without area, unit rotations, PNG signatures, extensions declared, file size."""
import json
import math
import struct
import sys
from pathlib import Path

SIZES = {5121: ("B", 1), 5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
LARGEST = 4 << 20  # bytes of one level


def read_glb(path):
    data = Path(path).read_bytes()
    magic, version, total = struct.unpack_from("<4sII", data)
    assert magic == b"glTF" and version == 2 and total == len(data), "header: magic, version or length"
    chunks, at = {}, 12
    while at < total:
        size, kind = struct.unpack_from("<I4s", data, at)
        assert size % 4 == 0 and at + 8 + size <= total, f"chunk {kind}: size"
        chunks[kind] = data[at + 8:at + 8 + size]
        at += 8 + size
    return json.loads(chunks[b"JSON"]), chunks.get(b"BIN\0", b"")


def read_accessor(level, binary, index):
    accessor = level["accessors"][index]
    view = level["bufferViews"][accessor["bufferView"]]
    letter, size = SIZES[accessor["componentType"]]
    width, count = WIDTHS[accessor["type"]], accessor["count"]
    start = view["byteOffset"] + accessor.get("byteOffset", 0)
    assert start % size == 0, f"accessor {index}: not aligned"
    assert count > 0 and count * width * size <= view["byteLength"], f"accessor {index}: longer than its view"
    flat = struct.unpack_from(f"<{count * width}{letter}", binary, start)
    assert letter != "f" or all(map(math.isfinite, flat)), f"accessor {index}: not finite"
    if "min" in accessor:
        low, high = ([f(flat[i::width]) for i in range(width)] for f in (min, max))
        assert all(math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-9) for a,
                   b in zip(low + high, accessor["min"] + accessor["max"])), f"accessor {index}: bounds"
    return [flat[i:i + width] for i in range(0, len(flat), width)]


def check_primitive(level, binary, primitive):
    attributes = {name: read_accessor(level, binary, index) for name, index in primitive["attributes"].items()}
    positions = attributes["POSITION"]
    assert "min" in level["accessors"][primitive["attributes"]["POSITION"]], "POSITION without bounds"
    assert len({len(rows) for rows in attributes.values()}) == 1, "attributes of different length"
    assert all(abs(math.hypot(*n) - 1) < 1e-4 for n in attributes.get("NORMAL", [])), "a normal is not unit"
    indices = [row[0] for row in read_accessor(level, binary, primitive["indices"])]
    assert len(indices) % 3 == 0 and max(indices) < len(positions), "indices out of range"
    assert len(set(indices)) == len(positions), "a vertex that no triangle uses"
    for i in range(0, len(indices), 3):
        a, b, c = (positions[k] for k in indices[i:i + 3])
        ab, ac = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        normal = (ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0])
        longest = max(math.hypot(*ab), math.hypot(*ac), math.dist(b, c))
        assert math.hypot(*normal) > 1e-5 * longest * longest, f"triangle {i // 3} has no area"
    return len(indices) // 3


def references(value):
    """The (list, index) pairs that a glTF value of any depth refers to."""
    names = {"mesh": "meshes", "camera": "cameras", "material": "materials", "bufferView": "bufferViews", "source": "images",
             "sampler": "samplers"}
    if isinstance(value, dict):
        for key, inner in value.items():
            if key in names and isinstance(inner, int):
                yield names[key], inner
            elif key.endswith("Texture"):
                yield "textures", inner["index"]
            elif key in ("nodes", "children"):
                yield from (("nodes", i) for i in inner if isinstance(i, int))
            if key != "extras":
                yield from references(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from references(inner)


def check(path):
    level, binary = read_glb(path)
    assert Path(path).stat().st_size <= LARGEST, "larger than 4 MB"
    assert level["asset"]["version"] == "2.0", "asset version"
    assert not binary or level["buffers"][0]["byteLength"] <= len(binary) < level["buffers"][0]["byteLength"] + 4, "buffer length"
    for kind, index in references(level):
        assert 0 <= index < len(level.get(kind, [])), f"{kind}[{index}] does not exist"
    for view in level.get("bufferViews", []):
        assert view["byteOffset"] % 4 == 0 and view["byteOffset"] + view["byteLength"] <= len(binary), "a bufferView leaves the buffer"
    for image in level.get("images", []):
        start = level["bufferViews"][image["bufferView"]]["byteOffset"]
        assert binary[start:start + 8] == b"\x89PNG\r\n\x1a\n", f"image {image['name']} is no PNG"
    for node in level.get("nodes", []):
        assert abs(math.hypot(*node.get("rotation", (0, 0, 0, 1))) - 1) < 1e-6, f"node {node['name']}: rotation"
    names = [node["name"] for node in level.get("nodes", [])]
    assert len(set(names)) == len(names), "two nodes of one name"
    used = {key for thing in (level, *level.get("nodes", []), *level.get("materials", [])) for key in thing.get("extensions", {})}
    assert used == set(level.get("extensionsUsed", [])), "extensionsUsed"
    triangles = sum(check_primitive(level, binary, p) for mesh in level.get("meshes", []) for p in mesh["primitives"])
    return f"{len(names)} nodes, {triangles} triangles, {len(level.get('images', []))} pictures, {Path(path).stat().st_size} bytes"


def main():
    faults = 0
    for path in sys.argv[1:]:
        try:
            print(f"{path}: {check(path)}")
        except (AssertionError, KeyError, IndexError, ValueError, struct.error) as fault:
            print(f"{path}: FAULT {type(fault).__name__} {fault}")
            faults += 1
    sys.exit(1 if faults or len(sys.argv) < 2 else 0)


if __name__ == "__main__":
    main()
