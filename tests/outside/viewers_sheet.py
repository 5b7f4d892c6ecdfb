#!/usr/bin/env python3
"""Twelve models of other people, of four kinds, drawn by boxprobe, F3D and three.js from the same camera, on a sheet without names.

usage: viewers_sheet.py BOXPROBE --from DIR --modules NODE_MODULES -o OUT [--seed N] [--size WxH] [--only TEXT]
       viewers_sheet.py --uncover OUT CHOICES

DIR holds clones as foreign_models.py has them, NODE_MODULES the packages of engines/package.json. OUT gets sheet.png: a row for
each model, its three pictures in an order that the seed shuffles. Judge that first: CHOICES names the best of each row by its
place, say ABCAACBBABCA, with - for none. F3D has our studio as its environment, because it has none of its own;
three.js has its neutral room. --uncover then says whom the choices are, kind by kind. Runs under the display it finds.
"""
import argparse
import json
import random
import subprocess
import sys
from pathlib import Path

from foreign_pictures import font

HERE = Path(__file__).resolve().parent
MODELS = [  # kind, clone, file
    ("object", "donmccurdy+glTF-Transform", "packages/view/assets/DamagedHelmet.glb"),
    ("object", "playcanvas+engine", "examples/assets/models/statue.glb"),
    ("object", "donmccurdy+glTF-Transform", "packages/cli/test/in/chr_knight.glb"),
    ("interior", "immersive-web+webxr-samples", "media/gltf/garage/garage.gltf"),
    ("interior", "immersive-web+webxr-samples", "media/gltf/home-theater/home-theater.gltf"),
    ("interior", "playcanvas+engine", "examples/assets/models/vr-gallery.glb"),
    ("open", "immersive-web+webxr-samples", "media/gltf/camp/camp.gltf"),
    ("open", "immersive-web+webxr-samples", "media/gltf/space/space.gltf"),
    ("open", "playcanvas+engine", "examples/assets/models/terrain.glb"),
    ("product shot", "playcanvas+engine", "examples/assets/models/SunglassesKhronos.glb"),
    ("product shot", "immersive-web+webxr-samples", "media/gltf/headset/headset.gltf"),
    ("product shot", "immersive-web+webxr-samples", "media/gltf/controller/controller.gltf"),
]
VIEWERS = ["boxprobe", "F3D", "three.js"]


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("%s: %s" % (" ".join(map(str, command)), (done.stderr or done.stdout).strip()[-400:]))


def camera_of(options, model, scene):
    """Of the model as boxprobe opens it."""
    run([options.program, "fit", model, "-o", scene, "--quiet"])
    cameras = json.loads(scene.read_text())["cameras"]
    return next(iter(cameras.values()))


def draw(options, number, model):
    """Paths of the three pictures, in the order of VIEWERS."""
    width, height = options.size.split("x")
    scene = options.out / ("%02d.boxprobe.json" % number)
    camera = camera_of(options, model, scene)
    camera.setdefault("up", [0, 1, 0])
    camera.setdefault("verticalFovDegrees", 45)
    pictures = [options.out / ("%02d-%s.png" % (number, viewer)) for viewer in VIEWERS]
    text = {name: ",".join("%.9g" % value for value in camera[name]) for name in ("position", "target", "up")}
    run([options.program, "render", model, "-o", pictures[0], "--size", options.size, "--quiet"])
    run(["f3d", model, "--output", pictures[1], "--resolution", "%s,%s" % (width, height), "-t", "-u", "-q", "-a", "--hdri", HERE.parents[1] / "data/environments/studio.hdr",
         "--camera-position", text["position"], "--camera-focal-point", text["target"], "--camera-view-up", text["up"],
         "--camera-view-angle", str(camera["verticalFovDegrees"])])
    file = options.out / ("%02d-camera.json" % number)
    file.write_text(json.dumps(camera))
    run(["node", HERE / "engines" / "show_model.mjs", model, file, pictures[2], width, height, options.modules])
    return pictures


def uncover(out, choices):
    order = json.loads((out / "order.json").read_text())
    if len(choices) != len(order):
        sys.exit("%d choices for %d rows" % (len(choices), len(order)))
    won = {}
    for row, choice in zip(order, choices):
        winner = "-" if choice == "-" else row["viewers"]["ABC".index(choice)]
        won.setdefault(row["kind"], []).append(winner)
        print("%-13s %-24s best: %-9s (A %s, B %s, C %s)" % (row["kind"], row["name"], winner, *row["viewers"]))
    for kind, winners in won.items():
        print("%s: boxprobe %d of %d" % (kind, winners.count("boxprobe"), len(winners)))
    print("all: boxprobe %d of %d" % (sum(w.count("boxprobe") for w in won.values()), len(order)))


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--uncover":
        return uncover(Path(sys.argv[2]), sys.argv[3])
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--from", dest="clones", type=Path, required=True)
    parser.add_argument("--modules", type=Path, required=True)
    parser.add_argument("-o", dest="out", type=Path, required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", default="480x270")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    shuffled = random.Random(options.seed)
    order, rows = [], []
    for number, (kind, clone, file) in enumerate(MODELS, 1):
        places = shuffled.sample(range(3), 3)
        if options.only not in file:
            continue
        pictures = draw(options, number, options.clones / clone / file)
        order.append({"kind": kind, "name": Path(file).stem, "viewers": [VIEWERS[place] for place in places]})
        rows += [str(pictures[place]) for place in places]
        print("%d of %d" % (number, len(MODELS)), flush=True)
    (options.out / "order.json").write_text(json.dumps(order, indent=1))
    run(["montage"] + font() + ["-pointsize", "14"] + [part for i, row in enumerate(rows) for part in
        ("-label", "%d %s" % (i // 3 + 1, "ABC"[i % 3]), row)] + ["-tile", "3x", "-geometry", "+4+3", str(options.out / "sheet.png")])
    print("sheet: %s" % (options.out / "sheet.png"))


if __name__ == "__main__":
    main()
