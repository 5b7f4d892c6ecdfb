"""Blender takes an exported probe by the script that comes with it: Cycles' mirror ball in that world against ours.

usage: blender -b --factory-startup --python-exit-code 1 --python blender_reads_probes.py -- BOXPROBE SCENES OUT
"""
import importlib.util
import json
import math
import subprocess
import sys
from pathlib import Path

import bpy
from mathutils import Matrix, Vector

WIDTH, HEIGHT, LEAST = 480, 300, 30.0
program, scenes, out = sys.argv[sys.argv.index("--") + 1:]
scenes, out = Path(scenes), Path(out).resolve()
out.mkdir(parents=True, exist_ok=True)
scene_file = scenes / "six-faces.boxprobe.json"


def boxprobe(*arguments):
    subprocess.run([program, *map(str, arguments), "--quiet"], check=True)


def pixels(path):
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.is_data = True
    return list(image.pixels)


def draw(camera_json):
    """The ball of the scene, a mirror, from the same place; a transparent film leaves the rest out."""
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=ball_radius())
    bpy.ops.object.shade_smooth()
    material = bpy.data.materials.new("mirror")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value, surface["Metallic"].default_value, surface["Roughness"].default_value = (1, 1, 1, 1), 1, 0
    bpy.context.object.data.materials.append(material)
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle, data.clip_start = "VERTICAL", math.radians(camera_json["verticalFovDegrees"]), 0.01
    turn = module.TO_BLENDER
    position, target, up = (turn @ Vector(camera_json[key]) for key in ("position", "target", "up"))
    back = (position - target).normalized()
    right = up.cross(back).normalized()
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = Matrix.Translation(position) @ Matrix((right, back.cross(right), back)).transposed().to_4x4()
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 16, False
    scene.cycles.pixel_filter_type, scene.render.film_transparent = "BOX", True
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = str(out / "blender.exr")
    bpy.ops.render.render(write_still=True)


def ball_radius():
    data = (scenes / "six-faces.glb").read_bytes()
    gltf = json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
    node = next(node for node in gltf["nodes"] if node["name"] == "ball")
    position = gltf["meshes"][node["mesh"]]["primitives"][0]["attributes"]["POSITION"]
    return gltf["accessors"][position]["max"][1]


boxprobe("export", scene_file, "-o", out, "--format", "exr", "--ladder", "three")
specification = importlib.util.spec_from_file_location("boxprobe_blender", out / "boxprobe_blender.py")
module = importlib.util.module_from_spec(specification)
specification.loader.exec_module(module)
module.main([out / "cube.json"])

description = json.loads((out / "cube.json").read_text())
light_probe = bpy.data.objects["cube"]
corner = light_probe.matrix_world @ Vector((1, 1, 1))
half = 0.5 * Vector(description["box"]["size"])
assert (corner - Vector((half.x, half.z, half.y))).length < 1e-5, corner
assert light_probe.data.use_custom_parallax and light_probe.data.parallax_type == "BOX"

boxprobe("render", scene_file, "-o", out / "boxprobe.exr", "--size", "%dx%d" % (WIDTH, HEIGHT), "--camera", "main", "--technique", "infinite",
         "--samples", "4", "--set", "materials.ball.roughness=0", "--set", 'energy="multiple"')
draw(json.loads(scene_file.read_text())["cameras"]["main"])


def display(linear):
    """0 to 1, by the curve of sRGB."""
    light = min(max(linear, 0.0), 1.0)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


theirs, ours = pixels(out / "blender.exr"), pixels(out / "boxprobe.exr")
total, count = 0.0, 0
shown = [[0.0] * 3 + [1.0] for _ in range(2 * WIDTH * HEIGHT)]  # ours and theirs side by side, where Blender drew the ball
for i in range(0, len(theirs), 4):
    if theirs[i + 3] < 0.999:
        continue
    count += 3
    at = i // 4 // WIDTH * 2 * WIDTH + i // 4 % WIDTH
    for c in range(3):
        shown[at][c] = display(ours[i + c])
        shown[at + WIDTH][c] = display(theirs[i + c])
        total += (shown[at + WIDTH][c] - shown[at][c]) ** 2
sheet = bpy.data.images.new("sheet", 2 * WIDTH, HEIGHT)
sheet.pixels = [value for pixel in shown for value in pixel]
sheet.filepath_raw, sheet.file_format = str(out / "sheet.png"), "PNG"
sheet.save()
decibels = 10 * math.log10(count / max(total, 1e-12))
print("blender %s: %.1f dB over %d pixels (at least %.0f)" % (bpy.app.version_string, decibels, count // 3, LEAST))
(out / "sheet.json").write_text(json.dumps({
    "engine": "blender " + bpy.app.version_string, "view": "ball", "db": decibels, "pixels": count // 3, "least": LEAST,
    "left": "16 samples per pixel; a latitude-longitude picture in place of a cube", "renderer": "Cycles", "picture": "sheet.png", "parts": 2}))
if count < 3000 or decibels < LEAST:
    sys.exit("the mirror ball in Blender differs")
