"""A GLB whose materials emit the picture they had and are black otherwise: shining.py FROM.glb TO.glb

VTK's importer knows no unlit materials; so does tests/install/install_test.cpp for the example in C++."""
import json
import struct
import sys

data = open(sys.argv[1], "rb").read()
length = struct.unpack_from("<I", data, 12)[0]
model = json.loads(data[20 : 20 + length])
for material in model["materials"]:
    base = material["pbrMetallicRoughness"]
    if "baseColorTexture" in base:
        material.pop("extensions", None)
        material["emissiveTexture"] = base["baseColorTexture"]
        material["emissiveFactor"] = [1.0, 1.0, 1.0]
        base["baseColorFactor"] = [0.0, 0.0, 0.0, 1.0]
text = json.dumps(model).encode()
text += b" " * (-len(text) % 4)
rest = data[20 + length :]
with open(sys.argv[2], "wb") as out:
    out.write(data[:8] + struct.pack("<I", 20 + len(text) + len(rest)) + struct.pack("<I", len(text)) + data[16:20] + text + rest)
