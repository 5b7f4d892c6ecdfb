"""Pictures of Blender while a scene file is edited: EEVEE draws the mirror ball of six-faces.glb with the probes that
data/engines/boxprobe_blender_live.py keeps up to date, after each of five edits, beside ours.

usage: blender -b --factory-startup --python-exit-code 1 --python blender_draws_edits.py -- BOXPROBE SCENES OUT

Over the ball, in display values: each picture is at least LEAST dB from ours after the same edit, and at least APART dB nearer to it than to
ours after any other edit. EEVEE captures from the centre of the box, so each edit keeps the origin there.
"""
import importlib.util
import json
import math
import signal
import subprocess
import sys
import time
from pathlib import Path

import bpy
import numpy
from mathutils import Matrix, Vector

LEAST, APART = 20.0, 2.0
WIDTH, HEIGHT = 240, 150
if "bool" not in vars(numpy):
    numpy.bool = bool  # Debian 12: Blender's reader of glTF is older than its numpy
program, scenes, out = sys.argv[sys.argv.index("--") + 1:]
scenes, out = Path(scenes).resolve(), Path(out).resolve()
out.mkdir(parents=True, exist_ok=True)
script = Path(__file__).resolve().parents[2] / "data" / "engines" / "boxprobe_blender_live.py"
spec = importlib.util.spec_from_file_location("live", script)
live = importlib.util.module_from_spec(spec)
spec.loader.exec_module(live)

scene = json.loads((scenes / "six-faces.boxprobe.json").read_text())
scene["model"] = str(scenes / "six-faces.glb")
probe = scene["probes"][0]
probe["faceSize"] = 128
scene["cameras"]["main"]["verticalFovDegrees"] = 34  # the ball fills most of the picture's height
scene_file, glb = out / "edits.boxprobe.json", out / "edits.glb"
for old in (glb, out / "edits.glb.revision"):
    old.unlink(missing_ok=True)


def save():
    for each in scene["probes"]:
        each["origin"] = [(a + b) / 2 for a, b in zip(each["box"]["min"], each["box"]["max"])]
    fresh = out / "edits.boxprobe.json.new"
    fresh.write_text(json.dumps(scene))
    fresh.rename(scene_file)


def pixels(path):
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.is_data = True
    values = list(image.pixels)
    bpy.data.images.remove(image)
    return values


def prepare():
    """The model by Blender's own reader of glTF; the ball a mirror that no probe sees."""
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    bpy.ops.import_scene.gltf(filepath=str(scenes / "six-faces.glb"))
    ball = bpy.data.objects["ball"]
    # What the reader makes of unlit materials is seen by cameras alone, and not by probes.
    for material in bpy.data.materials:
        picture = next((node for node in material.node_tree.nodes if node.type == "TEX_IMAGE"), None) if material.use_nodes else None
        if picture is not None:
            emission = material.node_tree.nodes.new("ShaderNodeEmission")
            output = next(node for node in material.node_tree.nodes if node.type == "OUTPUT_MATERIAL")
            material.node_tree.links.new(picture.outputs["Color"], emission.inputs["Color"])
            material.node_tree.links.new(emission.outputs["Emission"], output.inputs["Surface"])
    hidden = bpy.data.collections.new("no probe sees these")
    bpy.context.scene.collection.children.link(hidden)
    hidden.objects.link(ball)
    data = bpy.data.cameras.new("camera")
    main = scene["cameras"]["main"]
    data.sensor_fit, data.angle, data.clip_start = "VERTICAL", math.radians(main["verticalFovDegrees"]), 0.01
    position, target, up = (live.TO_BLENDER @ Vector(main[key]) for key in ("position", "target", "up"))
    back = (position - target).normalized()
    right = up.cross(back).normalized()
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = Matrix.Translation(position) @ Matrix((right, back.cross(right), back)).transposed().to_4x4()
    bpy.context.scene.collection.objects.link(camera)
    s = bpy.context.scene
    s.camera, s.render.engine = camera, "BLENDER_EEVEE"
    s.eevee.taa_render_samples, s.eevee.use_ssr, s.eevee.use_soft_shadows = 8, False, False
    s.eevee.gi_cubemap_resolution, s.eevee.gi_diffuse_bounces, s.eevee.gi_glossy_clamp = "512", 1, 0.0
    s.world = bpy.data.worlds.new("black")
    s.world.use_nodes = True
    s.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    s.render.resolution_x, s.render.resolution_y, s.render.filter_size = WIDTH, HEIGHT, 0.5
    s.render.image_settings.file_format, s.render.image_settings.color_depth = "OPEN_EXR", "32"
    return hidden


def ball_pixels(radius):
    """Where the ball is drawn, less its rim: by the rays of the camera."""
    main = scene["cameras"]["main"]
    position, target, up = (Vector(main[key]) for key in ("position", "target", "up"))
    back = (position - target).normalized()
    right = up.cross(back).normalized()
    above = back.cross(right)
    half = math.tan(math.radians(main["verticalFovDegrees"]) / 2)
    found = []
    for y in range(HEIGHT):
        for x in range(WIDTH):
            u, v = (2 * (x + 0.5) / WIDTH - 1) * half * WIDTH / HEIGHT, (2 * (y + 0.5) / HEIGHT - 1) * half
            along = (right * u + above * v - back).normalized()
            nearest = (position + along * max(-position.dot(along), 0)).length
            if nearest < 0.9 * radius:
                found.append(y * WIDTH + x)
    return found


def display(linear):
    light = min(max(linear, 0.0), 1.0)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


def draw(name, hidden):
    for each in bpy.data.objects:
        if each.type == "LIGHT_PROBE":
            each.data.visibility_collection, each.data.invert_visibility_collection = hidden, True
    if bpy.ops.scene.light_cache_free.poll():
        bpy.ops.scene.light_cache_free()
    if "FINISHED" not in bpy.ops.scene.light_cache_bake():
        sys.exit("FAILED: EEVEE did not bake its probes")
    bpy.context.scene.render.filepath = str(out / (name + "-blender.exr"))
    bpy.ops.render.render(write_still=True)
    subprocess.run([program, "render", str(scene_file), "-o", str(out / (name + "-ours.exr")), "--camera", "main", "--size",
                    "%dx%d" % (WIDTH, HEIGHT), "--samples", "4", "--set", 'energy="multiple"', "--quiet"], check=True)
    return [[display(v) for v in pixels(out / (name + end))] for end in ("-blender.exr", "-ours.exr")]


def decibels(a, b, where):
    total = sum((a[4 * i + c] - b[4 * i + c]) ** 2 for i in where for c in range(3))
    return 10 * math.log10(3 * len(where) / max(total, 1e-12))


def drag(index, low=None, high=None):
    box = scene["probes"][index]["box"]
    box["min"], box["max"] = low or box["min"], high or box["max"]


def turn():
    probe["rotationDegrees"] = [0, 30, 0]


def add():
    scene["probes"].append({"name": "second", "box": {"min": [-1.6, -1.0, -1.4], "max": [1.2, 1.5, 1.3]}, "faceSize": 128, "blendDistance": 0,
                            "importance": 2})


def remove():
    del scene["probes"][0]
    drag(0, high=[3.2, 1.5, 1.3])


edits = [("0 as it was", lambda: None), ("1 a face dragged", lambda: drag(0, high=[4.4, 2, 2])),
         ("2 two more", lambda: drag(0, low=[-2, -1.0, -2], high=[4.4, 1.4, 2])), ("3 turned", turn), ("4 a second probe", add),
         ("5 the first removed, a face of the second dragged", remove)]
hidden = prepare()
radius = max(abs(v) for corner in bpy.data.objects["ball"].bound_box for v in corner)
where = ball_pixels(radius)
shown = []
follower = live.Follower(str(glb), lambda extension: shown.__setitem__(slice(None), extension["probes"]))


def followed():
    """Has Blender what the scene file says now?"""
    turns = [math.cos(math.radians(each.get("rotationDegrees", [0, 0, 0])[1]) / 2) for each in scene["probes"]]
    near = lambda a, b: all(abs(x - y) < 1e-4 for x, y in zip(a, b))
    return len(shown) == len(turns) and all(
        theirs["name"] == ours["name"] and near(theirs["origin"], ours["origin"]) and abs(abs(theirs["rotation"][3]) - turn) < 1e-4
        and all(near([b + o for b, o in zip(theirs["box"][end], theirs["origin"])], ours["box"][end]) for end in ("min", "max") if turn == 1)
        for theirs, ours, turn in zip(shown, scene["probes"], turns))


save()
exporter = subprocess.Popen([program, "export", str(scene_file), "-o", str(glb), "--format", "glb", "--watch", "--quiet"])
pictures, failures = [], 0
try:
    for number, (what, edit) in enumerate(edits):
        edit()
        if number > 0:
            save()
        begun = time.monotonic()
        while not followed():
            follower()
            time.sleep(0.02)
            if exporter.poll() is not None or time.monotonic() - begun > 120:
                sys.exit("%s: FAILED, not seen in Blender" % what)
        bpy.context.view_layer.update()
        pictures.append(draw("edit-%d" % number, hidden))
finally:
    exporter.send_signal(signal.SIGINT)
    exporter.wait()

for number, (what, _) in enumerate(edits):
    to = [decibels(pictures[number][0], ours, where) for _, ours in pictures]
    others = max(value for index, value in enumerate(to) if index != number)
    print("%s: %.1f dB from ours, %.1f dB from the nearest other" % (what, to[number], others))
    failures += to[number] < LEAST or to[number] - others < APART
sheet = bpy.data.images.new("sheet", 2 * WIDTH, len(edits) * HEIGHT)
values = []
for theirs, ours in reversed(pictures):  # the lowest row comes first
    for row in range(HEIGHT):
        for picture in (theirs, ours):
            values += [v if i % 4 < 3 else 1.0 for i, v in enumerate(picture[4 * WIDTH * row:4 * WIDTH * (row + 1)])]
sheet.pixels = values
sheet.filepath_raw, sheet.file_format = str(out / "edits.png"), "PNG"
sheet.save()
print("blender %s, %d pixels of the ball: at least %.0f dB, and %.0f dB nearer than to another edit" % (bpy.app.version_string, len(where), LEAST, APART))
if failures or len(where) < 1000:
    sys.exit("FAILED: %d of %d pictures do not follow" % (failures, len(edits)))
