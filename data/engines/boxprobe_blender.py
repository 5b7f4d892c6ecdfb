"""Boxprobe's probes in Blender: world light, and a light probe with influence and parallax box for EEVEE.

Exported with: boxprobe export SCENE -o DIR --format exr --ladder three
    blender --python boxprobe_blender.py -- DIR/room.json [more.json]

EEVEE captures by itself; the exported picture lights the world. glTF's +Y up becomes Blender's +Z up: (x, y, z) -> (x, -z, y).
"""
import json
import math
import sys
from pathlib import Path

import bpy
from mathutils import Matrix, Quaternion, Vector

TO_BLENDER = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))


def turn_of(probe):
    """Rotation of the box, in Blender's axes."""
    x, y, z, w = probe["rotationQuaternion"]
    return TO_BLENDER @ Quaternion((w, x, y, z)).to_matrix() @ TO_BLENDER.transposed()


def add_world(probe, folder):
    world = bpy.data.worlds.new(probe["name"])
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    background = nodes["Background"]
    background.inputs["Strength"].default_value = probe["intensity"]
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(str(folder / probe["file"]))
    picture.image.colorspace_settings.is_data = True  # linear, as it is
    mapping, coordinates = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexCoord")
    # The picture lies along the box's axes. Blender's middle is +X; a picture around +Z (its -Y) is a quarter turn away.
    quarter = Matrix.Rotation(0.0 if probe["latLong"]["center"] == "+X" else math.radians(90), 3, "Z")
    mapping.inputs["Rotation"].default_value = (quarter @ turn_of(probe).transposed()).to_euler("XYZ")
    links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
    links.new(picture.outputs["Color"], background.inputs["Color"])
    bpy.context.scene.world = world


def box_matrix(box, turn):
    """Of an object that reaches one unit to each side, so that it fills the box."""
    center = TO_BLENDER @ Vector(box["center"])
    size = box["size"]
    half = Matrix.Diagonal((0.5 * size[0], 0.5 * size[2], 0.5 * size[1], 1.0))
    return Matrix.Translation(center) @ turn.to_4x4() @ half


def add_probe(probe):
    data = bpy.data.lightprobes.new(probe["name"], "SPHERE" if bpy.app.version >= (4, 1, 0) else "CUBE")
    data.influence_type = "BOX"
    blend, smallest = max(probe["blendDistance"]["min"]), min(probe["influence"]["size"])
    data.falloff = min(2.0 * blend / smallest, 1.0) if smallest > 0 else 0.0
    data.use_custom_parallax = probe["projection"]
    data.parallax_type = "BOX"
    # One object has one transform for both boxes: its own is the projection box, and the influence a multiple of it.
    data.parallax_distance = 1.0
    ratios = [i / b for i, b in zip(probe["influence"]["size"], probe["box"]["size"]) if b > 0]
    data.influence_distance = max(ratios, default=1.0)
    placed = bpy.data.objects.new(probe["name"], data)
    placed.matrix_world = box_matrix(probe["box"], turn_of(probe))
    bpy.context.scene.collection.objects.link(placed)


def main(paths):
    for path in map(Path, paths):
        probe = json.loads(path.read_text())
        if probe.get("format") != "boxprobe-export" or "latLong" not in probe:
            sys.exit("%s: export it with --format exr" % path)
        add_world(probe, path.parent)
        add_probe(probe)


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
