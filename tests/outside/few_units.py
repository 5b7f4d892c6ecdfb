#!/usr/bin/env python3
"""Every scene as a card of few texture units draws it, beside the same scene without that limit.

usage: few_units.py BOXPROBE SCENES FOLDER [--units 16] [--by COMMAND] [--scenes NAME,...] [--shard I/N] [--size WxH] [--window]

Scenes are those of the folder SCENES, by their own technique and by impostors, and four that are made here: a floor of five or of all 17
textures a material can have, among four probes that overlap. Of each: `render` with and without the limit, and `explain` at two pixels.
Where nothing is said to be given up, no pixel may differ by more than 1/255. Something must be said to be given up exactly where a program
of the scene has more samplers than units, as glslang counts them (without glslangValidator that is not looked at). `explain` explains the
same, or is refused in one line. Nothing may end by a signal.

--by: a command that limits OpenGL itself and starts the program that follows it; else BOXPROBE_TEXTURE_UNITS does. --window opens each
scene in a window instead, switches the Explain tool on with E, points at the picture, and switches it off again: the picture must be what
it was, which needs xdotool, imagemagick and a display of its own (xvfb-run).
"""
import argparse
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True  # nothing beside the sources
import png_pictures  # noqa: E402
import programs  # noqa: E402

FEWER = "too few texture units"
TEXTURES = ["baseColor", "roughMetal", "normal", "occlusion", "emissive", "coat", "coatRoughness", "coatNormal", "specular", "specularColor",
            "sheenColor", "sheenRoughness", "iridescence", "filmThickness", "anisotropy", "transmission", "thickness"]


def material(count):
    """A floor's material with `count` textures, the first of TEXTURES, each a picture of its own."""
    found = {name: {"index": i} for i, name in enumerate(TEXTURES[:count])}
    made = {"name": "wide floor", "normalTexture": found["normal"], "occlusionTexture": found["occlusion"],
            "emissiveTexture": found["emissive"], "emissiveFactor": [0.1, 0.1, 0.1],
            "pbrMetallicRoughness": {"baseColorTexture": found["baseColor"], "metallicRoughnessTexture": found["roughMetal"],
                                     "roughnessFactor": 0.4, "metallicFactor": 0.5}}
    if count == len(TEXTURES):
        made["extensions"] = {
            "KHR_materials_clearcoat": {
                "clearcoatFactor": 0.8, "clearcoatTexture": found["coat"], "clearcoatRoughnessFactor": 0.2,
                "clearcoatRoughnessTexture": found["coatRoughness"], "clearcoatNormalTexture": found["coatNormal"]},
            "KHR_materials_specular": {"specularTexture": found["specular"], "specularColorTexture": found["specularColor"]},
            "KHR_materials_sheen": {"sheenColorFactor": [0.2, 0.1, 0.1], "sheenColorTexture": found["sheenColor"],
                                    "sheenRoughnessFactor": 0.5, "sheenRoughnessTexture": found["sheenRoughness"]},
            "KHR_materials_iridescence": {"iridescenceFactor": 0.5, "iridescenceTexture": found["iridescence"],
                                          "iridescenceThicknessTexture": found["filmThickness"]},
            "KHR_materials_anisotropy": {"anisotropyStrength": 0.4, "anisotropyTexture": found["anisotropy"]},
            "KHR_materials_transmission": {"transmissionFactor": 0.2, "transmissionTexture": found["transmission"]},
            "KHR_materials_volume": {"thicknessFactor": 0.1, "thicknessTexture": found["thickness"]}}
    return made


def write_floor(path, count):
    """A .glb of one floor, 3 cm above that of `room`, with that material."""
    parts, views, accessors = b"", [], []

    def add(data):
        nonlocal parts
        views.append({"buffer": 0, "byteOffset": len(parts), "byteLength": len(data)})
        parts += data + b"\0" * (-len(data) % 4)
        return len(views) - 1

    def values(numbers, kind, width, component=5126):
        view = add(struct.pack(f"<{len(numbers)}{'f' if component == 5126 else 'H'}", *numbers))
        columns = [numbers[i::width] for i in range(width)]
        accessors.append({"bufferView": view, "componentType": component, "count": len(numbers) // width, "type": kind,
                          "min": [min(c) for c in columns], "max": [max(c) for c in columns]})
        return len(accessors) - 1

    corners = [(-3.1, 2.4), (2.7, 2.4), (2.7, -2.2), (-3.1, -2.2)]
    mesh = {"attributes": {"POSITION": values([v for x, z in corners for v in (x, 0.03, z)], "VEC3", 3),
                           "NORMAL": values([0.0, 1.0, 0.0] * 4, "VEC3", 3),
                           "TEXCOORD_0": values([0.0, 0.0, 3.0, 0.0, 3.0, 2.0, 0.0, 2.0], "VEC2", 2)},
            "indices": values([0, 1, 2, 0, 2, 3], "SCALAR", 1, 5123), "material": 0}
    images = []
    for number, name in enumerate(TEXTURES[:count]):
        level = [(97 * number + 11 * (x * x + 3 * y) + 40 * ((x ^ y) & 1)) % 150 + 90 for y in range(8) for x in range(8)]
        normal = name.lower().endswith("normal")
        rgb = bytes(v for i in level for v in ((118 + i % 20, 118 + i % 17, 250) if normal else (i, 255 - i // 3, 200 - i // 2)))
        images.append({"bufferView": add(png_pictures.png_bytes(8, 8, rgb)), "mimeType": "image/png"})
    made = material(count)
    model = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "wide floor"}],
             "meshes": [{"primitives": [mesh]}], "materials": [made], "images": images, "textures": [{"source": i} for i in range(count)],
             "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(parts)}],
             "extensionsUsed": sorted(made.get("extensions", {}))}
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(parts)) + struct.pack("<I4s", len(text), b"JSON") + text +
                     struct.pack("<I4s", len(parts), b"BIN\0") + parts)


def write_wide_scenes(scenes, folder):
    """The four scenes of many samplers; their files."""
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(scenes / "room.glb", folder)
    made = []
    for count in (5, len(TEXTURES)):
        write_floor(folder / f"floor{count}.glb", count)
        for technique in ("box", "impostor"):
            probes = [{"name": f"p{i}", "origin": [0.2 + 0.3 * i, 1.4, -0.5], "box": {"min": [-4, 0, -3], "max": [4, 3, 3]},
                       "influence": {"min": [-4.1, -0.1, -3.1], "max": [4.1, 3.1, 3.1]}, "blendDistance": 1.0, "faceSize": 64,
                       "bounces": 1, "technique": technique} for i in range(4)]
            made.append(folder / f"{count}-textures-{technique}.boxprobe.json")
            made[-1].write_text(json.dumps({
                "format": "boxprobe-scene", "version": 1, "models": [{"file": "room.glb"}, {"file": f"floor{count}.glb"}],
                "sky": {"color": [0.2, 0.3, 0.5]}, "probes": probes,
                "cameras": {"main": {"position": [-3.5, 2.1, 2.7], "target": [0.8, 0.9, -1.5], "up": [0, 1, 0],
                                     "verticalFovDegrees": 60}}}))
    return made


class Runs:
    """The program, with and without the limit."""

    def __init__(self, options):
        self.program, self.units, self.by = options.program, options.units, options.by.split() if options.by else []

    def start(self, arguments, limited, environment=None, **how):
        variables = dict(os.environ, GALLIVM_PERF="nopt", **(environment or {}))
        if limited and not self.by:
            variables["BOXPROBE_TEXTURE_UNITS"] = str(self.units)
        if limited and self.by:
            variables["LIMIT_SAMPLERS"] = str(self.units)
        command = [*(self.by if limited else []), self.program, *arguments]
        return subprocess.Popen(command, env=variables, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **how)

    def run(self, arguments, limited, environment=None):
        """(exit status, standard output, lines of standard error)"""
        started = self.start(arguments, limited, environment)
        out, err = started.communicate()
        return started.returncode, out, err.strip().splitlines()


def most_samplers(folder, work):
    """Of all programs that Mesa wrote to `folder`; None without glslangValidator."""
    if shutil.which("glslangValidator") is None:
        return None
    most = 0
    declared = sorted(((len(re.findall(r"^\s*uniform\s+\w*sampler", pair[1], re.M)), pair) for pair in programs.captured_in(folder)), reverse=True)
    for count, pair in declared:
        if count > most:  # those in use are no more than those that are declared
            _, reflection = programs.checked(pair, work, ["-l", "-q"])
            most = max(most, programs.counts(reflection)[0])
    return most


def drawn(runs, name, scene, more, options, folder):
    """One line of the table; what is wrong."""
    wrong, said, pictures, most = [], [], [], None
    for limited in (False, True):
        picture = folder / f"{name}{'-few' if limited else ''}.png"
        with tempfile.TemporaryDirectory() as captured:
            programs_to = {} if limited else {"MESA_SHADER_CAPTURE_PATH": captured, "MESA_SHADER_CACHE_DISABLE": "1"}
            status, _, lines = runs.run(["render", str(scene), "-o", str(picture), "--size", options.size, *more], limited, programs_to)
            if not limited:
                most = most_samplers(Path(captured), folder)
        if status != 0:
            return f"{name}: render ended with {status}", [f"{name}: {lines[-1:]}"]
        said = [line for line in lines if FEWER in line]
        if said and not limited:
            wrong.append(f"{name}: said without a limit: {said[0]}")
        pictures.append(png_pictures.read(picture))
    apart = png_pictures.Difference(*pictures)
    if not said and apart.largest > 1:
        wrong.append(f"{name}: nothing was said, and {apart}")
    if most is not None and bool(said) != (most > runs.units):
        wrong.append(f"{name}: {most} samplers, and {'something' if said else 'nothing'} is said to be given up")
    explained = []
    width, height = pictures[0][:2]
    for pixel in (f"{width // 2},{height * 3 // 4}", f"{width // 3},{height // 2}"):
        found = [runs.run(["explain", str(scene), "--pixel", pixel, "--size", options.size, *more], limited) for limited in (False, True)]
        # Only the script's own floors may leave no unit for the shader that explains.
        refused = found[1][0] == 1 and "textures" in name and "refuses the shader that explains" in (found[1][2] or [""])[-1]
        explained.append("refused" if refused else "explained")
        if found[0][0] != 0 or not (found[1][0] == 0 or refused):
            wrong.append(f"{name}: explain {pixel} ended with {found[0][0]} and {found[1][0]}: {found[1][2][-1:]}")
        elif not refused and not said and found[0][1] != found[1][1]:
            wrong.append(f"{name}: explain {pixel} tells something else")
    line = f"{name:34} {most if most is not None else '?':>8}  {str(apart):48} {', '.join(explained)}"
    return "\n    ".join([line, *said]), wrong


class Window:
    """The scene in a window of this display, and its picture."""

    def __init__(self, runs, scene, folder):
        # Qt's settings go to a folder of their own, so that a window of before does not tell how this one looks.
        self.folder = folder
        self.started = runs.start([str(scene)], True, {"XDG_CONFIG_HOME": str(folder / "config")}, start_new_session=True)
        self.number = 0

    def do(self, *arguments):
        subprocess.run(["xdotool", *arguments], check=False, capture_output=True)

    def ended(self):
        return self.started.poll() is not None

    def processor_seconds(self):
        """Spent by the program and its threads until now."""
        try:
            fields = Path(f"/proc/{self.started.pid}/stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            return 0.0
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def at_rest(self, seconds):
        """What the view shows once the program has nothing left to do; None if it goes on for longer.

        Two equal pictures do not show that: captures, programs and single frames each take longer than what is between two pictures. A
        program that captures, compiles or averages takes processor time; at rest it takes none. It pauses for up to two seconds between.
        """
        spent, calm, until = self.processor_seconds(), 0, time.monotonic() + seconds
        while time.monotonic() < until and not self.ended():
            time.sleep(4.0)
            before, spent = spent, self.processor_seconds()
            calm = calm + 1 if spent - before < 0.1 else 0
            if calm < 2:
                continue
            self.number += 1
            picture = self.folder / f"window{self.number % 2}.png"
            # The view alone: panels show what was explained last.
            subprocess.run(["import", "-window", "root", "-crop", "690x780+250+75", "+repage", "-depth", "8", "-define", "png:color-type=2",
                            str(picture)], check=False)
            now = png_pictures.read(picture)
            if len(set(now[2])) > 60:
                return now
        return None

    def close(self):
        self.do("key", "ctrl+q")
        try:
            _, err = self.started.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            os.killpg(self.started.pid, signal.SIGKILL)
            return None, ["does not close"]
        return self.started.returncode, err.strip().splitlines()


def in_window(runs, name, scene, options, folder):
    window = Window(runs, scene, folder)
    wrong, before, explaining, after = [], None, None, None
    aside, middle = ("mousemove", "3", "3"), ("mousemove", "600", "640")
    try:
        window.do(*aside)
        before = window.at_rest(options.seconds)
        if before is None:
            return f"{name}: not at rest", [f"{name}: {'the window ended' if window.ended() else f'not at rest within {options.seconds:g} s'}"]
        shutil.copy(folder / f"window{window.number % 2}.png", folder / f"{name}-window-before.png")
        window.do("search", "--onlyvisible", "--name", "Boxprobe", "windowfocus")  # no window manager gives it the keys
        window.do(*middle, "key", "e")
        window.do("mousemove_relative", "15", "40")
        explaining = window.at_rest(options.seconds)
        window.do(*aside, "key", "e")
        after = window.at_rest(options.seconds)
        if after is not None:
            shutil.copy(folder / f"window{window.number % 2}.png", folder / f"{name}-window.png")
    finally:
        status, lines = window.close()
    if status != 0 or None in (before, explaining, after):
        what = f"the window ended with {status}" if status != 0 else "not at rest"
        return f"{name}: {what}", [f"{name}: {what}: {lines[-1:]}"]
    on, off = png_pictures.Difference(before, explaining), png_pictures.Difference(before, after)
    if on.beyond < 500:
        wrong.append(f"{name}: E shows nothing")
    if off.largest > 0:
        wrong.append(f"{name}: after E the window is another: {off}")
    return f"{name:34} with E {on.beyond} pixels change; afterwards {off}", wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder_of_scenes", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--units", type=int, default=16)
    parser.add_argument("--by")
    parser.add_argument("--scenes", help="names, with commas between them")
    parser.add_argument("--shard", default="1/1")
    parser.add_argument("--size", default="160x90")
    parser.add_argument("--window", action="store_true")
    parser.add_argument("--seconds", type=float, default=1800.0, help="that a window is given to come to rest")
    options = parser.parse_args()
    for needed, package in (("xdotool", "xdotool"), ("import", "imagemagick")) if options.window else ():
        if shutil.which(needed) is None:
            print(f"left out: package {package} is not installed")
            return 77
    options.folder.mkdir(parents=True, exist_ok=True)
    scenes = sorted(options.folder_of_scenes.glob("*.boxprobe.json"))
    if (options.folder_of_scenes / "room.glb").exists():
        scenes = write_wide_scenes(options.folder_of_scenes, options.folder / "wide") + scenes
    names = options.scenes.split(",") if options.scenes else [scene.name.split(".")[0] for scene in scenes]
    share, shares = map(int, options.shard.split("/"))
    scenes = [scene for scene in scenes if scene.name.split(".")[0] in names][share - 1::shares]
    runs, failed = Runs(options), []
    beside = "in the window, after E beside before" if options.window else "beside unlimited"
    print(f"{'scene':34} samplers  limited to {options.units} {beside}", flush=True)
    for scene in scenes:
        own = scene.name.split(".")[0]
        for more in [[]] if options.window or "textures" in own else [[], ["--technique", "impostor"]]:
            name = " ".join([own, *more[1:]])
            if options.window:
                line, wrong = in_window(runs, name, scene, options, options.folder)
            else:
                line, wrong = drawn(runs, name, scene, more, options, options.folder)
            print("\n  WRONG ".join([re.sub(r"^boxprobe: ", "", line, flags=re.M), *wrong]), flush=True)
            failed += wrong
    print(f"{len(failed)} wrong")
    return 1 if failed or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
