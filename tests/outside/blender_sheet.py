"""Our picture of a scene beside Blender's EEVEE, both against Cycles: figures and a sheet.

usage: blender -b --factory-startup --python-exit-code 1 --python blender_sheet.py -- BOXPROBE SCENE OUT [options]
  --camera NAME[,NAME]  cameras of the scene file (default: all)
  --size WxH            default 320x180
  --samples N           of Cycles a pixel and picture (default 128); there are two pictures, whose difference is the noise
  --again NAME[,NAME]   of boxprobe, path, eevee, cycles: drawn again although its picture is there
  --without NAME[,NAME] left out unless its picture is there: a sheet without EEVEE is drawn in seconds
  --path RAYS           the program's own path tracer as well, held against Cycles by the same figures (default 0: not)
  --set FIELD=VALUE     for boxprobe render, may be repeated
  --cubemap N           texels along a face of EEVEE's cubemaps, also of those that its nodes are baked by (default 256)
  --nodes METRES        between the nodes of EEVEE's irradiance volumes (default 1)
  --better              an error where EEVEE's picture is nearer to Cycles' than ours

Cycles has all bounces. EEVEE has an irradiance volume and a reflection cubemap for each probe, area lamps where surfaces shine.
OUT gets linear EXRs and SCENE.png: boxprobe, EEVEE, Cycles in a row for each camera, by the scene's exposure and tone, and
SCENE-off.png, how far the first two are from Cycles: red too bright, blue too dark, full colour at a factor of two. Needs a display.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import bpy
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import blender_lights  # noqa: E402

BLOCK = 4
RENDERERS = ("boxprobe", "path", "eevee", "cycles")


def blocks(picture):
    height, width = picture.shape[:2]
    kept = picture[: height // BLOCK * BLOCK, : width // BLOCK * BLOCK]
    return kept.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def figures(truth, noise, drawn):
    """Light over the truth's; relative RMSE of the pixels, without the truth's noise; share of blocks within 10 %."""
    off = ((drawn - truth) ** 2).sum() - noise
    near = numpy.abs(blocks(drawn) - blocks(truth)).mean(axis=2) <= 0.1 * blocks(truth).mean(axis=2)
    return drawn.mean() / truth.mean(), (max(off, 0.0) / (truth**2).sum()) ** 0.5, near.mean()


def agx(light):
    """AgX in Rec. 2020's primaries, by Wrensch's polynomial."""
    inset = numpy.array([[0.54481208, 0.37379744, 0.08138096], [0.14041935, 0.75410778, 0.10539675], [0.08881714, 0.17885976, 0.73231543]])
    outset = numpy.array([[1.12710058, -0.11060664, -0.01649394], [-0.14132976, 1.15782370, -0.01649394], [-0.14132976, -0.11060664, 1.25193641]])
    back = numpy.array([[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]])
    x = numpy.clip((numpy.log2(numpy.maximum(light @ inset.T, 1e-10)) + 12.47393) / 16.499999, 0, 1)
    shown = numpy.polyval([15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232], x)
    return numpy.clip(numpy.maximum(shown @ outset.T, 0) ** 2.2 @ back.T, 0, 1)


def displayed(light, described):
    light = light * described.get("exposure", 1.0)
    light = agx(light) if described.get("tone") == "agx" else numpy.clip(light, 0, 1)
    return numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def off(drawn, truth):
    """Red: too bright; blue: too dark; white: right."""
    least = 0.02 * truth.mean()
    by = numpy.clip(numpy.log2((drawn.mean(axis=2) + least) / (truth.mean(axis=2) + least)), -1, 1)
    red, blue = numpy.maximum(by, 0), numpy.maximum(-by, 0)
    return numpy.stack([1 - blue, 1 - blue - red, 1 - red], axis=2)


def save(rows, path):
    """Pictures side by side, rows one below the other, 4 pixels between them."""
    height, width = rows[0][0].shape[:2]
    gap = 4
    sheet = numpy.ones((len(rows) * (height + gap) - gap, len(rows[0]) * (width + gap) - gap, 4))
    for r, row in enumerate(reversed(rows)):
        for c, picture in enumerate(row):
            sheet[r * (height + gap) : r * (height + gap) + height, c * (width + gap) : c * (width + gap) + width, :3] = picture
    image = bpy.data.images.new("sheet", sheet.shape[1], sheet.shape[0])
    image.pixels = sheet.ravel()
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()


def drawn_by_us(options, camera, path, extra):
    words = [options.program, "render", options.scene, "-o", path, "--camera", camera, "--size", options.size, "--quiet", *extra]
    for field in options.set:
        words += ["--set", field]
    subprocess.run(list(map(str, words)), check=True)


def main():
    reader = argparse.ArgumentParser(prog="blender_sheet.py", usage=__doc__)
    reader.add_argument("program", type=Path)
    reader.add_argument("scene", type=Path)
    reader.add_argument("out", type=Path)
    reader.add_argument("--camera", default="")
    reader.add_argument("--size", default="320x180")
    reader.add_argument("--samples", type=int, default=128)
    reader.add_argument("--again", default="")
    reader.add_argument("--without", default="")
    reader.add_argument("--path", type=int, default=0)
    reader.add_argument("--set", action="append", default=[])
    reader.add_argument("--cubemap", choices=["64", "128", "256"], default="256")
    reader.add_argument("--nodes", type=float, default=blender_lights.NODE_DISTANCE)
    reader.add_argument("--better", action="store_true")
    options = reader.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    options.scene, options.out = options.scene.resolve(), options.out.resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    again, without = ([name for name in given.split(",") if name] for given in (options.again, options.without))
    for name in again + without:
        if name not in RENDERERS:
            sys.exit("blender_sheet.py: %s is none of %s" % (name, ", ".join(RENDERERS)))
    width, height = map(int, options.size.split("x"))
    name = options.scene.name.replace(".boxprobe.json", "")
    plan = json.loads((blender_lights.TRUTH / "lit/plan.json").read_text())
    described, stated = blender_lights.load(options.scene, plan["portals"].get(name, []))
    cameras = options.camera.split(",") if options.camera else list(described["cameras"])
    file = lambda camera, what: options.out / ("%s-%s-%s.exr" % (name, camera, what))
    due = lambda camera, what, kind: kind in again or (kind not in without and not file(camera, what).exists())

    for camera in cameras:
        if due(camera, "boxprobe", "boxprobe"):
            drawn_by_us(options, camera, file(camera, "boxprobe"), ["--refine=64", "--samples", "16"])
        if options.path and due(camera, "path", "path"):
            drawn_by_us(options, camera, file(camera, "path"), ["--technique", "reference-path", "--bounces", "all", "--rays", options.path])
    blender_lights.cycles(width, height, options.samples)
    for camera in cameras:
        blender_lights.set_camera(described["cameras"][camera])
        for seed in (11, 23):
            if due(camera, "cycles-%d" % seed, "cycles"):
                bpy.context.scene.cycles.seed = seed
                blender_lights.draw(file(camera, "cycles-%d" % seed))
    if any(due(camera, "eevee", "eevee") for camera in cameras):
        seconds, lamps = blender_lights.eevee(described, stated, width, height, options.cubemap, options.nodes)
        print("EEVEE: %d lamps, baked in %.0f s" % (lamps, seconds), flush=True)
        for camera in cameras:
            blender_lights.set_camera(described["cameras"][camera])
            blender_lights.draw(file(camera, "eevee"))

    rows, offs, lost = [], [], []
    print("%-12s %-8s %-9s light   RMSE  within 10 %%  noise of Cycles" % ("scene", "camera", "renderer"))
    for camera in cameras:
        pair = [blender_lights.read(file(camera, "cycles-%d" % seed)) for seed in (11, 23)]
        truth, noise = 0.5 * (pair[0] + pair[1]), 0.25 * ((pair[0] - pair[1]) ** 2).sum()
        drawn = {what: blender_lights.read(file(camera, what)) for what in ("boxprobe", "path", "eevee") if file(camera, what).exists()}
        errors = {}
        for what, picture in drawn.items():
            light, rmse, near = figures(truth, noise, picture)
            errors[what] = rmse
            print("%-12s %-8s %-9s %.3f  %.3f   %5.1f %%   %.3f" % (name, camera, what, light, rmse, 100 * near, (noise / (truth**2).sum()) ** 0.5))
        if errors.get("eevee", errors["boxprobe"]) < errors["boxprobe"]:
            lost.append(camera)
        shown = [drawn[what] for what in ("boxprobe", "eevee") if what in drawn]
        rows.append([displayed(picture, described) for picture in [*shown, truth]])
        offs.append([off(picture, truth) for picture in shown])
    save(rows, options.out / (name + ".png"))
    save(offs, options.out / (name + "-off.png"))
    if options.better and "eevee" not in errors:
        sys.exit("blender_sheet.py: EEVEE drew nothing to compare")
    if options.better and lost:
        sys.exit("blender_sheet.py: EEVEE's picture is nearer to Cycles': " + ", ".join(lost))


main()
