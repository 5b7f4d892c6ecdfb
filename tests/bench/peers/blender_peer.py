"""The scene of FOLDER/config.json in Blender's Eevee: light cache of one reflection cube map, then frames of a rendered viewport.

usage: blender --factory-startup --python blender_peer.py -- FOLDER        needs a window (draw_view3d), and so a display
"""
import json
import os
import sys
import time
from pathlib import Path

import bpy
import gpu
from mathutils import Euler, Matrix, Vector

folder = Path(sys.argv[sys.argv.index("--") + 1])
config = json.loads((folder / "config.json").read_text())
width, height = config["width"], config["height"]


def picture_node(nodes, name, data=False):
    node = nodes.new("ShaderNodeTexEnvironment" if data else "ShaderNodeTexImage")
    node.image = bpy.data.images.load(str(folder / name))
    return node


def product(nodes, links, node, factor):
    """Texture times colour, as glTF has it."""
    mix = nodes.new("ShaderNodeMixRGB")
    mix.blend_type, mix.inputs[0].default_value, mix.inputs[2].default_value = "MULTIPLY", 1, (*factor, 1)
    links.new(node.outputs["Color"], mix.inputs[1])
    return mix.outputs[0]


def material(index, source):
    result = bpy.data.materials.new("material %d" % index)
    result.use_nodes = True
    nodes, links = result.node_tree.nodes, result.node_tree.links
    surface = nodes["Principled BSDF"].inputs
    if source["unlit"]:
        surface = nodes.new("ShaderNodeEmission")
        links.new(surface.outputs[0], nodes["Material Output"].inputs["Surface"])
        color = surface.inputs["Color"]
    else:
        color = surface["Base Color"]
        surface["Metallic"].default_value, surface["Roughness"].default_value = source["metallic"], source["roughness"]
        surface["Emission"].default_value = (*source["emissive"], 1)
    color.default_value = (*source["color"], 1)
    if source["texture"]:
        links.new(product(nodes, links, picture_node(nodes, source["texture"]), source["color"]), color)
    if source["emissiveTexture"]:
        links.new(product(nodes, links, picture_node(nodes, source["emissiveTexture"]), source["emissive"]), surface["Emission"])
    return result


def triples(values, count=3):
    return [tuple(values[i:i + count]) for i in range(0, len(values), count)]


def add_mesh(source, materials):
    data = bpy.data.meshes.new(source["name"])
    data.from_pydata(triples(source["positions"]), [], triples(source["indices"]))
    layer = data.uv_layers.new()
    coordinates = triples(source["coordinates"], 2)
    for loop in data.loops:
        u, v = coordinates[loop.vertex_index]
        layer.data[loop.index].uv = (u, 1 - v)
    for polygon in data.polygons:
        polygon.use_smooth = True
    data.use_auto_smooth = True
    data.normals_split_custom_set_from_vertices(triples(source["normals"]))
    data.materials.append(materials[source["material"]])
    added = bpy.data.objects.new(source["name"], data)
    bpy.context.scene.collection.objects.link(added)
    return added


def light_scene(scene):
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    if config["sky"]:
        # Our y axis is up, Blender's pictures have z up.
        place, turn = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeMapping")
        turn.inputs["Rotation"].default_value = (1.5707963, 0, 0)
        sky = picture_node(nodes, config["sky"], True)
        links.new(place.outputs["Generated"], turn.inputs["Vector"])
        links.new(turn.outputs["Vector"], sky.inputs["Vector"])
        links.new(sky.outputs["Color"], nodes["Background"].inputs["Color"])
    for source in config["lights"]:
        sun = bpy.data.lights.new("sun", "SUN")
        sun.energy, sun.color, sun.use_shadow = source["intensity"], source["color"], False
        added = bpy.data.objects.new("sun", sun)
        added.rotation_mode = "QUATERNION"
        added.rotation_quaternion = Vector(source["direction"]).to_track_quat("-Z", "Y")
        scene.collection.objects.link(added)


def place_probe(scene):
    """A cube map with the box of ours as parallax volume; its influence reaches beyond the surfaces that lie in the box's faces."""
    source = config["probe"]
    low, high = Vector(source["box"]["min"]), Vector(source["box"]["max"])
    data = bpy.data.lightprobes.new("probe", "CUBE")
    data.influence_type = data.parallax_type = "BOX"
    data.influence_distance, data.falloff, data.use_custom_parallax, data.parallax_distance = 1.05, 0, True, 1
    data.clip_start, data.clip_end = 0.01, 1000
    added = bpy.data.objects.new("probe", data)
    # Its box is about its origin, so the probe stands in the middle of the box.
    added.matrix_world = Matrix.Translation(0.5 * (low + high)) @ Matrix.Diagonal((*(0.5 * (high - low)), 1))
    scene.collection.objects.link(added)


def view_matrices():
    camera = config["camera"]
    position, target, up = (Vector(camera[key]) for key in ("position", "target", "up"))
    back = (position - target).normalized()
    right = up.cross(back).normalized()
    world = Matrix.Translation(position) @ Matrix((right, back.cross(right), back)).transposed().to_4x4()
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle, data.clip_start, data.clip_end = "VERTICAL", 0.01745329252 * camera["verticalFovDegrees"], 0.01, 1000
    item = bpy.data.objects.new("camera", data)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item
    return world.inverted(), item.calc_matrix_camera(bpy.context.evaluated_depsgraph_get(), x=width, y=height)


def clock():
    return time.process_time()


def main():
    scene = bpy.context.scene
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    scene.render.engine = "BLENDER_EEVEE"
    scene.view_settings.view_transform = "Standard"
    eevee = scene.eevee
    eevee.taa_samples = config["samples"]
    eevee.gi_cubemap_resolution, eevee.gi_diffuse_bounces = str(config["probe"]["faceSize"]), 0
    materials = [material(index, source) for index, source in enumerate(config["materials"])]
    added = [add_mesh(source, materials) for source in config["meshes"]]
    light_scene(scene)
    place_probe(scene)
    unseen = [item for item, source in zip(added, config["meshes"]) if not source["seenByProbes"]]
    area = next(area for area in bpy.context.window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    space = area.spaces.active
    space.shading.type, space.overlay.show_overlays = "RENDERED", False
    space.shading.use_scene_lights_render = space.shading.use_scene_world_render = True
    view, projection = view_matrices()
    bpy.context.view_layer.update()
    target = gpu.types.GPUOffScreen(width, height)

    def draw():
        target.draw_view3d(scene, bpy.context.view_layer, space, region, view, projection, do_color_management=True)

    def read():
        return target.texture_color.read()

    for item in unseen:
        item.hide_render = True  # from the bake; the viewport shows them
    before = clock()
    bpy.ops.scene.light_cache_bake("EXEC_DEFAULT")
    captured = clock()
    draw()
    pixels = read()
    picture = clock()
    for _ in range(5):
        draw()
    read()
    warm = clock()
    for _ in range(config["frames"]):
        draw()
        read()
    end = clock()
    pixels.dimensions = width * height * 4
    image = bpy.data.images.new("picture", width, height, alpha=True)
    image.pixels = [value / 255 for value in pixels]
    image.filepath_raw, image.file_format = str(folder / "picture.png"), "PNG"
    image.save()
    (folder / "result.json").write_text(json.dumps({
        "start": picture, "capture": captured - before, "frame": (end - warm) / config["frames"], "renderer": gpu.platform.renderer_get()}))


try:
    main()
except Exception:
    import traceback
    traceback.print_exc()
    sys.stdout.flush()
    os._exit(1)
sys.stdout.flush()
os._exit(0)
