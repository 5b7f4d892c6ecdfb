#!/usr/bin/env python3
"""Every OpenGL program that the program draws its scenes with, held against Khronos' compilers and against the least that OpenGL promises.

usage: programs.py BOXPROBE SCENES FOLDER [SCENE...] [--set PLACE=VALUE]...

Mesa writes each program as it reaches the driver. glslangValidator checks and links it as GLSL 1.50, as which it is compiled, and as
SPIR-V, which spirv-val checks; for that alone gl_FragData becomes an output of its own. Samplers and components of uniforms are those
that glslang's linker finds in use by the fragment shader. Fails where a compiler refuses a program, where a program of a shipped scene
has more than 16 samplers, or more than 1,024 components (what OpenGL promises). --set goes to the program: with smaller faces of its
probes a large scene is drawn by the same programs in a part of the time.
"""
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SAMPLERS = {0x8B5D, 0x8B5E, 0x8B5F, 0x8B60, 0x8B61, 0x8B62, 0x8DC1, 0x8DC2, 0x8DC4, 0x8B63, 0x8DCA, 0x8DD2, 0x8DC5}
COMPONENTS = {0x1406: 1, 0x1404: 1, 0x1405: 1, 0x8B56: 1, 0x8B50: 2, 0x8B51: 3, 0x8B52: 4, 0x8B53: 2, 0x8B54: 3, 0x8B55: 4,
              0x8B5A: 4, 0x8B5B: 9, 0x8B5C: 16, 0x8B65: 6}
MOST_SAMPLERS, MOST_COMPONENTS = 16, 1024

# What a scene is drawn as: its own techniques, those that look up most, every debug view, and at rest.
DRAWN = [[], ["--technique", "impostor"], ["--technique", "raytraced"], ["--technique", "footprint8"], ["--technique", "auto"],
         ["--technique", "hdrp"], ["--view", "all"], ["--refine=32"]]


def captured_in(folder):
    """(vertex, fragment, geometry) of each program that Mesa wrote to this folder."""
    for file in folder.iterdir():
        parts = re.split(r"^\[(.*?)\]\n", file.read_text(errors="replace"), flags=re.M)
        shader = dict(zip(parts[1::2], parts[2::2]))
        if "fragment shader" in shader and "vertex shader" in shader:
            yield shader["vertex shader"], shader["fragment shader"], shader.get("geometry shader", "")


def captured(program, scene, folder, edits=()):
    """{hash: (vertex, fragment, how)} of all programs that this scene is drawn with, after the edits of --set."""
    found = {}
    for drawn in DRAWN:
        with tempfile.TemporaryDirectory() as into:
            environment = dict(os.environ, MESA_SHADER_CAPTURE_PATH=into, MESA_SHADER_CACHE_DISABLE="1", GALLIVM_PERF="nopt")
            command = [program, "render", str(scene), "-o", str(folder / "drawn.png"), "--size", "64x36", "--quiet", *drawn, *edits]
            done = subprocess.run(command, env=environment, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{scene.name} {' '.join(drawn)}: {done.stderr.strip().splitlines()[-1:]}")
            for pair in captured_in(Path(into)):
                name = hashlib.sha256("\0".join(pair).encode()).hexdigest()[:12]
                found.setdefault(name, (*pair, " ".join([scene.stem.split(".")[0], *drawn])))
    return found


def checked(pair, folder, options, check=None):
    """(what the compiler said or "", its output)"""
    for old in folder.glob("*.spv"):
        old.unlink()
    files = []
    for text, stage in zip(pair, ("vert", "frag", "geom")):
        if text:
            (folder / f"program.{stage}").write_text(text)
            files.append(f"program.{stage}")
    done = subprocess.run(["glslangValidator", *options, *files], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        said = [line for line in done.stdout.splitlines() if "ERROR" in line]
        return (said or ["refused"])[0], done.stdout
    for file in folder.glob("*.spv") if check else []:
        valid = subprocess.run([check, file.name], cwd=folder, capture_output=True, text=True)
        if valid.returncode != 0:
            return valid.stderr.strip().splitlines()[0], ""
    return "", done.stdout


def for_spirv(pair):
    """The same for a version that has SPIR-V: outputs of 1.50 have no such type there, and VTK names its lookups anew for 1.50 alone."""
    vertex, fragment, geometry = pair
    outputs = "\n#define texture2D texture\n#define texelFetchBuffer texelFetch"
    if "gl_FragData" in fragment:
        outputs += "\nlayout(location = 0) out vec4 bpFragData[8];"
    fragment = re.sub(r"\bgl_FragData\b", "bpFragData", fragment)
    return (vertex.replace("#version 150", "#version 330 core", 1), fragment.replace("#version 150", "#version 330 core" + outputs, 1),
            geometry.replace("#version 150", "#version 330 core", 1))


def counts(reflection):
    """(samplers, components) of the fragment shader (bit 16 of `stages`); what stands in a block is none of its components."""
    samplers = components = 0
    for kind, size, block, stages in re.findall(r"type ([0-9a-f]+), size (\d+), index (-?\d+), .*?stages (\d+)", reflection):
        if not int(stages) & 16 or block != "-1":
            continue
        if int(kind, 16) in SAMPLERS:
            samplers += int(size)
        components += COMPONENTS.get(int(kind, 16), 0) * int(size)
    return samplers, components


def main():
    for needed, package in (("glslangValidator", "glslang-tools"), ("spirv-val", "spirv-tools")):
        if shutil.which(needed) is None:
            print(f"left out: package {package} is not installed")
            return 77
    program, scenes, folder, *more = sys.argv[1:]
    scenes, folder = Path(scenes), Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    first = more.index("--set") if "--set" in more else len(more)
    edits = more[first:]
    names = [Path(name) for name in more[:first]] or sorted(scenes.glob("*.boxprobe.json"))
    failed, seen = 0, {}
    print(f"{'scene':20} programs  samplers  components")
    for scene in names:
        found = captured(program, scene, folder, edits)
        most = [0, 0]
        for name, (*pair, how) in found.items():
            if name not in seen:
                said, reflection = checked(pair, folder, ["-l", "-q"])
                spirv, _ = checked(for_spirv(pair), folder, ["-G", "--aml", "--amb", "-l"], "spirv-val")
                seen[name] = counts(reflection)
                for what in filter(None, (said, spirv)):
                    failed += 1
                    print(f"  {how}: {what}")
            most = [max(a, b) for a, b in zip(most, seen[name])]
        print(f"{scene.stem.split('.')[0]:20} {len(found):8}  {most[0]:8}  {most[1]:10}", flush=True)
        if most[0] > MOST_SAMPLERS or most[1] > MOST_COMPONENTS:
            failed += 1
            print(f"  more than {MOST_SAMPLERS} samplers or {MOST_COMPONENTS} components")
    print(f"{len(seen)} programs, {failed} refused or too large")
    return 1 if failed or not seen else 0


if __name__ == "__main__":
    sys.exit(main())
