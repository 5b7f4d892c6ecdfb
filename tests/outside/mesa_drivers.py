#!/usr/bin/env python3
"""Scenes by Mesa's other drivers that need no card, beside llvmpipe's picture.

usage: mesa_drivers.py BOXPROBE SCENES FOLDER [--drivers softpipe,zink,virgl] [--scenes NAME,...] [--shard I/N] [--size 96x54]

softpipe interprets TGSI, as virgl's guests and VMware's hand it on; zink goes by SPIR-V and Vulkan (package mesa-vulkan-drivers, on its
lavapipe); virgl sends its programs as text to a server (package virgl-server), as in a virtual machine. What is not installed is said in
one line. Captures have 32 texels a face and one bounce, and pictures one sample per pixel, since softpipe has no more.

Prints how many pixels differ by more than 1/255, the largest step, decibels; how many of them differ as well where VTK's own program draws
the scene (`--probes off`: how the driver samples textures and covers edges), or lie beside such; the largest step of the others, and the
surfaces that the farthest of those show. Fails where a driver ends with an error or a signal, where a picture is less than 30 dB from
llvmpipe's (`glass`: 40), or where the others are further apart than the list below allows and explains.
"""
import argparse
import json
import os
import shutil
import socket
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True  # nothing beside the sources
import png_pictures  # noqa: E402

# Steps, in 1/255, of pixels that VTK's own program draws alike; more for what the table in README.md explains.
MOST_STEP, MORE = 8, {}
LEAST_DECIBELS, OF_SCENE = 30.0, {"glass": 40.0}
VIRGL_SOCKET = Path("/tmp/.virgl_test")


def environment_of(driver):
    """What makes Mesa take it, or the line that says what is missing."""
    if driver in ("llvmpipe", "softpipe"):
        return {"GALLIUM_DRIVER": driver, "LIBGL_ALWAYS_SOFTWARE": "1"}
    if driver == "zink":
        lavapipe = [str(path) for path in Path("/usr/share/vulkan/icd.d").glob("lvp_icd*.json")]
        if not lavapipe:
            return "left out: zink, as package mesa-vulkan-drivers is not installed"
        return {"MESA_LOADER_DRIVER_OVERRIDE": "zink", "LIBGL_ALWAYS_SOFTWARE": "1", "VK_ICD_FILENAMES": lavapipe[0]}
    if shutil.which("virgl_test_server") is None:
        return "left out: virgl, as package virgl-server is not installed"
    return {"GALLIUM_DRIVER": "virpipe", "LIBGL_ALWAYS_SOFTWARE": "1"}


class VirglServer:
    """Where it waits is the same for every user of a machine, and stays there when it is killed."""

    def __enter__(self):
        if VIRGL_SOCKET.exists():  # Mesa knows this place alone
            if VIRGL_SOCKET.lstat().st_uid != os.getuid() or answers(VIRGL_SOCKET):
                sys.exit(f"{VIRGL_SOCKET} is somebody else's: end that virgl server first")
            VIRGL_SOCKET.unlink()
        command = ["virgl_test_server", "--use-egl-surfaceless"]
        self.started = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for _ in range(100):
            if VIRGL_SOCKET.exists() or self.started.poll() is not None:
                break
            time.sleep(0.1)
        return self

    def __exit__(self, *_):
        self.started.terminate()
        self.started.wait()


def answers(path):
    """Does a server listen at this socket?"""
    with socket.socket(socket.AF_UNIX) as asked:
        return asked.connect_ex(str(path)) == 0


def small_captures(scene):
    """--set for each probe of the file."""
    arguments = []
    for probe in json.loads(scene.read_text()).get("probes", []):
        for field in ("faceSize=32", "bounces=1"):
            arguments += ["--set", f"probes.\"{probe['name']}\".{field}"]
    return arguments


def run(program, arguments, driver):
    variables = dict(os.environ, GALLIVM_PERF="nopt", **environment_of(driver))
    return subprocess.run([program, *arguments], env=variables, capture_output=True, text=True)


def draw(options, scene, picture, driver, *more):
    picture.unlink(missing_ok=True)
    arguments = ["render", str(scene), "-o", str(picture), "--size", options.size, "--samples", "1", "--quiet", *small_captures(scene)]
    return run(options.program, [*arguments, *more], driver)


def steps(first, second):
    """Of each pixel, the largest step of a channel."""
    return [max(abs(first[2][i + c] - second[2][i + c]) for c in range(3)) for i in range(0, len(first[2]), 3)]


def beside(apart, width):
    """The places that differ, and those around them."""
    return {at + y * width + x for at, step in enumerate(apart) if step > 1 for y in (-1, 0, 1) for x in (-1, 0, 1)}


def surfaces(options, scene, places, width):
    """Names of the objects at these places, by llvmpipe."""
    names = []
    for at, step in places:
        done = run(options.program, ["explain", str(scene), "--pixel", f"{at % width},{at // width}", "--size", options.size, "--json",
                                     "--quiet", *small_captures(scene)], "llvmpipe")
        found = json.loads(done.stdout) if done.returncode == 0 else {}
        names.append(f"{(found.get('surface') or {}).get('object', 'sky')} at {at % width},{at // width} by {step}")
    return names


def compare(options, driver, scene, folder):
    """A line of the table; what is wrong."""
    name = scene.name.split(".")[0]
    read = lambda kind: png_pictures.read(folder / f"{name}-{kind}.png")  # noqa: E731
    began = time.monotonic()
    done = draw(options, scene, folder / f"{name}-{driver}.png", driver)
    took = time.monotonic() - began
    if done.returncode != 0:
        return f"{name:12} {driver:9} ended with {done.returncode}", [f"{done.stderr.strip().splitlines()[-1:]}"]
    apart, width = png_pictures.Difference(read("llvmpipe"), read(driver)), read(driver)[0]
    line, wrong, others = f"{name:12} {driver:9} {apart}", [], []
    if apart.beyond:
        for by in {driver} | ({"llvmpipe"} if not (folder / f"{name}-llvmpipe-plain.png").exists() else set()):
            done = draw(options, scene, folder / f"{name}-{by}-plain.png", by, "--probes", "off")
            if done.returncode != 0:
                return f"{line}; without probes {by} ended with {done.returncode}", [f"{done.stderr.strip().splitlines()[-1:]}"]
        plain = beside(steps(read("llvmpipe-plain"), read(f"{driver}-plain")), width)
        others = [(at, step) for at, step in enumerate(steps(read("llvmpipe"), read(driver))) if step > 1 and at not in plain]
        others.sort(key=lambda place: -place[1])
        line += f"; {apart.beyond - len(others)} as without probes, the others by at most {others[0][1] if others else 0}"
        if others and others[0][1] > 3:
            line += "\n    " + "; ".join(surfaces(options, scene, others[:3], width))
    if others and others[0][1] > MORE.get((driver, name), MOST_STEP):
        wrong.append(f"a step of {others[0][1]}, and {MORE.get((driver, name), MOST_STEP)} is the most")
    least = OF_SCENE.get(name, LEAST_DECIBELS)
    if apart.decibels < least:
        wrong.append(f"{apart.decibels:.1f} dB, and {least} is the least")
    return f"{line} ({took:.0f} s)", wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder_of_scenes", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--drivers", default="softpipe,zink,virgl")
    parser.add_argument("--scenes", help="names, with commas between them")
    parser.add_argument("--shard", default="1/1")
    parser.add_argument("--size", default="96x54")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    drivers = []
    for driver in options.drivers.split(","):
        said = environment_of(driver)
        print(said, flush=True) if isinstance(said, str) else drivers.append(driver)
    scenes = sorted(options.folder_of_scenes.glob("*.boxprobe.json"))
    truth = options.folder_of_scenes.parent.parent / "tests/truth/lit/scenes/furniture.boxprobe.json"
    scenes += [truth] if truth.exists() else []
    names = options.scenes.split(",") if options.scenes else [scene.name.split(".")[0] for scene in scenes]
    share, shares = map(int, options.shard.split("/"))
    scenes = [scene for scene in scenes if scene.name.split(".")[0] in names][share - 1::shares]
    failed = 0
    for scene in scenes if drivers else []:
        reference = options.folder / f"{scene.name.split('.')[0]}-llvmpipe.png"
        (options.folder / f"{scene.name.split('.')[0]}-llvmpipe-plain.png").unlink(missing_ok=True)
        done = draw(options, scene, reference, "llvmpipe")
        if done.returncode != 0:
            print(f"{scene.name}: llvmpipe ended with {done.returncode}: {done.stderr.strip()}")
            failed += 1
            continue
        for driver in drivers:
            if driver == "virgl":
                with VirglServer():
                    line, wrong = compare(options, driver, scene, options.folder)
            else:
                line, wrong = compare(options, driver, scene, options.folder)
            print("\n  WRONG ".join([line, *wrong]), flush=True)
            failed += len(wrong)
    print(f"{failed} wrong")
    return 77 if not drivers else 1 if failed or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
