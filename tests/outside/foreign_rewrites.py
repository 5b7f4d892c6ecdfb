#!/usr/bin/env python3
"""Other people's compressed, instanced and variant models against the same written without the extension by glTF-Transform.

usage: foreign_rewrites.py BOXPROBE --from DIR --modules DIR -o OUT [--size WxH]

--from holds checked-out clones as for foreign_models.py, --modules a node_modules with what foreign_rewrite.mjs names.
Each pair is rendered as an object and compared pixel by pixel; prints the largest and the mean difference of 255 steps.
"""
import argparse
import shutil
import subprocess
import sys
from pathlib import Path

from foreign_pictures import pixels

PAIRS = [
    ("KHR_draco_mesh_compression", "javagl+glTF-Sample-Models/2.0/BrainStem/glTF-Draco/BrainStem.gltf", ""),
    ("KHR_draco_mesh_compression", "javagl+glTF-Sample-Models/2.0/GearboxAssy/glTF-Draco/GearboxAssy.gltf", ""),
    ("KHR_draco_mesh_compression", "donmccurdy+glTF-Transform/packages/extensions/test/in/BoxDraco.gltf", ""),
    ("KHR_draco_mesh_compression", "playcanvas+engine/examples/assets/models/heart_draco.glb", ""),
    ("EXT_meshopt_compression", "zeux+meshoptimizer/demo/pirate.glb", ""),
    ("EXT_meshopt_compression", "gkjohnson+3d-demo-data/models/stanford-bunny/bunny.glb", ""),
    ("EXT_meshopt_compression", "gkjohnson+3d-demo-data/models/nasa-m2020/Ingenuity.glb", ""),
    ("EXT_texture_webp", "playcanvas+engine/examples/assets/models/cat.glb", ""),
    ("EXT_mesh_gpu_instancing", "DRx3D+glTF-Sample-Assets-OLD/Models/SimpleInstancing/glTF-Binary/SimpleInstancing.glb", ""),
    ("KHR_materials_variants", "DRx3D+glTF-Sample-Assets-OLD/Models/MaterialsVariantsShoe/glTF/MaterialsVariantsShoe.gltf", "beach"),
    ("KHR_materials_variants", "DRx3D+glTF-Sample-Assets-OLD/Models/SheenChair/glTF/SheenChair.gltf", "Peacock Velvet"),
]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--from", dest="clones", type=Path, required=True)
    parser.add_argument("--modules", type=Path, required=True)
    parser.add_argument("-o", dest="out", type=Path, required=True)
    parser.add_argument("--size", default="480x270")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    script = options.modules.parent / "foreign_rewrite.mjs"  # beside its node_modules, where imports are looked for
    shutil.copy(Path(__file__).parent / "foreign_rewrite.mjs", script)
    worst = 0.0
    for number, (extension, file, variant) in enumerate(PAIRS):
        path = options.clones / file
        if not path.exists():
            print("%s is not in %s" % (file, options.clones))
            continue
        plain = options.out / ("%d.glb" % number)
        subprocess.run(["node", str(script), str(path), str(plain), extension, variant], check=True)
        pictures = []
        for model, chosen in ((path, variant), (plain, "")):
            picture = options.out / ("%d-%s.png" % (number, "plain" if model == plain else "given"))
            command = [options.program, "render", str(model), "-o", str(picture), "--size", options.size]
            subprocess.run(command + (["--variant", chosen] if chosen else []), check=True, capture_output=True)
            pictures.append(pixels(picture))
        differences = [abs(a - b) for a, b in zip(*pictures)]
        mean = sum(differences) / len(differences)
        worst = max(worst, mean)
        print("%-28s %-28s largest %3d, mean %.4f, bytes beyond 2: %d of %d"
              % (extension, path.stem, max(differences), mean, sum(d > 2 for d in differences), len(differences)), flush=True)
    return 0 if worst < 0.1 else 1


if __name__ == "__main__":
    sys.exit(main())
