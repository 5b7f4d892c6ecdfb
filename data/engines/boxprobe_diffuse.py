#!/usr/bin/env python3
"""Diffuse light of a .glb of `boxprobe export --format glb` for engines: the lattices that data/glb/README.md specifies, as

    boxprobe_diffuse.py FILE.glb -o DIR --for bevy     an irradiance volume per lattice: NAME.ktx2, a 3D texture, and where it stands, NAME.json
    boxprobe_diffuse.py FILE.glb -o DIR --for unity    one light-probes.json: positions and SphericalHarmonicsL2, for BoxprobeLightProbes.cs

Lattices hold no light of lamps: give an engine the lamps as its lights. Python alone, no packages.
"""
import argparse
import json
import math
import re
import struct
import sys
from pathlib import Path

NAME = "BOXPROBE_reflection_probes"
# Bevy's ambient cube: along z of the texture x, y and z sides; along y the positive side, then the negative one (irradiance_volume.wgsl).
SIDES = [[(1, 0, 0), (-1, 0, 0)], [(0, 1, 0), (0, -1, 0)], [(0, 0, 1), (0, 0, -1)]]


def fail(text):
    sys.exit("boxprobe_diffuse.py: " + text)


def read_glb(path):
    try:
        data = Path(path).read_bytes()
        magic, version, length, size, kind = struct.unpack_from("<4sIIII", data)
        if magic != b"glTF" or version != 2 or kind != 0x4E4F534A or length > len(data):
            fail("%s: not a whole glTF 2 file in one piece (.glb)" % path)
        document = json.loads(data[20:20 + size])
        extension = document["extensions"][NAME]
        start = 20 + size + 8
        views = document["bufferViews"]
        return extension, lambda index: data[start + views[index].get("byteOffset", 0):][:views[index]["byteLength"]]
    except OSError as error:
        fail("%s: %s" % (path, error.strerror))
    except (KeyError, ValueError, struct.error):
        fail("%s: holds no probes; write it by: boxprobe export SCENE -o FILE.glb --format glb" % path)


def coefficients(lattice, bytes_of):
    """Per node, x fastest: nine coefficients of three colours, and whether the light is the node's own."""
    count = math.prod(lattice["nodes"])
    values = struct.unpack("<%de" % (28 * count), bytes_of(lattice["bufferView"])[:56 * count])
    nodes = []
    for node in range(count):
        numbers = [values[4 * (part * count + node) + c] for part in range(7) for c in range(4)]
        nodes.append(([numbers[3 * k:3 * k + 3] for k in range(9)], numbers[27] > 0.5))
    return nodes


def light(sh, n):
    """Irradiance over pi."""
    x, y, z = n
    basis = (1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y)
    return [max(sum(b * sh[k][c] for k, b in enumerate(basis)), 0.0) for c in range(3)]


def turned(q, v):
    """By a quaternion x, y, z, w."""
    u, w = q[:3], q[3]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * c for c in cross(u, v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross(u, t))]


def ktx2(size, texels):
    """A 3D texture of one level, RGBA half floats. `texels`: their bytes, x fastest, then y, then z."""
    channels = b"".join(struct.pack("<HBBIii", 16 * i, 15, channel | 0xC0, 0, -0x40800000, 0x3F800000)
                        for i, channel in enumerate((0, 1, 2, 15)))
    block = struct.pack("<IHHBBBB4B8B", 0, 2, 24 + len(channels), 1, 1, 1, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0) + channels
    description = struct.pack("<I", 4 + len(block)) + block
    writer = b"KTXwriter\0boxprobe_diffuse.py\0"
    values = struct.pack("<I", len(writer)) + writer
    values += b"\0" * (-len(values) % 4)
    at = 12 + 36 + 32 + 24
    first = at + len(description) + len(values)
    first += -first % 8
    head = b"\xabKTX 20\xbb\r\n\x1a\n" + struct.pack("<9I", 97, 2, *size, 0, 1, 1, 0)
    head += struct.pack("<4I2Q", at, len(description), at + len(description), len(values), 0, 0)
    head += struct.pack("<3Q", first, len(texels), len(texels)) + description + values
    return head + b"\0" * (first - len(head)) + texels


def file_name(name, used):
    stem = re.sub(r"[^A-Za-z0-9._-]", "_", name).lstrip(".") or "probe"
    chosen, number = stem, 2
    while chosen.lower() in used:
        chosen, number = "%s-%d" % (stem, number), number + 1
    used.add(chosen.lower())
    return chosen


def write_bevy(probes, folder):
    used = set()
    for probe, lattice, nodes in probes:
        nx, ny, nz = count = lattice["nodes"]
        texels = bytearray()
        for sides in SIDES:
            for z in range(nz):
                for side in sides:
                    for y in range(ny):
                        for x in range(nx):
                            colour = light(nodes[x + nx * (y + ny * z)][0], side)
                            texels += struct.pack("<4e", *(min(c, 65504.0) for c in colour), 1.0)
        # Voxels' centres are the nodes, so the volume reaches half a step beyond them.
        step = [(b - a) / (n - 1) if n > 1 else 2 * (b - a) or 1.0 for a, b, n in zip(lattice["min"], lattice["max"], count)]
        middle = [(a + b) / 2 for a, b in zip(lattice["min"], lattice["max"])]
        place = [a + b for a, b in zip(probe["origin"], turned(probe["rotation"], middle))]
        name = file_name(probe["name"], used)
        (folder / (name + ".ktx2")).write_bytes(ktx2((nx, 2 * ny, 3 * nz), bytes(texels)))
        (folder / (name + ".json")).write_text(json.dumps({
            "name": probe["name"], "file": name + ".ktx2", "resolution": count, "translation": place, "rotation": probe["rotation"],
            "scale": [s * n for s, n in zip(step, count)], "intensity": probe["intensity"]}, indent=2) + "\n")
        print(folder / (name + ".ktx2"))


def write_unity(probes, folder):
    """Unity is left-handed: x is negated, as glTFast and UnityGLTF do."""
    positions, harmonics = [], []
    for probe, lattice, nodes in probes:
        (nx, ny, nz), low, high = lattice["nodes"], lattice["min"], lattice["max"]
        at = lambda i, n, axis: low[axis] + (high[axis] - low[axis]) * (i / (n - 1) if n > 1 else 0.5)
        for index, (sh, _) in enumerate(nodes):
            x, y, z = index % nx, index // nx % ny, index // (nx * ny)
            world = [a + b for a, b in zip(probe["origin"], turned(probe["rotation"], [at(x, nx, 0), at(y, ny, 1), at(z, nz, 2)]))]
            positions += [-world[0], world[1], world[2]]
            # [rgb, k] of SphericalHarmonicsL2; those that are odd in x change sign.
            harmonics += [(-1 if k in (3, 4, 7) else 1) * probe["intensity"] * sh[k][c] for c in range(3) for k in range(9)]
    (folder / "light-probes.json").write_text(json.dumps({"format": "boxprobe-light-probes", "positions": positions, "coefficients": harmonics}) + "\n")
    print("%s: %d light probes" % (folder / "light-probes.json", len(positions) // 3))


def main():
    reader = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    reader.add_argument("file")
    reader.add_argument("-o", "--output", type=Path, required=True, metavar="DIR")
    reader.add_argument("--for", dest="engine", choices=["bevy", "unity"], required=True)
    options = reader.parse_args()
    extension, bytes_of = read_glb(options.file)
    probes = []
    for probe in extension["probes"]:
        if "lattice" in probe:
            lattice = extension["lattices"][probe["lattice"]]
            probes.append((probe, lattice, coefficients(lattice, bytes_of)))
    if not probes:
        fail("%s: no probe has a lattice; set \"lamps\": \"shapes\" in the scene, and a probe's \"lattice\" must not be false" % options.file)
    options.output.mkdir(parents=True, exist_ok=True)
    (write_bevy if options.engine == "bevy" else write_unity)(probes, options.output)


if __name__ == "__main__":
    main()
