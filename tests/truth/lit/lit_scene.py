# A lit scene in Cycles: geometry and pictures by Blender's own glTF importer; every surface, light and the sky rebuilt
# from the numbers in the .glb and the scene file, each as a form that both sides express exactly. Called by make.py; runs
# inside Blender.
import json
import math
import os
import struct

import bpy
import mathutils
import numpy
from truth_scene import Nodes, from_gltf, interface, linear, make_sky, metal, set_camera, set_cycles

ALL = 128  # bounces: at the largest albedo here, 0.85, a billionth of the light is left


def materials_of(path):
    """The materials of a .glb as it states them, by name."""
    with open(path, "rb") as file:
        data = file.read()
    (length,) = struct.unpack_from("<I", data, 12)
    return {m["name"]: m for m in json.loads(data[20 : 20 + length])["materials"]}


def extension(stated, name, key, default):
    return stated.get("extensions", {}).get("KHR_materials_" + name, {}).get(key, default)


def base_color(n, material, stated):
    """Socket or colour. A picture's bytes are decoded before they are interpolated, as graphics cards do."""
    pbr = stated["pbrMetallicRoughness"]
    factor = pbr["baseColorFactor"][:3]
    if "baseColorTexture" not in pbr:
        return None, factor
    if factor != [1, 1, 1]:
        raise SystemExit(f"make.py: material {material.name}: a factor on a picture has no form here")
    image = next(x.image for x in material.node_tree.nodes if x.type == "TEX_IMAGE")
    return linear(image), factor


def without_back(n, surface):
    """The back of a single-sided surface is not there."""
    side = n.add("ShaderNodeMixShader")
    n.link(n.add("ShaderNodeNewGeometry").outputs["Backfacing"], side.inputs["Fac"])
    n.link(surface, side.inputs[1])
    n.link(n.add("ShaderNodeBsdfTransparent").outputs[0], side.inputs[2])
    return side.outputs[0]


def make_surface(material, stated, overrides):
    """Lambert's law, a metal by Schlick's law, or the interface of a dielectric over black; and emission."""
    if overrides:
        raise SystemExit(f"make.py: material {material.name}: overrides have no form here")
    image, color = base_color(None, material, stated)
    pbr = stated["pbrMetallicRoughness"]
    metallic, roughness = pbr["metallicFactor"], pbr["roughnessFactor"]
    emission = [c * extension(stated, "emissive_strength", "emissiveStrength", 1.0) for c in stated.get("emissiveFactor", [0, 0, 0])]
    plain = extension(stated, "specular", "specularFactor", 1.0) == 0
    n = Nodes(material)
    if metallic == 1 and image is None:
        surface = metal(n, color, roughness)
    elif metallic == 0 and plain:
        diffuse = n.add("ShaderNodeBsdfDiffuse")  # roughness 0: Lambert's law
        diffuse.inputs["Color"].default_value = (*color, 1.0)
        if image is not None:
            picture = n.add("ShaderNodeTexImage", image=image, extension="REPEAT", interpolation="Linear")
            n.link(picture.outputs["Color"], diffuse.inputs["Color"])
        surface = diffuse.outputs[0]
    elif metallic == 0 and image is None and color == [0, 0, 0]:
        surface = metal(n, (interface(extension(stated, "ior", "ior", 1.5)),) * 3, roughness)
    else:
        raise SystemExit(f"make.py: material {material.name}: neither Lambert's law, nor a metal, nor an interface alone")
    if any(emission):
        light = n.add("ShaderNodeEmission")
        light.inputs["Color"].default_value = (*emission, 1.0)
        both = n.add("ShaderNodeAddShader")
        n.link(surface, both.inputs[0])
        n.link(light.outputs[0], both.inputs[1])
        surface = both.outputs[0]
        if stated.get("doubleSided"):
            material.cycles.emission_sampling = "FRONT_BACK"
        else:
            surface = without_back(n, surface)
            material.cycles.emission_sampling = "FRONT"
    else:
        material.cycles.emission_sampling = "NONE"
    n.link(surface, n.add("ShaderNodeOutputMaterial").inputs["Surface"])


def make_gradient(scene, sky):
    """From the horizon up and from the horizon down, linear in the direction's height."""
    world = bpy.data.worlds.new("sky")
    scene.world = world
    n = Nodes(world)
    height = n.add("ShaderNodeSeparateXYZ")
    n.link(n.add("ShaderNodeTexCoord").outputs["Generated"], height.inputs[0])
    down = n.add("ShaderNodeMath", operation="MULTIPLY")
    n.link(height.outputs["Z"], down.inputs[0])
    down.inputs[1].default_value = -1.0
    socket = None
    for share, end in ((height.outputs["Z"], "top"), (down.outputs[0], "ground")):
        mix = n.add("ShaderNodeMix", data_type="RGBA", clamp_factor=True)
        n.link(share, mix.inputs["Factor"])
        entries = [x for x in mix.inputs if x.type == "RGBA"]
        entries[1].default_value = (*sky[end], 1.0)
        if socket is None:
            entries[0].default_value = (*sky["horizon"], 1.0)
        else:
            n.link(socket, entries[0])
        socket = next(x for x in mix.outputs if x.type == "RGBA")
    background = n.add("ShaderNodeBackground")
    n.link(socket, background.inputs["Color"])
    n.link(background.outputs[0], n.add("ShaderNodeOutputWorld").inputs["Surface"])
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = 256


def turn_sky(world, degrees):
    """90 degrees take +Z of glTF to +X: in Blender's axes, -Y to +X."""
    turn = next((x for x in world.node_tree.nodes if x.type == "MAPPING"), None)
    if turn is not None:
        turn.inputs["Rotation"].default_value[2] -= math.radians(degrees)
    elif degrees:
        raise SystemExit("make.py: only a picture of a sky is turned")


def make_light(scene, light):
    kind = {"directional": "SUN", "point": "POINT", "spot": "SPOT"}[light["type"]]
    data = bpy.data.lights.new(kind, kind)
    data.color = light["color"]
    if kind == "SUN":
        data.energy = light["intensity"]  # irradiance on both sides
        data.angle = math.radians(light["angleDegrees"])
    else:
        data.energy = 4.0 * math.pi * light["intensity"]  # watts over the whole sphere, from watts per steradian
        data.shadow_soft_size = light["radius"]
        if hasattr(data, "use_soft_falloff"):  # from 4.0 on
            data.use_soft_falloff = False  # a sphere, however near
        if light.get("range", 0):
            raise SystemExit("make.py: a light's range has no form in Cycles")
    if kind == "SPOT":
        if light["outerConeDegrees"] - light["innerConeDegrees"] > 0.02:
            raise SystemExit("make.py: the edge of a spot's cone is another curve in Cycles; leave no room for it")
        data.spot_size = 2.0 * math.radians(light["outerConeDegrees"])
        data.spot_blend = 0.0
    thing = bpy.data.objects.new(kind, data)
    scene.collection.objects.link(thing)
    thing.location = from_gltf(light.get("position", (0, 0, 0)))
    if kind != "POINT":
        thing.rotation_euler = from_gltf(light["direction"]).to_track_quat("-Z", "Y").to_euler()


def make_portal(scene, portal):
    """Where sky light comes in: Cycles aims at it; it neither shines nor is seen."""
    data = bpy.data.lights.new("portal", "AREA")
    data.shape, data.size, data.size_y = "RECTANGLE", portal["width"], portal["height"]
    data.cycles.is_portal = True
    thing = bpy.data.objects.new("portal", data)
    scene.collection.objects.link(thing)
    thing.location = from_gltf(portal["middle"])
    thing.rotation_euler = from_gltf(portal["inwards"]).to_track_quat("-Z", "Y").to_euler()


def set_bounces(bounces):
    """`bounces` more after the first surface, or "all"."""
    c = bpy.context.scene.cycles
    count = ALL if bounces == "all" else bounces
    c.max_bounces = c.diffuse_bounces = c.glossy_bounces = c.transmission_bounces = count


def furnace(bounces, albedo):
    """Radiance in a closed box whose walls emit 1 and reflect `albedo`, by Cycles: what its bounces mean."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_cube_add(size=2)
    material = bpy.data.materials.new("wall")
    n = Nodes(material)
    both = n.add("ShaderNodeAddShader")
    diffuse = n.add("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (albedo, albedo, albedo, 1.0)
    n.link(diffuse.outputs[0], both.inputs[0])
    n.link(n.add("ShaderNodeEmission").outputs[0], both.inputs[1])
    n.link(both.outputs[0], n.add("ShaderNodeOutputMaterial").inputs["Surface"])
    bpy.context.object.data.materials.append(material)
    scene = bpy.context.scene
    make_sky(scene, {"color": [0, 0, 0]}, None)
    set_cycles(scene, 16, 16)
    scene.render.film_transparent = False
    set_camera({"position": [0.1, 0.2, 0.3], "target": [-0.5, -0.4, -0.8], "up": [0, 1, 0], "verticalFovDegrees": 60})
    set_bounces(bounces)


def load_scene(path, width, height, portals=()):
    """Returns the cameras."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with open(path) as file:
        described = json.load(file)
    if "objects" in described:
        raise SystemExit("make.py: changes to objects have no form here")
    folder = os.path.dirname(path)
    model = os.path.join(folder, described["model"])
    bpy.ops.import_scene.gltf(filepath=model)
    for thing in bpy.data.objects:
        # The importer's own remedies against facets that show; rays here meet triangles as they are.
        thing.cycles.shadow_terminator_offset = thing.cycles.shadow_terminator_geometry_offset = 0.0
    stated = materials_of(model)
    for material in bpy.data.materials:
        if material.users:
            make_surface(material, stated[material.name], described.get("materials", {}).get(material.name))
    scene = bpy.context.scene
    sky = described["sky"]
    if "top" in sky:
        make_gradient(scene, sky)
    else:
        make_sky(scene, sky, folder)
    turn_sky(scene.world, sky.get("rotationDegrees", 0))
    for light in described["lights"]:
        make_light(scene, light)
    for portal in portals:
        make_portal(scene, portal)
    set_cycles(scene, width, height)
    scene.render.film_transparent = False
    c = scene.cycles
    c.use_light_tree = True
    c.transparent_max_bounces = 64
    c.caustics_refractive = c.caustics_reflective = True
    return described["cameras"]
