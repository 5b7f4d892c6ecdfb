# A truth scene in Cycles: the model by Blender's own glTF importer, everything but the floor rebuilt as light alone, the
# floor as a single-scatter GGX surface. Called by make.py; runs inside Blender.
import json
import math
import os

import bpy
import mathutils
import numpy

FLOOR = "floor"


def from_gltf(v):
    """glTF's axes (Y up) to Blender's (Z up), as the importer turns the model."""
    return mathutils.Vector((v[0], -v[2], v[1]))


class Nodes:
    """The nodes of a material or world, emptied."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()

    def add(self, kind, **values):
        node = self.tree.nodes.new(kind)
        for name, value in values.items():
            setattr(node, name, value)
        return node

    def link(self, output, entry):
        self.tree.links.new(output, entry)


def linear(image):
    """The picture with its sRGB bytes decoded. Cycles itself would decode after it has interpolated; the scenes want it
    before, as graphics cards do."""
    width, height = image.size
    texels = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(texels)
    texels = texels.reshape(-1, 4)
    c = texels[:, :3]
    texels[:, :3] = numpy.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    made = bpy.data.images.new(image.name + " linear", width, height, float_buffer=True, is_data=True)
    made.pixels.foreach_set(texels.reshape(-1))
    made.update()
    return made


def make_emission(material):
    """Nothing but light: of the imported material, its unlit picture or its emission."""
    nodes = material.node_tree.nodes
    texture = next((n for n in nodes if n.type == "TEX_IMAGE"), None)
    principled = next((n for n in nodes if n.type == "BSDF_PRINCIPLED"), None)
    if texture is None and principled is None:
        raise SystemExit(f"make.py: material {material.name}: neither a picture nor a lamp")
    image, extension, color, strength = None, None, None, 1.0
    if texture is not None:
        image, extension = linear(texture.image), texture.extension
    else:
        color = tuple(principled.inputs["Emission Color"].default_value)
        strength = principled.inputs["Emission Strength"].default_value
    n = Nodes(material)
    emission = n.add("ShaderNodeEmission")
    emission.inputs["Strength"].default_value = strength
    if image is not None:
        picture = n.add("ShaderNodeTexImage", image=image, extension=extension, interpolation="Linear")
        n.link(picture.outputs["Color"], emission.inputs["Color"])
    else:
        emission.inputs["Color"].default_value = color
    n.link(emission.outputs[0], n.add("ShaderNodeOutputMaterial").inputs["Surface"])
    # Lamps are drawn towards and found by the lobe's own rays, weighed by multiple importance sampling. Walls surround
    # the floor: the lobe's rays find them best.
    material.cycles.emission_sampling = "FRONT_BACK" if image is None else "NONE"


def metal(n, color, roughness):
    """A microfacet surface whose Fresnel law is Schlick's from `color` to 1: the F82 model of a metal with a white edge
    tint is that. A dielectric's interface of F0 = .04 is one as well."""
    node = n.add("ShaderNodeBsdfPrincipled", distribution="GGX")  # single scattering
    node.inputs["Base Color"].default_value = (*color, 1.0)
    node.inputs["Metallic"].default_value = 1.0
    node.inputs["Specular Tint"].default_value = (1.0, 1.0, 1.0, 1.0)
    node.inputs["Roughness"].default_value = roughness
    return node.outputs[0]


def interface(ior):
    return ((ior - 1.0) / (ior + 1.0)) ** 2


def make_floor(material, kind, roughness):
    """A metal, or the interface of a dielectric, which is that of a clear coat as well."""
    n = Nodes(material)
    f0 = kind["baseColor"] if kind["metallic"] == 1 else (interface(kind["ior"]),) * 3
    n.link(metal(n, f0, roughness), n.add("ShaderNodeOutputMaterial").inputs["Surface"])


def make_sky(scene, sky, folder):
    world = bpy.data.worlds.new("sky")
    scene.world = world
    n = Nodes(world)
    background = n.add("ShaderNodeBackground")
    if "image" in sky:
        image = bpy.data.images.load(os.path.join(folder, sky["image"]))
        image.colorspace_settings.name = "Non-Color"  # linear as it is
        picture = n.add("ShaderNodeTexEnvironment", image=image, interpolation="Linear")
        # The middle of the picture is +Z of glTF; Blender has its own +X there, which is glTF's +X.
        turn = n.add("ShaderNodeMapping")
        turn.inputs["Rotation"].default_value = (0.0, 0.0, math.radians(90.0))
        n.link(n.add("ShaderNodeTexCoord").outputs["Generated"], turn.inputs["Vector"])
        n.link(turn.outputs[0], picture.inputs["Vector"])
        n.link(picture.outputs["Color"], background.inputs["Color"])
        world.cycles.sampling_method = "MANUAL"
        world.cycles.sample_map_resolution = 1024
    else:
        background.inputs["Color"].default_value = (*sky["color"], 1.0)
        world.cycles.sampling_method = "NONE"
    n.link(background.outputs[0], n.add("ShaderNodeOutputWorld").inputs["Surface"])


def set_cycles(scene, width, height):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.film_transparent = True
    scene.render.use_persistent_data = True
    scene.view_settings.view_transform = "Raw"
    c = scene.cycles
    c.device = "CPU"
    c.use_adaptive_sampling = c.use_denoising = False
    c.pixel_filter_type, c.filter_width = "BOX", 1.0
    c.max_bounces = c.glossy_bounces = 1  # the floor, and what it reflects
    c.diffuse_bounces = c.transmission_bounces = c.volume_bounces = c.transparent_max_bounces = 0
    c.sample_clamp_direct = c.sample_clamp_indirect = 0.0
    c.blur_glossy = 0.0
    c.caustics_reflective = True
    c.use_light_tree = False
    c.light_sampling_threshold = 0.0


def load_scene(path, width, height):
    """Returns the floor's material."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with open(path) as file:
        described = json.load(file)
    folder = os.path.dirname(path)
    bpy.ops.import_scene.gltf(filepath=os.path.join(folder, described["model"]))
    for name, changes in described["objects"].items():
        if not changes.get("visible", True):
            bpy.data.objects.remove(bpy.data.objects[name])
    for thing in bpy.data.objects:
        if thing.name == FLOOR:  # the camera alone sees it
            for ray in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow"):
                setattr(thing, "visible_" + ray, False)
    for material in bpy.data.materials:
        if material.name != FLOOR and material.users:
            make_emission(material)
    scene = bpy.context.scene
    make_sky(scene, described["sky"], folder)
    set_cycles(scene, width, height)
    return bpy.data.materials[FLOOR], described["cameras"]


def set_camera(camera):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(camera["verticalFovDegrees"])
    data.clip_start = 0.001
    thing = bpy.data.objects.new("camera", data)
    bpy.context.scene.collection.objects.link(thing)
    eye = from_gltf(camera["position"])
    back = (eye - from_gltf(camera["target"])).normalized()
    right = from_gltf(camera["up"]).cross(back).normalized()
    turn = mathutils.Matrix((right, back.cross(right), back)).transposed().to_4x4()
    thing.matrix_world = mathutils.Matrix.Translation(eye) @ turn
    bpy.context.scene.camera = thing


def show_floor_alone(alone):
    """Alone: everything else is black with alpha 0 where the camera sees it, and shows in the floor all the same."""
    for thing in bpy.data.objects:
        thing.is_holdout = alone and thing.type == "MESH" and thing.name != FLOOR
    bpy.context.scene.render.film_transparent = alone


def render(samples, seed, path):
    """Linear RGBA, alpha premultiplied, rows from the bottom."""
    scene = bpy.context.scene
    scene.cycles.samples, scene.cycles.seed = samples, seed
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path, check_existing=False)
    width, height = image.size
    pixels = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    os.remove(path)
    return pixels.reshape(height, width, 4).astype(numpy.float64)


def write_half(pixels, path, channels="RGBA"):
    scene = bpy.context.scene
    height, width = pixels.shape[:2]
    image = bpy.data.images.new("mean", width, height, alpha=True, float_buffer=True, is_data=True)
    image.alpha_mode = "PREMUL"
    image.pixels.foreach_set(pixels.astype(numpy.float32).reshape(-1))
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", channels, "16"
    settings.exr_codec = "ZIP"
    image.save_render(path, scene=scene)
    bpy.data.images.remove(image)
