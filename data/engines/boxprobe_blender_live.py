"""Boxprobe's probes and lamps in Blender while they are edited: follows a .glb of `boxprobe export --format glb --watch` or of File > Live
link in the window.

    blender scene.blend --python boxprobe_blender_live.py -- DIR/room.glb

Makes and moves reflection cubemap probes (light probes) with their influence and parallax boxes, and area lamps, in the collection
"Boxprobe". Blender 3 and 4 (EEVEE). glTF's +Y up becomes Blender's +Z up: (x, y, z) -> (x, -z, y).
"""
import json
import os
import struct
import sys

import bpy
from mathutils import Matrix, Quaternion, Vector

NAME = "BOXPROBE_reflection_probes"
TO_BLENDER = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))


def read_extension(path):
    """The JSON chunk alone; None while the file is not whole."""
    try:
        with open(path, "rb") as file:
            magic, version, length, chunk, kind = struct.unpack("<4sIIII", file.read(20))
            if magic != b"glTF" or version != 2 or kind != 0x4E4F534A or length != os.fstat(file.fileno()).st_size:
                return None
            return json.loads(file.read(chunk))["extensions"][NAME]
    except (OSError, struct.error, ValueError, KeyError):
        return None


def collection():
    found = bpy.data.collections.get("Boxprobe")
    if found is None:
        found = bpy.data.collections.new("Boxprobe")
        bpy.context.scene.collection.children.link(found)
    return found


def placed(name, kind, make_data):
    """The object of that name in the collection, made where it is missing; edits of it elsewhere stay."""
    for each in collection().objects:
        if each.get("boxprobe") == kind + name:
            return each
    each = bpy.data.objects.new(name, make_data())
    each["boxprobe"] = kind + name
    collection().objects.link(each)
    return each


def turn_of(probe):
    """Rotation of the box, in Blender's axes."""
    x, y, z, w = probe["rotation"]
    return TO_BLENDER @ Quaternion((w, x, y, z)).to_matrix() @ TO_BLENDER.transposed()


def box_matrix(probe, box, turn):
    """Of an object that reaches one unit to each side, so that it fills a box of the probe's frame."""
    low, high = Vector(box["min"]), Vector(box["max"])
    middle, half = TO_BLENDER @ ((low + high) / 2), (high - low) / 2
    center = TO_BLENDER @ Vector(probe["origin"]) + turn @ middle
    return Matrix.Translation(center) @ turn.to_4x4() @ Matrix.Diagonal((half.x, half.z, half.y, 1))


def set_probe(probe):
    kind = "SPHERE" if bpy.app.version >= (4, 1, 0) else "CUBE"
    each = placed(probe["name"], "probe ", lambda: bpy.data.lightprobes.new(probe["name"], kind))
    box, influence, data = probe["box"], probe["influence"], each.data
    sizes = [[b - a for a, b in zip(one["min"], one["max"])] for one in (box, influence)]
    data.influence_type, data.parallax_type, data.parallax_distance = "BOX", "BOX", 1.0
    data.use_custom_parallax = not probe["technique"].startswith("infinite")
    # One object has one transform for both boxes: its own is the projection box, and the influence a multiple of it.
    data.influence_distance = max([i / b for b, i in zip(*sizes) if b > 0], default=1.0)
    blend, smallest = max(probe["blendDistance"]["min"] + probe["blendDistance"]["max"]), min(sizes[1])
    data.falloff = min(2 * blend / smallest, 1) if smallest > 0 else 0
    data.clip_start, data.clip_end = max(probe["near"], 1e-4), probe["far"]
    each.matrix_world = box_matrix(probe, box, turn_of(probe))


def set_lamp(number, lamp):
    """A rectangle of the polygon's area and extent, shining the way it does."""
    corners = [TO_BLENDER @ Vector(corner) for corner in lamp["corners"]]
    cross = sum((a.cross(b) for a, b in zip(corners, corners[1:] + corners[:1])), Vector())
    normal, area, middle = cross.normalized(), cross.length / 2, sum(corners, Vector()) / len(corners)
    along = max((b - a for a, b in zip(corners, corners[1:] + corners[:1])), key=lambda edge: edge.length).normalized()
    reach = [along.dot(corner) for corner in corners]
    each = placed("lamp %d" % number, "", lambda: bpy.data.lights.new("lamp %d" % number, "AREA"))
    data, brightest = each.data, max(lamp["radiance"] + [1e-9])
    data.shape, data.size = "RECTANGLE", max(reach) - min(reach)
    data.size_y = area / data.size
    data.color = [value / brightest for value in lamp["radiance"]]
    data.energy = brightest * area * 3.14159265358979  # watts: the flux of an even lamp
    # An area lamp shines along its own -Z.
    each.matrix_world = Matrix.Translation(middle) @ Matrix((along, (-normal).cross(along), -normal)).transposed().to_4x4()


def update(extension):
    for probe in extension["probes"]:
        set_probe(probe)
    lamps = extension.get("lamps", [])
    for number, lamp in enumerate(lamps):
        set_lamp(number, lamp)
    kept = {"probe " + probe["name"] for probe in extension["probes"]} | {"lamp %d" % number for number in range(len(lamps))}
    for each in list(collection().objects):
        if each.get("boxprobe") and each["boxprobe"] not in kept:
            bpy.data.objects.remove(each)


class Follower:
    """Looks at the file's time ten times a second; a file that is not whole is looked at again."""

    def __init__(self, path, on_update=None):
        self.path, self.on_update, self.seen = path, on_update, None

    def __call__(self):
        try:
            state = os.stat(self.path)
        except OSError:
            return 0.1  # about to be renamed, or not there yet
        stamp = (state.st_mtime_ns, state.st_size, state.st_ino)
        if stamp != self.seen:
            extension = read_extension(self.path)
            if extension is not None:
                self.seen = stamp
                update(extension)
                if self.on_update:
                    self.on_update(extension)
        return 0.1


if __name__ == "__main__":
    if "--" not in sys.argv or len(sys.argv) < sys.argv.index("--") + 2:
        sys.exit("usage: blender --python boxprobe_blender_live.py -- FILE.glb")
    bpy.app.timers.register(Follower(sys.argv[sys.argv.index("--") + 1]), persistent=True)
