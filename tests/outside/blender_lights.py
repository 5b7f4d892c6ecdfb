"""A scene file in Blender 3.4, its surfaces as glTF has them: for Cycles as it is, for EEVEE with what an artist would add.

Called by blender_sheet.py, inside Blender. Lights, sky and camera are those of the lit scenes' judge, tests/truth.
"""
import json
import math
import struct
import sys
import time
import zlib
from pathlib import Path

import bpy
import numpy
from mathutils import Vector

numpy.bool, numpy.int, numpy.float = bool, int, float  # the importer of 3.4 has their names of before numpy 1.24

sys.dont_write_bytecode = True
TRUTH = Path(__file__).resolve().parents[1] / "truth"
sys.path[:0] = [str(TRUTH), str(TRUTH / "lit")]
from lit_scene import extension, make_gradient, make_light, make_portal, materials_of, set_bounces, turn_sky  # noqa: E402
from truth_scene import from_gltf, make_sky, set_camera  # noqa: E402

NODE_DISTANCE = 1.0  # metres between nodes of EEVEE's irradiance volumes
LAMP_GAP = 0.003  # metres between a shining surface and the lamp that lights for it in EEVEE


def shines(stated):
    return [c * extension(stated, "emissive_strength", "emissiveStrength", 1.0) for c in stated.get("emissiveFactor", [0, 0, 0])]


def entry(tree, principled, name, target):
    """What the importer put into one entry, number or link, goes into another."""
    source = principled.inputs[name]
    if source.is_linked:
        tree.links.new(source.links[0].from_socket, target)
    else:
        target.default_value = source.default_value


def make_surface(material, stated):
    """Lambert's law under the interface of a dielectric, or a metal. Sheen and anisotropy have no equal there and are left out."""
    if "KHR_materials_unlit" in stated.get("extensions", {}):
        return
    tree = material.node_tree
    principled = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    principled.inputs["Specular"].default_value = 0.5 * extension(stated, "specular", "specularFactor", 1.0)
    for link in list(principled.inputs["Specular"].links):
        tree.links.remove(link)
    for name in ("Sheen", "Clearcoat"):
        principled.inputs[name].default_value = 0.0
    emission = shines(stated)
    if any(emission) and not stated.get("emissiveTexture"):
        for link in list(principled.inputs["Emission"].links):
            tree.links.remove(link)
        principled.inputs["Emission"].default_value = (*emission, 1.0)
        principled.inputs["Emission Strength"].default_value = 1.0
    surface = principled.outputs[0]
    if stated.get("pbrMetallicRoughness", {}).get("metallicFactor", 1.0) == 0:
        surface = layered(tree, principled, extension(stated, "specular", "specularFactor", 1.0))
    if any(emission):
        material.cycles.emission_sampling = "FRONT_BACK" if stated.get("doubleSided") else "FRONT"
    if any(emission) and not stated.get("doubleSided"):
        side = tree.nodes.new("ShaderNodeMixShader")  # the back of a lamp is not there
        tree.links.new(tree.nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], side.inputs["Fac"])
        tree.links.new(surface, side.inputs[1])
        tree.links.new(tree.nodes.new("ShaderNodeBsdfTransparent").outputs[0], side.inputs[2])
        surface = side.outputs[0]
        material.blend_method = "HASHED"
    tree.links.new(surface, output.inputs["Surface"])


def layered(tree, principled, specular):
    """Blender's own diffuse surface is Disney's; glTF's is Lambert's, less what the interface above it reflects."""
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    entry(tree, principled, "Base Color", diffuse.inputs["Color"])
    if principled.inputs["Normal"].is_linked:
        entry(tree, principled, "Normal", diffuse.inputs["Normal"])
    black = tree.nodes.new("ShaderNodeBsdfPrincipled")
    black.distribution = "GGX"
    black.inputs["Base Color"].default_value = (0, 0, 0, 1)
    black.inputs["Specular"].default_value = 0.5 * specular
    entry(tree, principled, "Roughness", black.inputs["Roughness"])
    entry(tree, principled, "Emission", black.inputs["Emission"])
    entry(tree, principled, "Emission Strength", black.inputs["Emission Strength"])
    if principled.inputs["Normal"].is_linked:
        entry(tree, principled, "Normal", black.inputs["Normal"])
    if specular == 0 and not principled.inputs["Emission"].is_linked and not any(principled.inputs["Emission"].default_value[:3]):
        return diffuse.outputs[0]
    fresnel = tree.nodes.new("ShaderNodeFresnel")
    fresnel.inputs["IOR"].default_value = 1.5
    share = tree.nodes.new("ShaderNodeMath")
    share.operation = "MULTIPLY"
    tree.links.new(fresnel.outputs[0], share.inputs[0])
    share.inputs[1].default_value = specular
    empty = tree.nodes.new("ShaderNodeBsdfDiffuse")
    empty.inputs["Color"].default_value = (0, 0, 0, 1)
    less = tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(share.outputs[0], less.inputs["Fac"])
    tree.links.new(diffuse.outputs[0], less.inputs[1])
    tree.links.new(empty.outputs[0], less.inputs[2])
    both = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(less.outputs[0], both.inputs[0])
    tree.links.new(black.outputs[0], both.inputs[1])
    return both.outputs[0]


def load(path, portals):
    """The scene file, its model and all of its light. Returns what the file says."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    import addon_utils
    addon_utils.enable("io_scene_gltf2")
    described = json.loads(path.read_text())
    model = path.parent / described["model"]
    bpy.ops.import_scene.gltf(filepath=str(model))
    for thing in list(bpy.data.objects):
        if thing.type in ("LIGHT", "CAMERA"):
            bpy.data.objects.remove(thing)
        else:
            thing.cycles.shadow_terminator_offset = thing.cycles.shadow_terminator_geometry_offset = 0.0
    stated = materials_of(model)
    for material in bpy.data.materials:
        if material.users and material.name in stated:
            make_surface(material, stated[material.name])
    scene, sky = bpy.context.scene, described["sky"]
    if "top" in sky:
        make_gradient(scene, sky)
    else:
        make_sky(scene, sky, str(path.parent))
    turn_sky(scene.world, sky.get("rotationDegrees", 0))
    for light in described.get("lights", []):
        make_light(scene, light)
    for portal in portals:
        make_portal(scene, portal)
    scene.view_settings.view_transform = "Raw"
    return described, stated


def draw(path):
    """Linear RGB, rows from the bottom."""
    scene = bpy.context.scene
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return read(path)


def read(path):
    """Blender shows no picture whose file has channels beside RGBA, as those of reference-path have: that is read here."""
    image = bpy.data.images.load(str(path), check_existing=False)
    image.colorspace_settings.is_data = True
    width, height = image.size
    if width == 0:
        bpy.data.images.remove(image)
        return read_zip(path)
    pixels = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[..., :3].astype(numpy.float64)


def read_zip(path):
    """RGB, rows from the bottom, of an EXR of 32-bit floats in ZIP blocks of 16 rows."""
    data = path.read_bytes()
    at, attributes = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)[0], data[at:].split(b"\0", 2)[1], at
        rest += len(name) + len(kind) + 2
        (size,) = struct.unpack_from("<i", data, rest)
        attributes[name] = data[rest + 4 : rest + 4 + size]
        at = rest + 4 + size
    if attributes[b"compression"][0] != 3:
        raise SystemExit("%s: not in ZIP blocks" % path)
    names, channels = [], attributes[b"channels"]
    while channels[0]:
        name, channels = channels.split(b"\0", 1)
        names.append(name)
        channels = channels[16:]
    left, low, right, high = struct.unpack("<4i", attributes[b"dataWindow"])
    width, height = right - left + 1, high - low + 1
    made = numpy.zeros((height, len(names), width), numpy.float32)
    for offset in struct.unpack_from("<%dq" % -(-height // 16), data, at + 1):
        row, size = struct.unpack_from("<2i", data, offset)
        rows = min(16, height - (row - low))
        block = data[offset + 8 : offset + 8 + size]
        if size < rows * len(names) * width * 4:
            steps = numpy.frombuffer(zlib.decompress(block), numpy.uint8).astype(numpy.int64)
            steps[1:] -= 128
            halves = (numpy.cumsum(steps) & 255).astype(numpy.uint8)
            middle = (len(halves) + 1) // 2
            block = numpy.empty_like(halves)
            block[0::2], block[1::2] = halves[:middle], halves[middle:]
        made[row - low : row - low + rows] = numpy.frombuffer(bytes(block), numpy.float32).reshape(rows, len(names), width)
    picked = [made[:, names.index(name)] for name in (b"R", b"G", b"B")]
    return numpy.stack(picked, axis=2)[::-1].astype(numpy.float64)


def cycles(width, height, samples):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.use_persistent_data = True
    c = scene.cycles
    c.device, c.samples = "CPU", samples
    c.use_adaptive_sampling = c.use_denoising = False
    c.pixel_filter_type, c.filter_width = "BOX", 1.0
    c.transparent_max_bounces = 64
    c.sample_clamp_direct = c.sample_clamp_indirect = c.blur_glossy = c.light_sampling_threshold = 0.0
    c.caustics_refractive = c.caustics_reflective = True
    set_bounces("all")


def add_lamp(thing, faces, emission, lamps):
    """A lamp in the place of shining faces, of their power: a rectangle where they are flat, else a ball."""
    world = thing.matrix_world
    points = [world @ thing.data.vertices[v].co for f in faces for v in f.vertices]
    area, normal, middle = 0.0, Vector((0, 0, 0)), Vector((0, 0, 0))
    for f in faces:
        corners = [world @ thing.data.vertices[v].co for v in f.vertices]
        for i in range(1, len(corners) - 1):
            cross = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0])
            area += 0.5 * cross.length
            normal += 0.5 * cross
            middle += 0.5 * cross.length * (corners[0] + corners[i] + corners[i + 1]) / 3
    if area <= 0:
        return
    middle /= area
    peak = max(emission)
    flat = normal.length > 0.999 * area
    data = bpy.data.lights.new("lamp", "AREA" if flat else "POINT")
    data.color = [c / peak for c in emission]
    data.energy = math.pi * area * peak
    data.use_contact_shadow = False
    data.shadow_buffer_clip_start = 0.01
    made = bpy.data.objects.new("lamp", data)
    if flat:
        normal.normalize()
        turn = (-normal).to_track_quat("Z", "Y")
        local = [turn.inverted() @ (p - middle) for p in points]
        data.shape = "RECTANGLE"
        data.size, data.size_y = (max(0.001, max(p[i] for p in local) - min(p[i] for p in local)) for i in range(2))
        made.rotation_euler = turn.to_euler()
        made.location = middle + LAMP_GAP * normal
    else:
        data.shadow_soft_size = math.sqrt(area / (4 * math.pi))
        made.location = middle
    bpy.context.scene.collection.objects.link(made)
    lamps.append(made)


def islands(mesh, faces):
    """Faces that share corners by place, apart."""
    left, groups = list(faces), []
    key = lambda v: tuple(round(c, 5) for c in mesh.vertices[v].co)
    while left:
        group, corners = [left.pop()], set()
        corners.update(map(key, group[0].vertices))
        grown = True
        while grown:
            near = [f for f in left if any(key(v) in corners for v in f.vertices)]
            grown = bool(near)
            for f in near:
                left.remove(f)
                group.append(f)
                corners.update(map(key, f.vertices))
        groups.append(group)
    return groups


def eevee(described, stated, width, height, cubemap="256", node_distance=NODE_DISTANCE):
    """Lamps where surfaces shine, an irradiance volume and a reflection cubemap for each probe; baked. Returns seconds."""
    scene = bpy.context.scene
    scene.render.engine = "BLENDER_EEVEE"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.filter_size = 1.0
    e = scene.eevee
    e.taa_render_samples, e.use_soft_shadows, e.light_threshold = 64, True, 0.001
    e.use_ssr, e.use_ssr_halfres, e.ssr_max_roughness = True, False, 1.0
    e.gi_diffuse_bounces, e.gi_cubemap_resolution, e.gi_visibility_resolution, e.gi_irradiance_smoothing = 3, cubemap, "32", 0.1
    e.shadow_cube_size, e.shadow_cascade_size, e.use_shadow_high_bitdepth = "1024", "2048", True
    e.gi_glossy_clamp = 0.0
    for light in bpy.data.lights:
        if light.type in ("POINT", "SPOT") and light.shadow_soft_size == 0:
            light.specular_factor = 0.0  # mirrors would show it as a disc
    lit, unlit = [], bpy.data.collections.new("not baked")
    scene.collection.children.link(unlit)
    for thing in [o for o in scene.objects if o.type == "MESH"]:
        for slot, material in enumerate(thing.data.materials):
            emission = shines(stated[material.name]) if material and material.name in stated else [0]
            faces = [f for f in thing.data.polygons if f.material_index == slot] if max(emission) > 1.0 else []
            for group in islands(thing.data, faces):
                add_lamp(thing, group, emission, lit)
            if faces:
                material.shadow_method = "NONE"
                unlit.objects.link(thing)  # the lamp in its place is baked already
    for probe in described["probes"]:
        ends = [from_gltf(probe["box"][k]) for k in ("min", "max")]
        low, high = Vector(map(min, *ends)), Vector(map(max, *ends))
        half = 0.5 * (high - low)
        grid = bpy.data.lightprobes.new("volume", "GRID")
        grid.grid_resolution_x, grid.grid_resolution_y, grid.grid_resolution_z = [max(2, round(2 * x / node_distance) + 1) for x in half]
        grid.influence_distance, grid.falloff, grid.clip_start = 0.3, 0.5, 0.01
        grid.visibility_bleed_bias, grid.visibility_buffer_bias = 0.0, 0.5
        cube = bpy.data.lightprobes.new("cube", "CUBE")
        cube.influence_type, cube.influence_distance, cube.use_custom_parallax = "BOX", 1.02, True
        cube.parallax_type, cube.parallax_distance, cube.falloff, cube.clip_start = "BOX", 1.0, 0.1, 0.01
        origin = from_gltf(probe["origin"])
        for data, place, scale in ((grid, 0.5 * (low + high), 0.97 * half), (cube, origin, [max(high[i] - origin[i], origin[i] - low[i]) for i in range(3)])):
            data.visibility_collection, data.invert_visibility_collection = unlit, True
            made = bpy.data.objects.new(data.name, data)
            made.location, made.scale = place, scale
            scene.collection.objects.link(made)
    bpy.context.view_layer.update()
    start = time.time()
    if "FINISHED" not in bpy.ops.scene.light_cache_bake():
        raise SystemExit("EEVEE: the light cache was not baked")
    return time.time() - start, len(lit)
