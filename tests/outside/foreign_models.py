#!/usr/bin/env python3
"""Other people's models, as boxprobe opens them without a scene: kind, light and a picture of each, beside F3D's.

usage: foreign_models.py BOXPROBE --from DIR -o OUT [--list FILE] [--only TEXT] [--size WxH] [--time]

DIR holds checked-out clones, OWNER+NAME for each repository of the list; nothing is downloaded. OUT gets index.html, a
contact sheet, and results.json. --time measures start to PNG in CPU seconds and peak memory, ours over F3D's.
Runs under the display it finds; pictures of F3D need the package f3d.
"""
import argparse
import html
import json
import os
import resource
import shutil
import subprocess
import sys
from pathlib import Path


def run(command, timeout=300):
    """Exit status, output, CPU seconds and peak MiB of a program and its children."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:  # a process of its own for each, whose children's use is this program's alone
        os.close(read)
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, errors="replace")
            status, text = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            status, text = 124, "more than %d s" % timeout
        use = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = json.dumps([status, text[-4000:], use.ru_utime + use.ru_stime, use.ru_maxrss / 1024])
        with os.fdopen(write, "w") as pipe:
            pipe.write(answer)
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        answer = pipe.read()
    os.waitpid(child, 0)
    return json.loads(answer)


def models(path):
    for line in path.read_text().splitlines():
        if line and not line.startswith("#"):
            repository, commit, licence, kind, file = line.split("\t")
            yield {"repository": repository, "commit": commit, "licence": licence, "kind": kind, "file": file}


def median(values):
    values = sorted(values)
    return values[len(values) // 2] if values else 0.0


def main():
    here = Path(__file__).parent
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--from", dest="clones", type=Path, required=True)
    parser.add_argument("-o", dest="out", type=Path, required=True)
    parser.add_argument("--list", type=Path, default=here / "foreign_models.tsv")
    parser.add_argument("--only", default="")
    parser.add_argument("--size", default="480x270")
    parser.add_argument("--time", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    f3d = shutil.which("f3d")
    size = options.size.replace("x", ",")

    rows, right, wrong, refused, missing = [], 0, 0, 0, 0
    for number, model in enumerate(models(options.list)):
        path = options.clones / model["repository"].replace("/", "+") / model["file"]
        if options.only not in str(path):
            continue
        if not path.exists():
            missing += 1
            continue
        stem = "%03d-%s" % (number, path.stem)
        ours, theirs = options.out / (stem + ".png"), options.out / (stem + "-f3d.png")
        status, text, _, _ = run([options.program, "info", str(path), "--json"])
        if status != 0:
            refused += 1
            model["problem"] = text.strip().splitlines()[-1] if text.strip() else "exit status %d" % status
        else:
            info = json.loads(text[text.index("{"):]) if len(text) < 4000 else None
            if info is None:  # longer than what run() keeps
                info = json.loads(subprocess.run([options.program, "info", str(path), "--json"], capture_output=True,
                                                 text=True, check=True).stdout)
            model["found"], model["decided"] = info["fit"]["kind"], info["fit"]["decided"]
            good = model["found"] in model["kind"].split("|")
            right, wrong = right + good, wrong + (not good)
            status, text, cpu, peak = run([options.program, "render", str(path), "-o", str(ours), "--size", options.size])
            model["cpuSeconds"], model["peakMiB"] = cpu, peak
            if status != 0:
                model["problem"] = text.strip().splitlines()[-1] if text.strip() else "exit status %d" % status
            if f3d:
                command = [f3d, str(path), "--output=%s" % theirs, "--resolution=" + size, "--dry-run"]
                status, text, cpu, peak = run(command)
                model["f3dCpuSeconds"], model["f3dPeakMiB"] = cpu, peak
        rows.append(model | {"picture": ours.name, "f3d": theirs.name})
        print("%-28s %-14s %-9s %s" % (path.stem[:28], model["kind"], model.get("found", "-"), model.get("problem", "")),
              flush=True)

    with open(options.out / "index.html", "w") as page:
        page.write("<!doctype html><meta charset=utf-8><title>Foreign models</title><style>body{font:12px sans-serif}"
                   "figure{display:inline-block;margin:4px;width:490px}img{width:240px}.wrong{background:#fcc}</style>")
        for row in rows:
            good = row.get("found") in row["kind"].split("|")
            page.write("<figure class=%s><img src='%s' alt=''> <img src='%s' alt=''><figcaption>%s, %s: %s</figcaption>"
                       "</figure>\n" % ("right" if good else "wrong", row["picture"], row["f3d"],
                                        html.escape(row["file"]), row["kind"],
                                        html.escape(row.get("problem") or row.get("decided", ""))))
    result = {"right": right, "wrong": wrong, "refused": refused, "missing": missing, "models": rows}
    timed = [row for row in rows if "f3dCpuSeconds" in row]
    if options.time and timed:
        ratios = [row["cpuSeconds"] / max(row["f3dCpuSeconds"], 1e-3) for row in timed]
        memory = [row["peakMiB"] / max(row["f3dPeakMiB"], 1.0) for row in timed]
        result["cpuRatio"] = {"median": median(ratios), "worst": max(ratios)}
        result["memoryRatio"] = {"median": median(memory), "worst": max(memory)}
        print("CPU over F3D: median %.2f, worst %.2f; peak memory: median %.2f, worst %.2f"
              % (median(ratios), max(ratios), median(memory), max(memory)))
    (options.out / "results.json").write_text(json.dumps(result, indent=1))
    print("kinds: %d right, %d wrong, %d refused; %d not there" % (right, wrong, refused, missing))
    return 0 if wrong == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
