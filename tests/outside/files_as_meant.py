#!/usr/bin/env python3
"""Files of many programs, written here, as they are drawn: right value beside drawn value, a line each.

    tests/outside/files_as_meant.py build/release/bin/boxprobe [-o FOLDER] [--only TEXT]

Needs python3-numpy, python3-openimageio and python3-pil, and a display. Colours of models are compared with a glTF file of the
same colour. Ends with 1 if a line is wrong.
"""
import argparse
import base64
import json
import os
import struct
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

QUAD = [(-.45, -.45), (.45, -.45), (.45, .45), (-.45, .45)]
UV = [(0, 0), (1, 0), (1, 1), (0, 1)]
RED, WHITE_SKY = [1, 0, 0], {"color": [1, 1, 1]}
COLOR = (188, 99, 50)  # sRGB
wrong = 0


def linear(byte):
    return ((byte / 255 + .055) / 1.055) ** 2.4


def write(name, data):
    with open(name, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())
    return name


def run(*arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def drawn(model, sky=None, camera=None, pixel=(8, 8), probes=None, size=16):
    """The linear colour of one pixel, or the program's message."""
    scene = {"format": "boxprobe-scene", "version": 1, "model": model, "sky": sky or WHITE_SKY, "lights": [],
             "cameras": {"main": camera or {"position": [0, 0, 5], "target": [0, 0, 0], "parallelHeight": 1}}}
    if probes:
        scene["probes"] = probes
    write("s.boxprobe.json", json.dumps(scene))
    status, said = run("render", "s.boxprobe.json", "-o", "o.exr", "--size", "%dx%d" % (size, size))
    if status:
        return said.strip().splitlines()[-1]
    file = oiio.ImageInput.open("o.exr")  # an ImageBuf would have the last picture again: files of one second are one to its cache
    image = file.read_image(0, 0, 0, file.spec().nchannels, oiio.FLOAT)
    file.close()
    return image if pixel is None else image[pixel[1], pixel[0], :3]


def line(row, right, found, tolerance=.01):
    global wrong
    if isinstance(found, str) or isinstance(right, str):
        fine = isinstance(found, str) and isinstance(right, str) and right in found
        lines = str(found).strip().splitlines() or [""]
        found = next((said.strip() for said in lines if str(right) in said), lines[-1])
    else:
        right, found = np.atleast_1d(np.asarray(right, float)), np.atleast_1d(np.asarray(found, float))
        fine = right.shape == found.shape and bool((np.abs(right - found) <= tolerance * np.maximum(np.abs(right), .05)).all())
        right, found = (" ".join("%.4g" % v for v in values) for values in (right, found))
    wrong += not fine
    print("%-7s%s: right %s, drawn %s" % ("" if fine else "WRONG", row, right, found), flush=True)


def gltf(name, points=QUAD, color=None, translation=(0, 0, 0), material=None, cameras=None):
    data = np.array([(x, y, 0) for x, y in points], "<f4").tobytes() + np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    material = material or {"pbrMetallicRoughness": {"baseColorFactor": [*(color or RED), 1], "metallicFactor": 0}}
    model = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "materials": [material],
             "nodes": [{"mesh": 0, "translation": list(translation)}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-.45, -.45, 0],
                            "max": [.45, .45, 0]},
                           {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
             "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
             "buffers": [{"byteLength": 60,
                          "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    if cameras:
        model["cameras"] = cameras
        model["nodes"].append({"camera": 0, "translation": [0, 0, 5], "name": "film"})
        model["scenes"][0]["nodes"].append(1)
    return write(name, json.dumps(model))


def obj(name, mtl, more=""):
    write(name + ".mtl", mtl)
    return write(name + ".obj", "mtllib %s.mtl\n" % name + "".join("v %g %g 0\n" % p for p in QUAD) +
                 "".join("vt %g %g\n" % p for p in UV) + "vn 0 0 1\nusemtl m\n" + more +
                 "f 1/1/1 2/2/1 3/3/1 4/4/1\n")


def ply(name, properties="", rows=("",) * 4, comment="", face="4 0 1 2 3", of_face="", scalar="float", points=QUAD, z=0):
    return write(name, "ply\nformat ascii 1.0\n%selement vertex 4\n" % comment +
                 "".join("property %s %s\n" % (scalar, axis) for axis in "xyz") + properties +
                 "element face 1\nproperty list uchar int vertex_indices\n" + of_face + "end_header\n" +
                 "".join("%.9g %.9g %.9g %s\n" % (*p, z, r) for p, r in zip(points, rows)) + face + "\n")


def stl(points=QUAD, z=0, number="%.9g"):
    def triangle(*corners):
        return "facet normal 0 0 1\nouter loop\n" + "".join(
            "vertex " + " ".join(number % v for v in (*points[c], z)).replace("%", "") + "\n" for c in corners) + "endloop\nendfacet\n"
    return "solid a\n" + triangle(0, 1, 2) + triangle(0, 2, 3) + "endsolid a\n"


def binary_stl(header, count=2, attribute=0, behind=b""):
    data = header.ljust(80, b"\0")[:80] + struct.pack("<I", count)
    for corners in ((0, 1, 2), (0, 2, 3)):
        data += struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *QUAD[c], 0) for c in corners)
        data += struct.pack("<H", attribute)
    return data + behind


def vtp(points=QUAD, z=0, kind="Float32", data=""):
    return ('<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="4" '
            'NumberOfPolys="1"><PointData>%s</PointData><Points><DataArray type="%s" NumberOfComponents="3" format="ascii">%s'
            '</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>'
            '<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Polys></Piece></PolyData></VTKFile>' %
            (data, kind, " ".join("%.9g %.9g %.9g" % (*p, z) for p in points)))


def exr(name, pixels, channels="RGB", window=None, attributes=()):
    pixels = np.asarray(pixels, "f4")
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], oiio.FLOAT)
    spec.channelnames = tuple(channels)
    if window:
        spec.x, spec.y, spec.full_width, spec.full_height = window
    for attribute in attributes:
        spec.attribute(*attribute)
    out = oiio.ImageOutput.create(name)
    out.open(name, spec)
    out.write_image(pixels)
    out.close()
    return name


def rgbe(pixels):
    most = pixels.max(-1)
    exponent = np.floor(np.log2(most)) + 1
    return np.concatenate([np.floor(pixels * (256 / 2.0 ** exponent)[..., None]), exponent[..., None] + 128], -1).astype("u1")


def radiance(name, pixels, head="FORMAT=32-bit_rle_rgbe\n", size="-Y 8 +X 16", encode=None):
    body = b"".join((encode or (lambda row: row.tobytes()))(row) for row in rgbe(np.asarray(pixels, float)))
    return write(name, ("#?RADIANCE\n" + head + "\n" + size + "\n").encode() + body)


def old_runs(row):
    data, at = b"", 0
    while at < len(row):
        count = 1
        while at + count < len(row) and (row[at + count] == row[at]).all():
            count += 1
        data += row[at].tobytes() + (bytes([1, 1, 1, count - 1]) if count > 1 else b"")
        at += count
    return data


SKY = np.zeros((8, 16, 3)) + [.5, .25, 2]
SKY[:4, :8] = [.25, 1, 2]  # the upper left quarter: towards +X, up
UP_LEFT = {"position": [0, 500, 0], "target": [1, 500.5, .2], "verticalFovDegrees": 2}


def sky(picture, **more):
    return drawn("far.gltf", {"image": picture, **more}, UP_LEFT)


def far_coordinates():
    x, y, z = 431000.37, 5411932.62, 312.25
    far = [(a + x, b + y) for a, b in QUAD]
    write("m.mtl", "newmtl m\nKd 1 0 0\n")
    files = [gltf("far_away.gltf", translation=(x, y, z)), ply("far.ply", scalar="double", points=far, z=z),
             write("far.obj", "mtllib m.mtl\nusemtl m\n" + "".join("v %.4f %.4f %.4f\n" % (*p, z) for p in far) + "f 1 2 3 4\n"),
             write("far.stl", stl(far, z)), write("far.vtp", vtp(far, z, "Float64"))]
    camera = {"position": [x, y, z + 5], "target": [x, y, z], "parallelHeight": 1}
    covered = [float((drawn(f, camera=camera, pixel=None, size=128)[..., 3] > .5).sum()) for f in files]
    for file, pixels in zip(files[1:], covered[1:]):
        line("doubles at 431000, 5411932: " + file + ", pixels covered", covered[0], pixels, 0)


def environments():
    for name, options in (("old run lengths", {"encode": old_runs}), ("no FORMAT", {"head": ""}),
                          ("without runs", {})):
        line("Radiance, " + name, [.25, 1, 2], sky(radiance("a.hdr", SKY, **options)))
    line("Radiance, EXPOSURE twice", [.25, 1, 2], sky(radiance("b.hdr", SKY * 4, head="EXPOSURE=2\nEXPOSURE= 2.0\n")))
    line("Radiance, COLORCORR", [.25, 1, 2], sky(radiance("c.hdr", SKY * [1, 2, 1], head="COLORCORR=1 2 1\n")))
    line("Radiance, +Y", [.25, 1, 2], sky(radiance("d.hdr", SKY[::-1], size="+Y 8 +X 16")))
    line("Radiance, -X", [.25, 1, 2], sky(radiance("e.hdr", SKY[:, ::-1], size="-Y 8 -X 16")))
    line("Radiance, X first", [.25, 1, 2], sky(radiance("f.hdr", SKY.transpose(1, 0, 2), size="+X 16 -Y 8")))
    to_xyz = np.array([[.4124564, .3575761, .1804375], [.2126729, .7151522, .0721750], [.0193339, .1191920, .9503041]])
    # Eight bits of the brightest of XYZ.
    line("Radiance, XYZE", [.25, 1, 2], sky(radiance("g.hdr", SKY @ to_xyz.T, head="FORMAT=32-bit_rle_xyze\n")), .08)
    line("OpenEXR, the left half of the display window", [.25, 1, 2], sky(exr("a.exr", SKY[:, :8], window=(0, 0, 16, 8))))
    line("OpenEXR, the right half alone: outside", [0, 0, 0], sky(exr("b.exr", SKY[:, 8:], window=(8, 0, 16, 8))))
    ap0 = np.array([.7347, .2653, 0, 1, .0001, -.077, .32168, .33767], "f4")
    to_ap0 = np.linalg.inv([[2.52169, -1.13413, -.38756], [-.27648, 1.37272, -.09624], [-.01538, -.15298, 1.16835]])
    line("OpenEXR, ACES AP0", [.25, 1, 2],
         sky(exr("c.exr", SKY @ to_ap0.T, attributes=[("chromaticities", oiio.TypeDesc("float[8]"), ap0)])), .02)
    line("OpenEXR, one channel V", [1, 1, 1], sky(exr("d.exr", SKY[..., 1:2], channels="V")))
    texel = SKY.copy()
    texel[:, :, :] = [np.inf, np.inf, 60000]
    line("OpenEXR, infinite", [65504, 65504, 60000], sky(exr("e.exr", texel)))
    texel = SKY.copy()
    texel[2, 2:4, 0] = np.nan
    line("OpenEXR, NaN among .25 1 2", [.25, 1, 2], sky(exr("f.exr", texel)))
    # A sun of one texel, which becomes a light: what a surface that faces it gets.
    width, height = 64, 32
    sun = np.full((height, width, 3), .5)
    sun[9, 31] = 1e6
    scene = {"format": "boxprobe-scene", "version": 1, "model": "far.gltf", "sky": {"image": exr("sun.exr", sun)}}
    status, said = run("info", write("sun.boxprobe.json", json.dumps(scene)))
    line("OpenEXR, a sun of 1e6: info", "its sun was taken out and is drawn as a light", said)
    status, said = run("info", "sun.boxprobe.json", "--json")
    angle = 2 * np.pi / width * (np.sin(np.pi / 2 - np.pi * 9 / height) - np.sin(np.pi / 2 - np.pi * 10 / height))
    line("the same: its light, facing it", angle * 1e6, json.loads(said)["sky"]["sunLight"]["intensity"], .001)
    scene["sky"]["sun"] = "in-picture"
    status, said = run("info", write("sun.boxprobe.json", json.dumps(scene)))
    line("the same, left in the picture: info", "65504, the largest half float: the light was spread", said)


def cross():
    size = 16
    front, right, left, back, up, down = ([1, 1, 1], [0, 1, 0], [0, 0, 1], [1, 1, 0], [.5] * 3, [.1] * 3)
    face = lambda color: np.zeros((size, size, 3)) + color
    black = face([0, 0, 0])
    picture = np.vstack([np.hstack([black, face(up), black]), np.hstack([face(left), face(front), face(right)]),
                         np.hstack([black, face(down), black]), np.hstack([black, face(back), black])])
    exr("cross.exr", picture)
    to_the_right = {"position": [0, 500, 0], "target": [-1, 500, 0], "verticalFovDegrees": 2}
    line("a photograph as a cross, cubeView inside, to the viewer's right", right,
         drawn("far.gltf", {"image": "cross.exr", "cubeView": "inside"}, to_the_right))
    line("the same, cubeView outside", left, drawn("far.gltf", {"image": "cross.exr"}, to_the_right))


def materials():
    from PIL import Image
    Image.new("RGB", (2, 2), (255, 0, 0)).save("my red tile.png")
    half = Image.new("L", (4, 4), 0)
    half.paste(255, (0, 0, 2, 4))
    half.save("mask.png")
    as_red = drawn(gltf("red.gltf"))
    for statement in ("map_Kd my red tile.png", 'map_Kd "my red tile.png"', "map_kd MY RED TILE.PNG",
                      "map_Kd -s 2 2 -o .5 0 my red tile.png", "MAP_KD .\\my red tile.png"):
        line("MTL, " + statement, as_red, drawn(obj("n", "newmtl m\nKd 1 1 1\n%s\n" % statement)))
    line("MTL, byte order mark and carriage returns", as_red, drawn(obj("o", "\ufeffnewmtl m\rKd 1 0 0\r")))
    line("MTL, Ke", [.5, .25, .125], drawn(obj("p", "newmtl m\nKd 0 0 0\nKe .5 .25 .125\n"), {"color": [0, 0, 0]}))
    line("MTL, d .5 over white", .5 * as_red + .5, drawn(obj("q", "newmtl m\nKd 1 0 0\nd .5\n")))
    line("MTL, map_d: a hole", [1, 1, 1], drawn(obj("r", "newmtl m\nKd 1 0 0\nmap_d mask.png\n"), pixel=(12, 8)))
    metal = {"pbrMetallicRoughness": {"baseColorFactor": [1, .5, .25, 1], "metallicFactor": 1, "roughnessFactor": .3}}
    line("MTL, Pm 1 and Pr .3", drawn(gltf("metal.gltf", material=metal)), drawn(obj("t", "newmtl m\nKd 1 .5 .25\nPm 1\nPr .3\n")))
    Image.new("CMYK", (8, 8), (60, 150, 200, 20)).save("cmyk.jpg", quality=100)  # Adobe: stored inverted, as PIL does
    opened = np.asarray(Image.open("cmyk.jpg").convert("RGB"))[4, 4]
    line("MTL, a JPEG of four inks", drawn(gltf("inks.gltf", color=[linear(v) for v in opened])),
         drawn(obj("u", "newmtl m\nmap_Kd cmyk.jpg\n")), .03)
    write("broken.png", b"\x89PNG\r\n\x1a\nbroken")
    status, said = run("info", obj("v", "newmtl m\nmap_Kd broken.png\n"))
    line("MTL, a picture that cannot be decoded: info", "grey", said)


def colors():
    right = drawn(gltf("color.gltf", color=[linear(v) for v in COLOR]))
    shares = "%.6f %.6f %.6f" % tuple(v / 255 for v in COLOR)
    bytes_ = "%d %d %d" % COLOR
    named = lambda kind, names: "".join("property %s %s\n" % (kind, n) for n in names)
    for row, file in (
            ("PLY, bytes", ply("a.ply", named("uchar", ("red", "green", "blue")), (bytes_,) * 4)),
            ("PLY, numbers", ply("b.ply", named("float", ("red", "green", "blue")), (shares,) * 4)),
            ("PLY, r g b", ply("c.ply", named("uchar", "rgb"), (bytes_,) * 4)),
            ("PLY, colour of the face", ply("d.ply", face="4 0 1 2 3 " + bytes_, of_face=named("uchar", ("red", "green", "blue")))),
            ("OBJ", write("a.obj", "".join("v %g %g 0 %s\n" % (*p, shares) for p in QUAD) + "f 1 2 3 4\n")),
            ("VTP", write("a.vtp", vtp(data='<DataArray type="UInt8" Name="RGB" NumberOfComponents="3" format="ascii">%s</DataArray>'
                                       % " ".join([bytes_] * 4))))):
        line("vertex colours, " + row, right, drawn(file), .02)
    as_red = drawn(gltf("red.gltf"))
    line("STL, VisCAM's red", as_red, drawn(write("a.stl", binary_stl(b"exported", attribute=0x8000 | 31 << 10))), .02)
    line("STL, Magics' red", as_red, drawn(write("b.stl", binary_stl(b"COLOR=\0\0\xff\xff", attribute=31))), .02)
    from PIL import Image
    halves = Image.new("RGB", (4, 4), (255, 0, 0))
    halves.paste((0, 0, 255), (2, 0, 4, 4))
    halves.save("halves.png")
    texture = "comment TextureFile halves.png\n"
    corners = " ".join("%g %g" % p for p in UV)
    of_vertex = ["%g %g" % p for p in UV]
    for row, file in (
            ("s t", ply("e.ply", named("float", "st"), of_vertex, texture)),
            ("u v", ply("f.ply", named("float", "uv"), of_vertex, texture)),
            ("corners", ply("g.ply", comment=texture, face="4 0 1 2 3 8 " + corners, of_face="property list uchar float texcoord\n"))):
        line("PLY, picture by " + row, as_red, drawn(file, pixel=(4, 8)), .02)


def shapes():
    grey = drawn(ply("plain.ply"))
    for row, data in (("header solid facet and two bytes more", binary_stl(b"solid facet normal", behind=b"\0\0")),
                      ("no count", binary_stl(b"x", count=0)),
                      ("decimal commas", stl(number="%.2f").replace(".", ",")),
                      ("byte order mark", "\ufeff" + stl())):
        line("STL, " + row, grey, drawn(write("shape.stl", data)))
    for extension in ("fbx", "usd", "usda", "usdc", "usdz", "dae", "abc", "blend", "3ds"):
        status, said = run("info", write("other." + extension, "x"))
        line("other." + extension, "export" if extension != "3ds" else "assimp export", said.strip())
    perspective = {"type": "perspective", "perspective": {"yfov": .3, "znear": 6, "zfar": 20, "aspectRatio": 2.35}}
    status, said = run("info", gltf("film.gltf", cameras=[perspective]))
    line("glTF, znear beyond the model: info", "near or far plane cuts off", said)
    line("glTF, aspectRatio: info", "render it with --size 1692x720", said)


def engines():
    write("g.tscn", '[gd_scene format=3]\n[node name="R" type="Node3D"]\n[node name="P" type="Node3D" parent="."]\n'
          'position = Vector3(10, 0, 0)\nrotation_degrees = Vector3(0, 90, 0)\nscale = Vector3(2, 2, 2)\n'
          '[node name="Probe" type="ReflectionProbe" parent="P"]\nposition = Vector3(0, 0, -3)\nsize = Vector3(2, 4, 6)\n')
    run("import", "g.tscn", "-o", "g.boxprobe.json")
    with open("g.boxprobe.json") as file:
        probe = json.load(file)["probes"][0]
    line("Godot, turned and scaled parent: origin", [4, 0, 0], probe["origin"])
    line("Godot, size of the box", [4, 8, 12], np.subtract(probe["box"]["max"], probe["box"]["min"]))
    write("u.unity", "%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: Probe\n  m_Component:\n  - component: {fileID: 2}\n"
          "  - component: {fileID: 3}\n  m_IsActive: 1\n--- !u!4 &2\nTransform:\n  m_GameObject: {fileID: 1}\n"
          "  m_LocalPosition: {x: 1, y: 2, z: 3}\n  m_Father: {fileID: 0}\n--- !u!215 &3\nReflectionProbe:\n"
          "  m_GameObject: {fileID: 1}\n  m_Enabled: 0\n")
    status, said = run("import", "u.unity", "-o", "u.boxprobe.json")
    line("Unity, m_Enabled 0", "is left out, because m_Enabled is 0", said)


def main():
    global PROGRAM
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("-o", dest="out")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    PROGRAM = os.path.abspath(options.program)
    folder = options.out or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    gltf("far.gltf", translation=(0, -1e5, 0))
    for group in (far_coordinates, environments, cross, materials, colors, shapes, engines):
        if options.only in group.__name__:
            group()
    print("%d wrong" % wrong)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
