#!/usr/bin/env python3
"""Other people's models, as boxprobe opens them without a scene, on contact sheets beside their authors' pictures or F3D's.

usage: foreign_models.py BOXPROBE --from DIR -o OUT [--list FILE] [--only TEXT] [--size WxH] [--time N] [--sheets-only]

DIR holds checked-out clones, OWNER+NAME for each repository of the list; nothing is downloaded. OUT gets sheet-N.png
(by ImageMagick), the pictures and results.json, and the program prints: the models right, wrong and refused, which the
list's last column says as somebody saw them on the sheets; the kinds found; the light on objects over that without
probes; interiors' 5th and 95th percentile. --time N times start to PNG instead, ours over F3D's in turn, N times each.
Runs under the display it finds.
"""
import argparse
import json
import shutil
import sys
from pathlib import Path

from foreign_pictures import display_values, percentile, sheets
from foreign_runs import median, run


def models(path):
    names = ["repository", "commit", "licence", "kind", "file", "picture", "seen"]
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            yield dict(zip(names, line.split("\t")))


def last_line(text):
    lines = text.strip().splitlines()
    return lines[-1] if lines else ""


def mean_light(values):
    """Of the picture's middle, linear; `values` are display values."""
    return sum(value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4 for value in values) / max(len(values), 1)


def draw(options, number, model, path):
    """Renders one model and adds to `model` what was found."""
    stem = "%03d-%s" % (number, path.stem.replace(" ", "_"))
    model["ours"] = str(options.out / (stem + ".png"))
    status, text, cpu, peak = run([options.program, "info", str(path), "--json"])
    if status == 0:
        info = json.loads(text[text.index("{"):])
        model["found"], model["decided"] = info["fit"]["kind"], info["fit"]["decided"]
        model["warnings"] = info["warnings"]
        status, text, cpu, peak = run([options.program, "render", str(path), "-o", model["ours"], "--size", options.size])
    if status != 0:
        model["refused"] = last_line(text) or "exit status %d" % status
    else:
        model["cpuSeconds"], model["peakMiB"] = cpu, peak
        values = display_values(model["ours"])
        if model["found"] == "object":
            bare = str(options.out / (stem + "-bare.png"))
            run([options.program, "render", str(path), "-o", bare, "--size", options.size, "--set", "probes=[]"])
            without = display_values(bare)
            model["lightOverBare"] = mean_light(values) / max(mean_light(without), 1e-6)
            model["pixelsOtherThanBare"] = sum(a != b for a, b in zip(values, without))
        else:
            model["percentile5"], model["percentile95"] = percentile(values, 0.05), percentile(values, 0.95)
            camera, probes = info["cameras"][0]["position"], info["probes"]
            model["cameraInside"] = any(all(probe["influence"]["min"][i] <= camera[i] <= probe["influence"]["max"][i]
                                            for i in range(3)) for probe in probes)
    theirs = options.clones / model["repository"].replace("/", "+") / model["picture"]
    if model["picture"] == "-" and shutil.which("f3d"):
        theirs = options.out / (stem + "-f3d.png")
        run(["f3d", str(path), "--output=%s" % theirs, "--resolution=" + options.size.replace("x", ","), "--dry-run"])
    model["theirs"] = str(theirs)


def time_them(options, rows):
    """Start to PNG in turn, so that what else the machine does falls on both; CPU seconds and peak memory as ratios of medians."""
    ratios, memory = [], []
    for model, path in rows:
        ours, theirs = [], []
        for _ in range(options.time):
            out = str(options.out / "timed.png")
            ours.append(run([options.program, "render", str(path), "-o", out, "--size", "640x360"])[2:])
            theirs.append(run(["f3d", str(path), "--output=" + out, "--resolution=640,360", "--dry-run"])[2:])
        ratios.append(median([t[0] for t in ours]) / median([t[0] for t in theirs]))
        memory.append(median([t[1] for t in ours]) / median([t[1] for t in theirs]))
        print("%-32s CPU %.2f s : %.2f s = %.2f, peak %.0f : %.0f MiB = %.2f"
              % (path.stem[:32], median([t[0] for t in ours]), median([t[0] for t in theirs]), ratios[-1],
                 median([t[1] for t in ours]), median([t[1] for t in theirs]), memory[-1]), flush=True)
    print("CPU over F3D: median %.2f, worst %.2f; peak memory: median %.2f, worst %.2f"
          % (median(ratios), max(ratios), median(memory), max(memory)))


def report(rows):
    drawn = [row for row in rows if "refused" not in row]
    right = [row for row in drawn if row["seen"] == "right"]
    named = [row for row in drawn if row["seen"].startswith("named:")]
    wrong = [row for row in drawn if row["seen"].startswith("wrong:")]
    for row in wrong + named:
        print("%s: %s" % (row["file"], row["seen"]))
    for row in rows:
        if "refused" in row:
            print("%s: refused: %s" % (row["file"], row["refused"]))
    judged = len(right) + len(wrong)
    print("seen: %d right, %d wrong, %d with a named unsupported feature, %d refused; right of those without: %.1f %%"
          % (len(right), len(wrong), len(named), len(rows) - len(drawn), 100.0 * len(right) / max(judged, 1)))
    kinds = [row["found"] in row["kind"].split("|") for row in drawn]
    for row, good in zip(drawn, kinds):
        if not good:
            print("%s: found %s, is %s" % (row["file"], row["found"], row["kind"]))
    print("kinds: %d of %d right; interiors called objects: %d"
          % (sum(kinds), len(kinds), sum(row["found"] == "object" and row["kind"] == "interior" for row in drawn)))
    objects = [row for row in drawn if "lightOverBare" in row]
    if objects:
        print("light on %d objects over that without probes: least %.3f; pixels that differ: %d"
              % (len(objects), min(row["lightOverBare"] for row in objects), sum(row["pixelsOtherThanBare"] for row in objects)))
    inside = [row for row in drawn if row["found"] == "interior"]
    for row in inside:
        print("interior %-28s 5 %% %.3f, 95 %% %.3f, camera %s"
              % (Path(row["file"]).stem[:28], row["percentile5"], row["percentile95"],
                 "inside" if row["cameraInside"] else "OUTSIDE"))
    if inside:
        print("interiors: 5th percentile at least %.3f, 95th at most %.3f"
              % (min(row["percentile5"] for row in inside), max(row["percentile95"] for row in inside)))
    return 0 if all(kinds) else 1


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--from", dest="clones", type=Path, required=True)
    parser.add_argument("-o", dest="out", type=Path, required=True)
    parser.add_argument("--list", type=Path, default=Path(__file__).parent / "foreign_models.tsv")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--time", type=int, default=0)
    parser.add_argument("--sheets-only", action="store_true", help="judge and lay out what an earlier run drew")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    there, missing = [], 0
    for number, model in enumerate(models(options.list)):
        path = options.clones / model["repository"].replace("/", "+") / model["file"]
        if options.only and not any(text in str(path) for text in options.only):
            continue
        if not path.exists():
            missing += 1
            continue
        there.append((number, model, path))
    if missing:
        print("%d models are not in %s" % (missing, options.clones))
    if options.time:
        time_them(options, [(model, path) for _, model, path in there])
        return 0
    results = options.out / "results.json"
    before = {row["file"]: row for row in json.loads(results.read_text())} if results.exists() else {}
    rows = []
    for number, model, path in there:
        if options.sheets_only:
            model = before.get(model["file"], {}) | model
        else:
            draw(options, number, model, path)
            print("%-32s %-12s %-9s %s" % (path.stem[:32], model["kind"], model.get("found", "-"), model.get("refused", "")),
                  flush=True)
        rows.append(model)
        before[model["file"]] = model
        results.write_text(json.dumps(list(before.values()), indent=1))
    sheets(rows, options.out)
    return report(rows)


if __name__ == "__main__":
    sys.exit(main())
