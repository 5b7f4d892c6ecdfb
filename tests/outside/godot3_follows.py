#!/usr/bin/env python3
"""Godot 3 follows five edits of a scene file by data/engines/boxprobe_live_godot3.gd while `boxprobe export --watch` runs: boxes read back
from the engine's own nodes.

usage: godot3_follows.py BOXPROBE SCENES OUT
"""
import json
import math
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

program, scenes, out = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
engine = shutil.which("godot3") or shutil.which("godot3-server")
if engine is None:
    print("left out: package godot3 is not installed")
    sys.exit(77)
here = Path(__file__).resolve().parent
shutil.rmtree(out, ignore_errors=True)
out.mkdir(parents=True)
for file in (here / "godot3" / "follow.gd", here.parents[1] / "data" / "engines" / "boxprobe_live_godot3.gd"):
    shutil.copy(file, out)
(out / "project.godot").write_text('config_version=4\n[application]\nconfig/name="follow"\n')

scene = json.loads((scenes / "room.boxprobe.json").read_text())
scene["model"] = str(scenes / "room.glb")
scene["probes"][0].update(faceSize=16, bounces=1)
scene_file = out / "live.boxprobe.json"


def save():
    scene_file.with_suffix(".new").write_text(json.dumps(scene))
    scene_file.with_suffix(".new").rename(scene_file)
    return time.monotonic()


def expected(probe):
    """Corners by the scene file's own words: turned about the box's centre."""
    low, high = probe["box"]["min"], probe["box"]["max"]
    angle, corners = math.radians(probe.get("rotationDegrees", [0, 0, 0])[1]), []
    for i in range(8):
        x, y, z = [((high if i >> axis & 1 else low)[axis] - (low[axis] + high[axis]) / 2) for axis in range(3)]
        x, z = x * math.cos(angle) + z * math.sin(angle), -x * math.sin(angle) + z * math.cos(angle)
        corners.append([v + (a + b) / 2 for v, a, b in zip((x, y, z), low, high)])
    return corners


def near(ours, theirs):
    return all(any(max(abs(a - b) for a, b in zip(one, other)) < 0.002 for other in theirs) for one in ours)


def matches():
    if not seen or set(seen[-1]["probes"]) != {probe["name"] for probe in scene["probes"]}:
        return False
    return all(near(expected(probe), seen[-1]["probes"][probe["name"]]["corners"]) for probe in scene["probes"])


def wait(what, begun, seconds=60):
    while not matches():
        time.sleep(0.02)
        if exporter.poll() is not None or godot.poll() is not None or time.monotonic() - begun > seconds:
            sys.exit("%s: FAILED, not seen in Godot" % what)
    print("%s: in Godot after %.2f s" % (what, time.monotonic() - begun))


seen, failures = [], []
save()
exporter = subprocess.Popen([program, "export", str(scene_file), "-o", str(out / "live.glb"), "--format", "glb", "--watch", "--quiet"])
godot = subprocess.Popen([engine, "--path", str(out), "-s", "follow.gd"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def listen():
    for line in godot.stdout:
        if line.startswith("boxprobe "):
            seen.append(json.loads(line[9:]))
        elif "SCRIPT ERROR" in line:
            failures.append(line)
            print(line, end="")


threading.Thread(target=listen, daemon=True).start()
try:
    wait("the scene", time.monotonic())
    probe = scene["probes"][0]
    probe["box"]["max"] = [3.5, 2.75, 3.25]
    wait("a face dragged", save())
    probe["box"]["min"] = [-3.25, 0.125, -2.5]
    wait("another", save())
    probe["rotationDegrees"] = [0, 30, 0]
    wait("a turned box", save())
    scene["probes"].append({"name": "second", "origin": [1, 1, 1], "box": {"min": [0, 0.5, -1], "max": [2, 2, 2]}, "faceSize": 16})
    wait("a second probe", save())
    del scene["probes"][0]
    wait("the first removed", save())
finally:
    (out / "end.txt").write_text("")
    exporter.send_signal(signal.SIGINT)
    status = exporter.wait()
    try:
        godot.wait(10)
    except subprocess.TimeoutExpired:
        godot.kill()
if failures or status != 1:  # 1: interrupted
    sys.exit("FAILED: %d errors of scripts; the exporter ended with %d" % (len(failures), status))
print("five edits followed")
