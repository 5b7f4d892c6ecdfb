#!/usr/bin/env python3
"""What a file may count: processor time and memory at a tenth of each limit, at it, and one beyond.

usage: limits.py BOXPROBE [--only WORD] [--keep FOLDER]

Writes files of its own and opens each by `boxprobe info` or `boxprobe render`. At a limit a command has to end with status 0; beyond it with
status 2 and one line that names the file; emissive triangles beyond stay in the map. Fails where it does not, and where it ends by a
signal. Prints a table in Markdown; times and memory are measured and judge nothing.
"""
import argparse
import json
import os
import re
import resource
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
ROOM = ROOT / "data/scenes/room.boxprobe.json"


def scene(folder, change):
    described = json.loads(ROOM.read_text())
    described["model"] = str(ROOM.with_name("room.glb"))
    change(described)
    path = folder / "scene.boxprobe.json"
    path.write_text(json.dumps(described))
    return [path]


def probes(folder, count):
    def change(described):
        probe = described["probes"][0]
        described["probes"] = [dict(probe, name="p%d" % i) for i in range(count)]
    return scene(folder, change)


def lights(folder, count):
    def change(described):
        described["lights"] = [{"type": "point", "position": [7 * i / count - 3.5, 1.5, 0.3], "range": 0.4, "intensity": 0.02}
                               for i in range(count)]
    return scene(folder, change)


def cameras(folder, count):
    def change(described):
        camera = described["cameras"]["main"]
        described["cameras"] = {"c%d" % i: camera for i in range(count)}
    return scene(folder, change)


def text(name, lines):
    def make(folder, count):
        path = folder / name
        path.write_text("".join(lines(count)))
        return [path]
    return make


def polygon(count):
    import math
    for i in range(count):
        angle = 2 * math.pi * i / count
        yield "v %.6f 0 %.6f\n" % (math.cos(angle), -math.sin(angle))
    yield "f " + " ".join(str(i + 1) for i in range(count)) + "\n"


def ply_elements(count):
    yield "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    yield "element face 1\nproperty list uchar int vertex_indices\n"
    for i in range(count - 2):
        yield "element e%d 0\nproperty float a\n" % i
    yield "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


def vtp(pieces, arrays):
    yield '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
    for _ in range(pieces):
        yield '<Piece NumberOfPoints="3" NumberOfPolys="1" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0">'
        yield '<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>'
        yield '<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>'
        yield '<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys>'
        if arrays:
            yield "<PointData>"
            for i in range(arrays - 3):
                yield '<DataArray type="Float32" Name="a%d" format="ascii">1 2 3</DataArray>' % i
            yield "</PointData>"
        yield "</Piece>"
    yield "</PolyData></VTKFile>\n"


TRIANGLE = struct.pack("<9f3H2x", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2)


def gltf(folder, more, blob=TRIANGLE, material=None):
    described = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, **({"material": 0} if material else {})}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"uri": "a.bin", "byteLength": len(blob)}]}
    if material:
        described["materials"] = [material]
    more(described)
    (folder / "a.bin").write_bytes(blob)
    path = folder / "a.gltf"
    path.write_text(json.dumps(described))
    return [path]


def instances(folder, count):
    def more(described):
        described["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
        described["bufferViews"].append({"buffer": 0, "byteOffset": 44, "byteLength": 12 * count})
        described["accessors"].append({"bufferView": 2, "componentType": 5126, "count": count, "type": "VEC3"})
        described["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}
    places = b"".join(struct.pack("<3f", i % 100, i // 100 % 100, i // 10000) for i in range(count))
    return gltf(folder, more, TRIANGLE + places)


def pictured(folder, width, height):
    """A Radiance picture of one colour as the sky, in run lengths where they may be as long."""
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width)
    if width < 32768:
        runs = b"".join(bytes([128 + min(127, width - at), value]) for value in (90, 70, 50, 128) for at in range(0, width, 127))
        row = bytes([2, 2, width >> 8, width & 255]) + runs
    else:
        row = bytes([90, 70, 50, 128]) * width
    (folder / "a.hdr").write_bytes(head + row * height)
    return scene(folder, lambda described: described.update(sky={"image": "a.hdr"}))


def shining(folder, count):
    corners = b"".join(struct.pack("<9f", i % 100, i // 100, 0, i % 100 + 1, i // 100, 0, i % 100, i // 100 + 1, 0) for i in range(count))
    indices = b"".join(struct.pack("<I", i) for i in range(3 * count))
    def more(described):
        described["bufferViews"] = [{"buffer": 0, "byteLength": len(corners)},
                                    {"buffer": 0, "byteOffset": len(corners), "byteLength": len(indices)}]
        described["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": 3 * count, "type": "VEC3", "min": [0, 0, 0],
                                   "max": [101, 101, 0]},
                                  {"bufferView": 1, "componentType": 5125, "count": 3 * count, "type": "SCALAR"}]
    return gltf(folder, more, corners + indices, {"emissiveFactor": [1, 1, 1]})


def far(folder, count):
    return text("far.obj", lambda n: ["v 0 0 0\nv %g 0 0\nv 0 %g 0\nf 1 2 3\n" % (n, n)])(folder, count)


def piled(folder, count):
    """A room, and in it so many copies of one triangle; the room has 12."""
    corners = [(x, y, z) for x in (-3.1, 2.9) for y in (0, 2.7) for z in (-2, 2.3)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    room = [[corners[side[i]] for i in three] for side in sides for three in ((0, 1, 2), (0, 2, 3))]
    pile = [(.1, .7, .3), (.9, .8, .5), (.4, 1.6, -.2)]
    def packed(triangle):
        return struct.pack("<12fH", 0, 0, 0, *[x for corner in triangle for x in corner], 0)
    path = folder / "pile.stl"
    path.write_bytes(bytes(80) + struct.pack("<I", count + 12) + b"".join(map(packed, room)) + packed(pile) * count)
    return [path]


def large(folder, count):
    path = folder / "scene.boxprobe.json"
    described = json.loads(ROOM.read_text())
    described["model"] = str(ROOM.with_name("room.glb"))
    written = json.dumps(described)
    path.write_text(written + " " * (count - len(written)))
    return [path]


def read_limits():
    """The limits of filters/core/base/file_limits.h by name; numbers, shifts and products of numbers."""
    found = {}
    for name, value in re.findall(r"^constexpr [\w: ]+ (k\w+) = ([^;]+);", (ROOT / "filters/core/base/file_limits.h").read_text(), re.M):
        value = re.sub(r"std::\w+\((\d+)\)", r"\1", value)
        number = re.fullmatch(r"(0x[0-9a-f]+|[\d.e+]+)[uL]*(?: << (\d+))?", value)
        found[name] = int(number[1], 16) if number[1].startswith("0x") else int(float(number[1])) << int(number[2] or 0)
    return found


AT = read_limits()
INFO, RENDER = ["info"], ["render", "-o", os.devnull + ".png", "--size", "32x18"]
# What is counted, the limit, how a file of so many is made, by which command it is opened, what lies beyond.
LIMITS = [
    ("probes of a scene", AT["kEntries"], probes, INFO, AT["kEntries"] + 1, 2),
    ("lights of a scene", AT["kEntries"], lights, INFO, AT["kEntries"] + 1, 2),
    ("lights of a scene, drawn", AT["kEntries"], lights, RENDER, AT["kEntries"] + 1, 2),
    ("cameras of a scene", AT["kEntries"], cameras, INFO, AT["kEntries"] + 1, 2),
    ("bytes of a scene file", AT["kSceneBytes"], large, INFO, AT["kSceneBytes"] + 1, 2),
    ("instances of a glTF file", AT["kGltfInstances"], instances, INFO, AT["kGltfInstances"] + 1, 2),
    ("emissive triangles drawn as shapes", AT["kLampTriangles"], shining, INFO, AT["kLampTriangles"] + 1, 0),
    ("corners of an OBJ file's polygon", AT["kPolygonCorners"], text("polygon.obj", polygon), INFO, AT["kPolygonCorners"] + 1, 2),
    ("largest coordinate, world space", AT["kWorldCoordinate"], far, INFO, 2 * AT["kWorldCoordinate"], 2),
    ("triangles in one place", AT["kTrianglesInOnePlace"], piled, INFO, AT["kTrianglesInOnePlace"] + 1, 2),
    ("elements of a PLY file", AT["kPlyElements"], text("elements.ply", ply_elements), INFO, AT["kPlyElements"] + 1, 2),
    ("pieces of a VTP file", AT["kVtpPieces"], text("pieces.vtp", lambda n: vtp(n, 0)), INFO, AT["kVtpPieces"] + 1, 2),
    ("arrays of a VTP file's piece", AT["kVtpArrays"], text("arrays.vtp", lambda n: vtp(1, n)), INFO, AT["kVtpArrays"] + 1, 2),
    ("side of a picture, pixels", AT["kPictureSide"],
     lambda folder, n: pictured(folder, n, max(1, n // 2)) if n < 20000 else pictured(folder, n, 2), INFO, AT["kPictureSide"] + 1, 2),
    ("pixels of a picture", AT["kPicturePixels"], lambda folder, n: pictured(folder, 16384, n // 16384), INFO, AT["kPicturePixels"] + 16384, 2),
]


def made_apart(make, folder, count):
    """By a process of its own: what is started from a large one counts as large."""
    child = os.fork()
    if child == 0:
        try:
            (folder / "files").write_text("\n".join(map(str, make(folder, count))))
        finally:
            os._exit(0)
    os.waitpid(child, 0)
    return [Path(name) for name in (folder / "files").read_text().splitlines()]


def opened(program, command, files, folder):
    words = [program, command[0], *map(str, files), *command[1:]]
    words = [str(folder / "drawn.png") if word == os.devnull + ".png" else word for word in words] + ["--quiet"] * (command[0] == "render")
    out, err = folder / "out", folder / "err"
    with open(out, "wb") as o, open(err, "wb") as e:
        started = subprocess.Popen(words, stdout=o, stderr=e)
        until = time.monotonic() + 600
        while True:
            pid, status, used = os.wait4(started.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > until:
                started.kill()
            time.sleep(0.01)
    started.returncode = os.waitstatus_to_exitcode(status)
    return started.returncode, err.read_text(errors="replace").splitlines(), used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    os.environ.setdefault("GALLIVM_PERF", "nopt")
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    wrong = []
    print("| counted | limit | a tenth | at the limit | beyond |\n|---|---|---|---|---|")
    for what, limit, make, command, beyond, status in LIMITS:
        if options.only not in what:
            continue
        cells = []
        for count, wanted in ((limit // 10, 0), (limit, 0), (beyond, status)):
            with tempfile.TemporaryDirectory(dir=options.keep) as made:
                folder = Path(made)
                files = made_apart(make, folder, count)
                ended, lines, seconds, mebibytes = opened(options.program, command, files, folder)
                line = lines[-1].replace(made + "/", "") if lines else ""
                if ended != wanted:
                    wrong.append("%s, %d: status %d, not %d: %s" % (what, count, ended, wanted, line))
                elif ended == 2 and (len(lines) != 1 or not any(file.name in lines[0] or "a.hdr" in lines[0] for file in files)):
                    wrong.append("%s, %d: not one line with the file's name: %s" % (what, count, lines))
                cells.append("%.2f s, %.0f MiB" % (seconds, mebibytes) if wanted == 0 else "`%s`" % line.replace("boxprobe: ", ""))
        print("| %s | %s | %s |" % (what, format(limit, ","), " | ".join(cells)), flush=True)
    for line in wrong:
        print("WRONG " + line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
