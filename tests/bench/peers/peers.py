#!/usr/bin/env python3
"""Our scenes in other renderers, in turn on this machine: CPU time of a frame, from start to the first picture, of capture and filter,
and the largest memory, of all threads and processes. Prints a table of medians and ratios a scene; keeps a picture of each in OUT.

usage: tests/bench/peers/peers.py [OUT]      default: out/peers; see --help
needs: apt-get install xvfb godot3 blender f3d chromium nodejs npm; what is missing is left out and named
"""
import argparse
import json
import re
import shutil
import signal
import statistics
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # no folder of its own among the sources
import browser_peer  # noqa: E402
import plain_scene  # noqa: E402
import processes  # noqa: E402

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
MORE = 40  # further frames of a program that cannot time itself: it runs twice


def render(job, picture, *options):
    stats = job.folder / "stats.json"
    subprocess.run([job.program, "render", job.scene, "-o", picture, "--size", job.size, "--samples", str(job.samples), "--camera", "main",
                    "--set", "probes.%s.bounces=1" % job.probe, "--stats", stats, "--quiet", *options], check=True)
    return json.loads(stats.read_text())


def ours(job):
    """`boxprobe render`, its programs without constants, one capture without bounces as the others make it. Capture and filter are
    the program's own count, or what the first frame takes beyond one without reflections where that is more: software OpenGL draws later than
    it is asked to."""
    without = render(job, job.folder / "without.png", "--probes", "off")["times"]["startToFirstFrameCpuSeconds"]
    said = render(job, job.picture, "--frames", str(job.frames))
    times = said["times"]
    return {"frame": times["frameCpuSecondsMedian"], "start": times["startToFirstFrameCpuSeconds"],
            "capture": max(times["captureCpuSeconds"] + times["prefilterCpuSeconds"], times["startToFirstFrameCpuSeconds"] - without),
            "memory": said["memoryBytes"]["peakResident"] / 2**20,
            "renderer": said["gl"]["renderer"]}


def in_one_window(job):
    """Our programs with constants, as the window draws what rests, and stock VTK's, in turn in one process: milliseconds of bench_frame."""
    text, _, _ = processes.run([job.bench / "bench_frame", "--frames", job.frames, "--size", job.size, "--samples", job.samples, "--pictures",
                                job.folder, job.scene], job.folder)
    return [0.001 * float(value) for value in re.findall(r"median +([0-9.]+)", text)]


def ours_at_rest(job):
    frame, job.stock_frame = in_one_window(job)
    shutil.copyfile(job.folder / "ours.png", job.picture)
    shutil.copyfile(job.folder / "stock.png", job.picture.with_name("stock VTK.png"))
    return {"frame": frame}


def stock(job):
    """Lit by the scene's sky; its irradiance map of 32 texels, because VTK's own 256 take minutes."""
    text, _, memory = processes.run([job.bench / "bench_stock_first_frame", "--size", job.size, "--samples", job.samples, "--irradiance", "32",
                                     "--filter-time", job.scene], job.folder)
    start, filtered = map(float, text.split())
    measured = {"start": start, "capture": filtered, "memory": memory}
    return dict(measured, frame=job.stock_frame) if job.stock_frame else measured


def godot(job):
    for file in (HERE / "godot3").iterdir():
        shutil.copyfile(file, job.folder / file.name)
    text, _, memory = processes.run(["godot3", "--path", job.folder, "--audio-driver", "Dummy"], job.folder)
    first, settled, end, count = map(int, re.search(r"ticks (\d+) (\d+) (\d+) settled (\d+)", text).groups())
    frame = 0.01 * (end - settled) / job.frames
    capture = 0.01 * (settled - first) - count * frame  # beside the frames drawn meanwhile
    shutil.copyfile(job.folder / "picture.png", job.picture)
    return {"frame": frame, "start": 0.01 * first + capture, "capture": capture, "memory": memory,
            "renderer": re.search(r"drawn by (.*)", text).group(1)}


def blender(job):
    _, _, memory = processes.run(["blender", "--factory-startup", "--window-geometry", "0", "0", "800", "600", "--python",
                                  HERE / "blender_peer.py", "--", job.folder], job.folder)
    shutil.copyfile(job.folder / "picture.png", job.picture)
    return dict(json.loads((job.folder / "result.json").read_text()), memory=memory)


def f3d(job):
    """No probes: the scene's sky, or our probe as a picture, lights it. A frame is what a further pixel of a turned camera costs."""
    camera = job.config["camera"]

    def draw(moves):
        events = job.folder / "moves.log"
        lines = ["# StreamVersion 1.1", "LeftButtonPressEvent 100 100 0 0 0 0 0"]
        lines += ["MouseMoveEvent %d 100 0 0 0 0 0" % (101 - i % 2) for i in range(moves)] + ["LeftButtonReleaseEvent 100 100 0 0 0 0 0"]
        events.write_text("\n".join(lines) + "\n")
        command = ["f3d", job.folder / "model.glb", "--hdri=%s" % (job.folder / job.config["hdri"]), "--resolution=%s" % job.size.replace("x", ","),
                   "--up=+Y", "--dry-run", "--quiet", "--camera-position=%s" % ",".join(map(str, camera["position"])),
                   "--camera-focal-point=%s" % ",".join(map(str, camera["target"])), "--camera-view-angle=%s" % camera["verticalFovDegrees"]]
        return processes.run(command + (["--interaction-test-play=%s" % events, "--output=%s" % (job.folder / "moved.png")] if moves else
                                        ["--output=%s" % job.picture]), job.folder)

    _, start, memory = draw(0)
    few, many = draw(5)[1], draw(5 + MORE)[1]
    return {"start": start, "frame": (many - few) / MORE, "memory": memory}


def page(name):
    return lambda job: browser_peer.Peer(name, job.folder, job.modules, job.picture).measure()


# Name, what it needs, how it is measured.
PEERS = [("boxprobe", [], ours), ("boxprobe at rest", [], ours_at_rest), ("stock VTK", [], stock), ("Godot 3", ["godot3"], godot),
         ("Eevee", ["blender"], blender), ("F3D", ["f3d"], f3d), ("three.js", ["chromium", "npm"], page("three.js")),
         ("Babylon.js", ["chromium", "npm"], page("babylon.js"))]


class Job:
    """One scene as all peers get it."""

    def __init__(self, arguments, name, modules):
        self.program, self.frames, self.samples, self.size, self.modules = (
            arguments.program, arguments.frames, arguments.samples, arguments.size, modules)
        self.bench = arguments.program.parents[1] / "tests/bench"
        self.scene = ROOT / "data/scenes" / (name + ".boxprobe.json")
        self.folder = arguments.out / name
        width, height = map(int, arguments.size.split("x"))
        self.config = plain_scene.write(self.program, self.scene, self.folder, width, height, self.samples)
        self.config["frames"] = self.frames
        (self.folder / "config.json").write_text(json.dumps(self.config))
        self.probe = self.config["probe"]["name"]
        self.stock_frame = None  # measured beside ours


def installed_modules(out):
    """The web engines from npm, of the versions that the outside tests draw with."""
    folder = out / "node"
    folder.mkdir(parents=True, exist_ok=True)
    wanted = ROOT / "tests/outside/engines/package.json"
    if not (folder / "node_modules/three").is_dir():
        shutil.copyfile(wanted, folder / "package.json")
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--ignore-scripts"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return folder / "node_modules"


def cell(values, key, ours_too, scale, digits):
    if not any(key in value for value in values):
        return "–"
    middle = statistics.median(value[key] for value in values if key in value)
    base = [value[key] for value in ours_too if key in value]
    text = "%.*f" % (digits, scale * middle)
    return text if not base or values is ours_too else "%s (%.2f)" % (text, statistics.median(base) / middle)


def print_table(name, arguments, results):
    print("\n%s, %s, %d sample%s per pixel, %d rounds; in brackets: boxprobe's over it\n" % (
        name, arguments.size, arguments.samples, "s" if arguments.samples > 1 else "", arguments.rounds))
    print("| | frame, ms | start to first picture, s | capture and filter, s | memory, MiB |\n|---|---|---|---|---|")
    base = results.get("boxprobe", [])
    for peer, values in results.items():
        columns = [cell(values, key, base, scale, digits) for key, scale, digits in
                   (("frame", 1e3, 1), ("start", 1, 2), ("capture", 1, 2), ("memory", 1, 0))]
        print("| %s | %s |" % (peer, " | ".join(columns)), flush=True)
    for peer, values in results.items():
        if values and "renderer" in values[0]:
            print("%s draws with %s" % (peer, values[0]["renderer"]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="?", type=Path, default=ROOT / "out/peers", help="folder for pictures and results.json")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--frames", type=int, default=40, help="of which the mean is one frame's time")
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--samples", type=int, default=1, choices=(1, 4), help="per pixel; F3D has 1 always")
    parser.add_argument("--scene", action="append", choices=("room", "building"))
    parser.add_argument("--peer", action="append", help="only these, by name")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/boxprobe")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # the programs it started end with it
    arguments.out, arguments.program = arguments.out.resolve(), arguments.program.resolve()
    if not arguments.program.is_file():
        raise SystemExit("peers: %s is not there; build it with ./run --help" % arguments.program)
    peers = []
    for name, needed, measure in PEERS:
        missing = [program for program in needed if shutil.which(program) is None]
        if missing:
            print("left out: %s (apt-get install %s)" % (name, " ".join(missing)))
        elif not arguments.peer or name in arguments.peer:
            peers.append((name, measure))
    modules = installed_modules(arguments.out) if any("npm" in needed for name, needed, _ in PEERS if name in dict(peers)) else None
    everything = {}
    with processes.Display():
        for name in arguments.scene or ("room", "building"):
            job = Job(arguments, name, modules)
            results = {peer: [] for peer, _ in peers}
            for turn in range(arguments.rounds):
                for peer, measure in peers:
                    job.picture = arguments.out / ("%s, %s.png" % (name, peer))
                    try:
                        results[peer].append(measure(job))
                    except (RuntimeError, OSError, AttributeError, ValueError, subprocess.SubprocessError) as problem:
                        print("peers: %s, round %d: %s" % (peer, turn + 1, problem), file=sys.stderr)
            everything[name] = results
            print_table(name, arguments, results)
    (arguments.out / "results.json").write_text(json.dumps(everything, indent=1))


if __name__ == "__main__":
    main()
