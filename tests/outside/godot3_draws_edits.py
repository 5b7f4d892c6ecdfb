#!/usr/bin/env python3
"""Pictures of Godot 3 while a scene file is edited: it draws the mirror ball of six-faces.glb with the probes that
data/engines/boxprobe_live_godot3.gd keeps up to date, after each of five edits, beside ours.

usage: godot3_draws_edits.py BOXPROBE SCENES OUT

Over the ball, in display values: each picture is at least LEAST dB from ours after the same edit, and at least APART dB nearer to it than to
ours after any other edit. Godot 3 mixes probes by another rule than ours, so one probe is edited.
"""
import json
import math
import shutil
import signal
import struct
import subprocess
import sys
import threading
import time
import zlib
from pathlib import Path

LEAST, APART = 20.0, 2.0
WIDTH, HEIGHT = 240, 150
program, scenes, out = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
engine = shutil.which("godot3")
if engine is None:
    print("left out: package godot3 is not installed")
    sys.exit(77)
here = Path(__file__).resolve().parent
shutil.rmtree(out, ignore_errors=True)
out.mkdir(parents=True)
for file in (here / "godot3" / "edits.gd", here.parents[1] / "data" / "engines" / "boxprobe_live_godot3.gd"):
    shutil.copy(file, out)
(out / "edits.tscn").write_text('[gd_scene load_steps=2 format=2]\n[ext_resource path="res://edits.gd" type="Script" id=1]\n'
                                '[node name="Root" type="Spatial"]\nscript = ExtResource( 1 )\n')
(out / "project.godot").write_text("""config_version=4
[application]
config/name="edits"
run/main_scene="res://edits.tscn"
[display]
window/size/width=%d
window/size/height=%d
[rendering]
quality/driver/driver_name="GLES3"
quality/reflections/atlas_size=512
quality/reflections/high_quality_ggx=false
quality/reflections/atlas_subdiv=2
environment/default_clear_color=Color( 0, 0, 0, 1 )
""" % (WIDTH, HEIGHT))

scene = json.loads((scenes / "six-faces.boxprobe.json").read_text())
scene["model"] = str(scenes / "six-faces.glb")
probe, main = scene["probes"][0], scene["cameras"]["main"]
probe["faceSize"] = 256
main["verticalFovDegrees"] = 34  # the ball fills most of the picture's height
scene_file = out / "live.boxprobe.json"


def model():
    """Walls with their pictures as files, and the ball's radius."""
    data = (scenes / "six-faces.glb").read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    gltf, binary = json.loads(data[20:20 + size]), data[28 + size:]

    def view(index):
        each = gltf["bufferViews"][index]
        return binary[each.get("byteOffset", 0):][:each["byteLength"]]

    def read(index):
        accessor = gltf["accessors"][index]
        count = accessor["count"] * {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
        kind = {5123: "H", 5125: "I", 5126: "f"}[accessor["componentType"]]
        return list(struct.unpack_from("<%d%s" % (count, kind), view(accessor["bufferView"]), accessor.get("byteOffset", 0)))

    walls = []
    for node in gltf["nodes"]:
        primitive = gltf["meshes"][node["mesh"]]["primitives"][0]
        attributes = primitive["attributes"]
        if node["name"] == "ball":
            radius = gltf["accessors"][attributes["POSITION"]]["max"][1]
            continue
        texture = gltf["materials"][primitive["material"]]["pbrMetallicRoughness"]["baseColorTexture"]["index"]
        picture = "wall-%d.png" % len(walls)
        (out / picture).write_bytes(view(gltf["images"][gltf["textures"][texture]["source"]]["bufferView"]))
        walls.append({"positions": read(attributes["POSITION"]), "normals": read(attributes["NORMAL"]), "uvs": read(attributes["TEXCOORD_0"]),
                      "indices": read(primitive["indices"]), "picture": picture})
    return walls, radius


walls, radius = model()
(out / "config.json").write_text(json.dumps({"walls": walls, "radius": radius, "camera": main}))


def save():
    scene_file.with_suffix(".new").write_text(json.dumps(scene))
    scene_file.with_suffix(".new").rename(scene_file)


def glb_probe():
    try:
        data = (out / "live.glb").read_bytes()
        return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])["extensions"]["BOXPROBE_reflection_probes"]["scene"]["probes"][0]
    except (OSError, ValueError, KeyError, struct.error):
        return None


def ball_pixels():
    """Where the ball is drawn, less its rim: by the rays of the camera."""
    sub = lambda a, b: [x - y for x, y in zip(a, b)]
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    unit = lambda a: [x / math.sqrt(dot(a, a)) for x in a]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    eye = main["position"]
    back = unit(sub(eye, main["target"]))
    right = unit(cross(main["up"], back))
    above = cross(back, right)
    half, found = math.tan(math.radians(main["verticalFovDegrees"]) / 2), []
    for y in range(HEIGHT):
        for x in range(WIDTH):
            u, v = (2 * (x + 0.5) / WIDTH - 1) * half * WIDTH / HEIGHT, (1 - 2 * (y + 0.5) / HEIGHT) * half
            along = unit([r * u + a * v - b for r, a, b in zip(right, above, back)])
            t = -dot(eye, along)
            if math.sqrt(sum((e + t * d) ** 2 for e, d in zip(eye, along))) < 0.9 * radius:
                found.append(y * WIDTH + x)
    return found


def decibels(a, b, where):
    total = sum((a[3 * i + c] - b[3 * i + c]) ** 2 for i in where for c in range(3))
    return 10 * math.log10(255 * 255 * 3 * len(where) / max(total, 1))


def write_png(path, width, height, rgb):
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows))
                     + chunk(b"IEND", b""))


def change(**fields):
    return lambda: probe.update(fields)


# Chosen by our own pictures, before Godot drew any: any two of them are at most 22 dB from each other over the ball. Godot does not smooth edges
# in a reflection, which alone keeps its pictures 33 dB from ours: an edit that moves little, a face far from the ball or another origin in a box
# that is the room (41 dB), could not be told from that.
edits = [("0 as it was", change()), ("1 a face dragged to the ball", change(box={"min": [-2, -2, -2], "max": [2, 2, 0.7]})),
         ("2 two more", change(box={"min": [-2, -0.7, -2], "max": [0.7, 2, 0.7]})),
         ("3 another box, turned", change(rotationDegrees=[0, 30, 0], box={"min": [-2, -0.7, -2], "max": [2, 2, 0.9]})),
         ("4 no projection", change(technique="infinite")),
         ("5 the first box again, another origin, half as bright",
          change(rotationDegrees=[0, 0, 0], technique="box", box={"min": [-2, -2, -2], "max": [2, 2, 2]}, origin=[0.3, 0.1, -0.2], intensity=0.5))]
said, failures = [], []
save()
exporter = subprocess.Popen([program, "export", str(scene_file), "-o", str(out / "live.glb"), "--format", "glb", "--watch", "--quiet"])
godot = subprocess.Popen([engine, "--path", str(out), "--audio-driver", "Dummy"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def listen():
    for line in godot.stdout:
        said.append(line.strip())
        if "SCRIPT ERROR" in line:
            failures.append(line)


threading.Thread(target=listen, daemon=True).start()


def wait(what, holds, seconds=120):
    begun = time.monotonic()
    while not holds():
        time.sleep(0.05)
        if exporter.poll() is not None or godot.poll() is not None or failures or time.monotonic() - begun > seconds:
            sys.exit("%s: FAILED; %s" % (what, "; ".join(failures + said[-3:])))


pictures = []
try:
    for number, (what, edit) in enumerate(edits):
        edit()
        if number > 0:
            save()
        wanted = {key: probe[key] for key in ("box", "origin", "rotationDegrees", "technique", "intensity") if key in probe}
        usual = {"rotationDegrees": [0, 0, 0], "technique": "box", "intensity": 1}
        wait(what, lambda: (now := glb_probe()) is not None and all(now.get(key, usual.get(key)) == value for key, value in wanted.items()))
        time.sleep(0.6)  # Godot looks ten times a second
        name = "edit-%d" % number
        subprocess.run([program, "render", str(scene_file), "-o", str(out / (name + "-ours.png")), "--camera", "main", "--size",
                        "%dx%d" % (WIDTH, HEIGHT), "--samples", "4", "--set", 'energy="multiple"', "--quiet"], check=True)
        (out / "request.new").write_text(json.dumps({"name": name, "ours": name + "-ours.png"}))
        (out / "request.new").rename(out / "request.json")
        wait(what, lambda: "boxprobe drawn " + name in said)
        pictures.append([(out / ("%s-%s.rgb" % (name, end))).read_bytes() for end in ("godot", "ours")])
finally:
    (out / "end.txt").write_text("")
    exporter.send_signal(signal.SIGINT)
    exporter.wait()
    try:
        godot.wait(10)
    except subprocess.TimeoutExpired:
        godot.kill()

where = ball_pixels()
rows = []
for number, (what, _) in enumerate(edits):
    to = [decibels(pictures[number][0], ours, where) for _, ours in pictures]
    others = max(value for index, value in enumerate(to) if index != number)
    print("%s: %.1f dB from ours, %.1f dB from the nearest other" % (what, to[number], others))
    if to[number] < LEAST or to[number] - others < APART:
        failures.append(what)
    for y in range(HEIGHT):
        rows += [picture[3 * WIDTH * y:3 * WIDTH * (y + 1)] for picture in pictures[number]]
write_png(out / "edits.png", 2 * WIDTH, HEIGHT * len(edits), b"".join(rows))
print("%s, %d pixels of the ball: at least %.0f dB, and %.0f dB nearer than to another edit"
      % (next((line for line in said if line.startswith("drawn by")), "godot3"), len(where), LEAST, APART))
if failures or len(where) < 1000:
    sys.exit("FAILED: %d of %d pictures do not follow" % (len(failures), len(edits)))
