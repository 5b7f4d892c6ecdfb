"""Blender follows five edits of a scene file by data/engines/boxprobe_blender_live.py while `boxprobe export --watch` runs: boxes,
a turn, an addition and a removal, read back from bpy.

usage: blender -b --factory-startup --python-exit-code 1 --python blender_follows.py -- BOXPROBE SCENES OUT
"""
import importlib.util
import json
import math
import signal
import subprocess
import sys
import time
from pathlib import Path

import bpy
from mathutils import Vector

program, scenes, out = sys.argv[sys.argv.index("--") + 1:]
out = Path(out).resolve()
out.mkdir(parents=True, exist_ok=True)
script = Path(__file__).resolve().parents[2] / "data" / "engines" / "boxprobe_blender_live.py"
spec = importlib.util.spec_from_file_location("live", script)
live = importlib.util.module_from_spec(spec)
spec.loader.exec_module(live)

scene = json.loads((Path(scenes) / "room.boxprobe.json").read_text())
scene["model"] = str(Path(scenes).resolve() / "room.glb")
scene["probes"][0]["faceSize"] = 16
scene["probes"][0]["bounces"] = 1
scene_file, glb = out / "live.boxprobe.json", out / "live.glb"
for old in (glb, out / "live.glb.revision"):
    old.unlink(missing_ok=True)


def save():
    # As editors do: a new file takes the place of the old one.
    fresh = out / "live.boxprobe.json.new"
    fresh.write_text(json.dumps(scene))
    fresh.rename(scene_file)
    return time.monotonic()


def expected(probe):
    """Corners of the projection box in Blender's axes, by the scene file's own words: turned about its centre."""
    low, high = probe["box"]["min"], probe["box"]["max"]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    angle = math.radians(probe.get("rotationDegrees", [0, 0, 0])[1])
    corners = set()
    for i in range(8):
        x, y, z = [((high if i >> axis & 1 else low)[axis] - middle[axis]) for axis in range(3)]
        x, z = x * math.cos(angle) + z * math.sin(angle), -x * math.sin(angle) + z * math.cos(angle)
        x, y, z = x + middle[0], y + middle[1], z + middle[2]
        corners.add((round(x, 3) + 0.0, round(-z, 3) + 0.0, round(y, 3) + 0.0))
    return corners


def found(each):
    corners = [each.matrix_world @ Vector([1 if i >> axis & 1 else -1 for axis in range(3)]) for i in range(8)]
    return {tuple(round(v, 3) + 0.0 for v in corner) for corner in corners}


def matches():
    bpy.context.view_layer.update()
    probes = {each.name: each for each in bpy.data.objects if each.type == "LIGHT_PROBE"}
    if set(probes) != {probe["name"] for probe in scene["probes"]}:
        return False
    return all(same(found(probes[probe["name"]]), expected(probe)) for probe in scene["probes"])


def same(ours, theirs):
    near = lambda a, b: all(abs(x - y) < 0.002 for x, y in zip(a, b))
    return all(any(near(a, b) for b in theirs) for a in ours) and all(any(near(a, b) for a in ours) for b in theirs)


follower = live.Follower(str(glb))


def wait(what, holds, begun, seconds=60):
    while not holds():
        follower()  # what Blender's timer calls; in the background none runs
        time.sleep(0.02)
        if exporter.poll() is not None:
            sys.exit("%s: the exporter ended with %d" % (what, exporter.returncode))
        if time.monotonic() - begun > seconds:
            sys.exit("%s: FAILED, not seen in Blender after %d s" % (what, seconds))
    took = time.monotonic() - begun
    print("%s: in Blender after %.2f s" % (what, took))
    return took


begun = save()
exporter = subprocess.Popen([program, "export", str(scene_file), "-o", str(glb), "--format", "glb", "--watch", "--quiet"])
try:
    wait("the scene", matches, begun)
    probe = scene["probes"][0]
    times = []

    probe["box"]["max"] = [3.5, 2.75, 3.25]
    times.append(wait("a face dragged", matches, save()))
    probe["origin"], probe["box"]["min"] = [0.3, 1.2, 0.4], [-3.25, 0.125, -2.5]
    times.append(wait("another, and the origin", matches, save()))
    probe["rotationDegrees"] = [0, 30, 0]
    times.append(wait("a turned box", matches, save()))
    scene["probes"].append({"name": "second", "origin": [1, 1, 1], "box": {"min": [0, 0.5, -1], "max": [2, 2, 2]}, "faceSize": 16})
    scene_file.with_suffix(".broken").write_text("half a sc")
    scene_file.with_suffix(".broken").rename(scene_file)  # somebody's half-written file changes nothing
    time.sleep(0.3)
    times.append(wait("a second probe, after a broken file", matches, save()))
    scene["probes"] = [scene["probes"][1]]
    times.append(wait("the first removed", matches, save()))
    revision = json.loads((out / "live.glb.revision").read_text())["revision"]
    if revision < 6:
        sys.exit("FAILED: %d revisions" % revision)
    print("five edits followed, %.2f to %.2f s each; revision %d" % (min(times), max(times), revision))
finally:
    exporter.send_signal(signal.SIGINT)
    status = exporter.wait()
if status != 1:  # interrupted
    sys.exit("FAILED: the exporter ended with %d" % status)
