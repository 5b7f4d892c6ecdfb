#!/usr/bin/env python3
"""The OBJ, PLY and STL files of foreign_formats.tsv and the Radiance and OpenEXR files of foreign_environments.tsv, each drawn by
boxprobe and by F3D, side by side on sheets.

    tests/outside/foreign_beside_f3d.py BOXPROBE --from DIR -o OUT [--size WxH] [--only TEXT]

DIR holds the repositories, checked out as OWNER+NAME at the commits that the lists name. OUT gets sheet-1.png ...: ours on the
left, F3D's on the right, grey where a program refused. Models have the camera that boxprobe fits; a sky is looked at along +Z, with
a triangle out of sight. F3D before 2.0 reads no OpenEXR: it gets the picture as a Radiance file that OpenImageIO writes. Prints a
line for each file: how much of the picture each program covers, where that is comparable. Runs under the display it finds. Needs
f3d, imagemagick, python3-openimageio.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

from foreign_pictures import pixels, sheets

HERE = Path(__file__).resolve().parent
STUDIO = HERE.parents[1] / "data/environments/studio.hdr"
LIMIT = 120  # seconds
SKY_ANGLE = 75  # degrees, from bottom to top
TRIANGLE = "v 0 -900 0\nv 1 -900 0\nv 0 -900 1\nf 1 2 3\n"


def run(command):
    """Exit status and the last line that was said."""
    try:
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, errors="replace", timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return 124, "took more than %d s" % LIMIT
    lines = (done.stderr.strip() or done.stdout.strip() or "nothing was said").splitlines()
    return done.returncode, lines[-1]


def listed(name):
    with open(HERE / name) as file:
        for line in file:
            fields = line.rstrip("\n").split("\t")
            if fields[0] not in ("repository", "# repository"):
                yield fields[0], fields[3], fields[-1]


def f3d(options, model, picture, camera, *more):
    width, height = options.size.split("x")
    text = {name: ",".join("%.9g" % value for value in camera[name]) for name in ("position", "target")}
    return run(["f3d", model, "--output", picture, "--resolution", width + "," + height, "--dry-run",
                "--camera-position", text["position"], "--camera-focal-point", text["target"], "--camera-view-up", "0,1,0",
                "--camera-view-angle", camera.get("verticalFovDegrees", 45)] + list(more))


def covered(picture):
    """Share of the pixels that are not as the first one, the background."""
    raw = pixels(picture)
    return sum(max(abs(raw[i + c] - raw[c]) for c in range(3)) > 6 for i in range(0, len(raw) - 2, 3)) / (len(raw) / 3)


def model(options, file, row):
    scene = options.out / "fitted.boxprobe.json"
    scene.unlink(missing_ok=True)
    status, said = run([options.program, "fit", file, "-o", scene, "--quiet"])
    if status != 0:
        row["refused"] = said
        camera = {"position": [3, 2, 4], "target": [0, 0, 0]}
    else:
        name, camera = next(iter(json.loads(scene.read_text())["cameras"].items()))
        status, said = run([options.program, "render", scene, "-o", row["ours"], "--size", options.size, "--quiet", "--camera", name,
                            "--set", "background=color", "--set", "groundShadow=false", "--set", "probes=[]"])
        if status != 0:
            row["refused"] = said
    f3d(options, file, row["theirs"], camera, "-t", "-u", "-q", "-a", "--bg-color", "0.6,0.6,0.6")
    pictures = [picture for picture in (row["ours"], row["theirs"]) if Path(picture).is_file()]
    row["found"] = " / ".join("%.2f" % covered(picture) for picture in pictures) or "-"


def sky(options, file, row):
    triangle = options.out / "triangle.obj"
    triangle.write_text(TRIANGLE)
    camera = {"position": [0, 0, 0], "target": [0, 0, 1], "verticalFovDegrees": SKY_ANGLE}
    scene = options.out / "sky.boxprobe.json"
    scene.write_text(json.dumps({"format": "boxprobe-scene", "version": 1, "model": str(triangle.resolve()), "sky": {"image": str(file.resolve())},
                                 "cameras": {"main": camera}}))
    status, said = run([options.program, "render", scene, "-o", row["ours"], "--size", options.size, "--quiet"])
    if status != 0:
        row["refused"] = said
    if file.suffix.lower() == ".exr":
        import OpenImageIO as oiio
        converted = options.out / "sky.hdr"
        converted.unlink(missing_ok=True)
        buffer = oiio.ImageBuf(str(file.resolve()))
        buffer = oiio.ImageBufAlgo.channels(buffer, (0, 1, 2) if buffer.nchannels > 2 else (0, 0, 0))
        file = converted if not buffer.has_error and buffer.write(str(converted.resolve())) else file
    f3d(options, triangle, row["theirs"], camera, "--hdri", file)
    row["found"] = "sky"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--from", dest="clones", type=Path, required=True)
    parser.add_argument("-o", dest="out", type=Path, required=True)
    parser.add_argument("--size", default="256x192")
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    rows = []
    for draw, name in ((model, "foreign_formats.tsv"), (sky, "foreign_environments.tsv")):
        for repository, path, seen in listed(name):
            file = options.clones / repository.replace("/", "+") / path
            if options.only not in path or not file.is_file():
                if options.only in path:
                    print("%s: not there" % file)
                continue
            number = "%03d" % len(rows)
            row = {"file": path, "seen": seen, "ours": str(options.out / (number + "-ours.png")),
                   "theirs": str(options.out / (number + "-f3d.png"))}
            draw(options, file, row)
            rows.append(row)
            print("%s: %s: ours / F3D's %s%s" % (path, seen, row["found"], ": " + row["refused"] if "refused" in row else ""), flush=True)
    if not rows:
        sys.exit("no file of the lists is in %s" % options.clones)
    sheets(rows, options.out)


if __name__ == "__main__":
    main()
