"""A scene file and its GLB as plain values and pictures, for engines whose own loaders would stand between."""
import json
import shutil
import struct
import subprocess
from pathlib import Path

KINDS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Glb:
    def __init__(self, path):
        data = path.read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + length])
        self.binary = data[28 + length:]

    def view(self, index):
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        return self.binary[start:start + view["byteLength"]]

    def values(self, index):
        accessor = self.json["accessors"][index]
        count = accessor["count"] * PARTS[accessor["type"]]
        return list(struct.unpack_from("<%d%s" % (count, KINDS[accessor["componentType"]]), self.view(accessor["bufferView"]),
                                       accessor.get("byteOffset", 0)))


def placed(node, positions):
    """World positions; the project's own scenes scale evenly and turn nothing."""
    matrix = node.get("matrix")
    scale = matrix[0] if matrix else 1.0
    move = matrix[12:15] if matrix else node.get("translation", [0, 0, 0])
    return [scale * value + move[i % 3] for i, value in enumerate(positions)]


def material(glb, source, pictures):
    surface = source["pbrMetallicRoughness"]
    extensions = source.get("extensions", {})
    strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)

    def picture(holder, key):
        return pictures[glb.json["textures"][holder[key]["index"]]["source"]] if key in holder else None

    return {"color": surface["baseColorFactor"][:3], "metallic": surface["metallicFactor"], "roughness": surface["roughnessFactor"],
            "texture": picture(surface, "baseColorTexture"), "emissive": [strength * c for c in source.get("emissiveFactor", [0, 0, 0])],
            "emissiveTexture": picture(source, "emissiveTexture"), "unlit": "KHR_materials_unlit" in extensions}


def write(program, scene_file, folder, width, height, samples):
    """Everything a peer reads, into `folder`: config.json, its pictures, model.glb, and the picture that lights what has no probe."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = json.loads(scene_file.read_text())
    model = scene_file.parent / scene["model"]
    glb = Glb(model)
    pictures = []
    for index, image in enumerate(glb.json.get("images", [])):
        pictures.append("texture%d.png" % index)
        (folder / pictures[-1]).write_bytes(glb.view(image["bufferView"]))
    meshes = []
    for node in glb.json["nodes"]:
        seen = scene.get("objects", {}).get(node["name"], {}).get("seenByProbes", True)
        for part in glb.json["meshes"][node["mesh"]]["primitives"]:
            attributes = part["attributes"]
            meshes.append({"name": node["name"], "material": part["material"], "seenByProbes": seen,
                           "positions": placed(node, glb.values(attributes["POSITION"])), "normals": glb.values(attributes["NORMAL"]),
                           "coordinates": glb.values(attributes["TEXCOORD_0"]), "indices": glb.values(part["indices"])})
    shutil.copyfile(model, folder / "model.glb")
    # A scene with a sky is lit by it; a closed room, where the peer has no probes, by what its probe captured.
    sky = "sky.hdr" if "top" in scene["sky"] else None
    if sky:
        shutil.copyfile(scene_file.parent / sky, folder / sky)
    else:
        subprocess.run([program, "export", scene_file, "-o", folder / "exported", "--format", "hdr", "--ladder", "three", "--quiet"], check=True)
        shutil.copyfile(next((folder / "exported").glob("*.hdr")), folder / "probe.hdr")
    config = {"width": width, "height": height, "samples": samples, "camera": scene["cameras"]["main"], "sky": sky,
              "hdri": sky or "probe.hdr", "lights": scene.get("lights", []), "probe": scene["probes"][0],
              "materials": [material(glb, source, pictures) for source in glb.json["materials"]], "meshes": meshes}
    (folder / "config.json").write_text(json.dumps(config))
    return config
