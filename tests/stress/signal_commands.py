"""The commands that signals.py interrupts: every command of the program, each kind of work it has, and reading a large file."""
import os
import struct
import subprocess

GODOT = """[gd_scene format=3]
[node name="Room" type="Node3D"]
[node name="P" type="ReflectionProbe" parent="."]
size = Vector3(8, 3, 6)
box_projection = true
"""


def large_stl(path, triangles=600000):
    """30 MB to read."""
    with open(path, "wb") as file:
        file.write(b"\0" * 80 + struct.pack("<I", triangles))
        for i in range(triangles):
            x, y = i % 1000, i // 1000
            file.write(struct.pack("<12fH", 0, 0, 1, x, y, 0, x + 1, y, 0, x, y + 1, 0, 0))


def prepare(program, data, folder):
    """Inputs that the commands read and never write: a large model, a Godot scene, a scene with baked files."""
    large_stl(f"{folder}/large.stl")
    with open(f"{folder}/room.tscn", "w") as file:
        file.write(GODOT)
    with open(f"{data}/scenes/room.boxprobe.json") as file:
        text = file.read().replace('"room.glb"', f'"{os.path.abspath(data)}/scenes/room.glb"')
    with open(f"{folder}/baked.boxprobe.json", "w") as file:
        file.write(text)
    subprocess.run([program, "bake", f"{folder}/baked.boxprobe.json", "--quiet"], check=True)


def commands(data, given, out):
    """By name. `given` is the folder that prepare() filled, `out` an empty one for this run."""
    room, building = f"{data}/scenes/room.boxprobe.json", f"{data}/scenes/building.boxprobe.json"
    furnished, baked = f"{data}/scenes/furnished.boxprobe.json", f"{given}/baked.boxprobe.json"
    small = ["--size", "160x90"]
    return {
        "info": ["info", building],
        "info (30 MB of STL)": ["info", f"{given}/large.stl"],
        "info --frame": ["info", building, "--frame"] + small,
        "info --frame --costs": ["info", building, "--frame", "--costs"] + small,
        "render .png": ["render", room, "-o", f"{out}/a.png"] + small,
        "render .exr": ["render", building, "-o", f"{out}/a.exr"] + small,
        "render (30 MB of STL)": ["render", f"{given}/large.stl", "-o", f"{out}/a.png"] + small,
        "render --view all": ["render", room, "-o", f"{out}/views.png", "--view", "all"] + small,
        "render, baked": ["render", baked, "-o", f"{out}/a.png"] + small,
        "render reference-box": ["render", room, "-o", f"{out}/b.exr", "--technique", "reference-box"] + small,
        "render reference-scene": ["render", room, "-o", f"{out}/c.png", "--technique", "reference-scene"] + small,
        "render --shard": ["render", room, "-o", f"{out}/d.exr", "--technique", "reference-scene", "--shard", "1/2"],
        "bake": ["bake", room, "-o", f"{out}/probes"],
        "bake --bounce": ["bake", building, "-o", f"{out}/probes", "--bounce", "1"],
        "bake --check": ["bake", baked, "--check"],
        "bake --list": ["bake", building, "--list"],
        "explain": ["explain", building, "--pixel", "80,45"] + small,
        "fit": ["fit", building, "-o", f"{out}/fitted.boxprobe.json"],
        "fit --origin propose": ["fit", furnished, "--origin", "propose", "-o", f"{out}/fitted.boxprobe.json"],
        "place": ["place", furnished, "-o", f"{out}/placed.boxprobe.json"],
        "export": ["export", room, "-o", f"{out}/engine", "--format", "ktx2"],
        "export --format web": ["export", room, "-o", f"{out}/web", "--format", "web"],
        "export --shader": ["export", room, "-o", f"{out}/shader", "--shader", "glsl"],
        "import": ["import", f"{given}/room.tscn", "-o", f"{out}/imported.boxprobe.json"],
        "bench --quick": ["bench", room, "-o", f"{out}/bench", "--quick"],
        "bench --truth": ["bench", "--truth", "--quick", "-o", f"{out}/truth"],
        "stress": ["stress", "--count", "20000000", "-o", f"{out}/s.json"],
        "stress --device gpu": ["stress", "--device", "gpu", "--count", "5000000", "-o", f"{out}/s.json"],
        "lessons (list)": ["lessons"],
        "lessons -o": ["lessons", "floor-mirror", "-o", f"{out}/l.png"],
        "lessons -o page": ["lessons", "-o", f"{out}/page.html"],
        "lessons --check": ["lessons", "three-distances", "--check"],
        "lessons --loops": ["lessons", "three-distances", "--loops", f"{out}/loops"],
        "lessons NAME (window)": ["lessons", "floor-mirror"],
        "window": [room],
        "window, model": [f"{data}/scenes/building.glb"],
    }
