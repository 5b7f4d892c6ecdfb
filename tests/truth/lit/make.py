# Renders the lit pictures by plan.json; pictures that are there are left alone. Called by ../make.sh inside Blender.
# Arguments after `--`: names of scenes; none: all of them.
import json
import os
import sys
import time

import bpy
import numpy

sys.dont_write_bytecode = True  # nothing but pictures is left here
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import lit_scene  # noqa: E402
import truth_scene  # noqa: E402

PICTURES = os.path.join(HERE, "pictures")
INDEX = os.path.join(HERE, "lit.json")


def blocks(picture, size):
    """Means over blocks of size x size pixels."""
    height, width = picture.shape[:2]
    return picture[..., :3].reshape(height // size, size, width // size, size, 3).mean(axis=(1, 3))


def noise_of(a, b, size):
    """Of the mean of two independent pictures, over blocks: the root mean square of its error over that of its light."""
    mean, half = blocks(0.5 * (a + b), size), blocks(0.5 * (a - b), size)
    return float(numpy.sqrt((half**2).sum() / max((mean**2).sum(), 1e-12)))


def render_pair(plan):
    """Two pictures of independent noise, with as many samples as the noise that is allowed takes."""
    path = os.path.join(PICTURES, "part.exr")
    samples = plan["samples"]
    while True:
        pair = [truth_scene.render(samples, seed, path) for seed in plan["seeds"]]
        noise = noise_of(*pair, plan["block"])
        if noise <= plan["noise"] or samples >= plan["mostSamples"]:
            return 0.5 * (pair[0] + pair[1]), samples, noise
        # The error of well spread samples falls faster than their root.
        wanted = samples * min(6.0, max(1.25, 1.05 * (noise / plan["noise"]) ** 1.6))
        samples = int(min(plan["mostSamples"], 64 * -(-wanted // 64)))


def check_bounces(plan):
    """With N bounces light is scattered N + 1 times at most, whatever found its source: a closed box says so."""
    albedo = 0.7
    for bounces in plan["bounces"]:
        lit_scene.furnace(bounces, albedo)
        seen = truth_scene.render(512, plan["seeds"][0], os.path.join(PICTURES, "part.exr"))[..., :3].mean()
        times = 1e9 if bounces == "all" else bounces + 2
        expected = (1.0 - albedo**times) / (1.0 - albedo)
        if abs(seen / expected - 1.0) > 0.003:
            sys.exit(f"make.py: with {bounces} bounces a closed box shows {seen:.4f} and not {expected:.4f}")


def load_index():
    if not os.path.exists(INDEX):
        return {}
    with open(INDEX) as file:
        return {row["picture"]: row for row in json.load(file)["pictures"]}


def save_index(plan, rows):
    index = {
        "format": "boxprobe-lit-truth",
        "version": 1,
        "renderer": "Cycles of Blender " + bpy.app.version_string,
        "width": plan["width"],
        "height": plan["height"],
        "block": plan["block"],
        "seeds": plan["seeds"],
    }
    text = json.dumps(index, indent=2)[:-2] + ',\n  "pictures": [\n'
    text += ",\n".join("    " + json.dumps(rows[name]) for name in sorted(rows)) + "\n  ]\n}\n"
    with open(INDEX + ".part", "w") as file:
        file.write(text)
    os.replace(INDEX + ".part", INDEX)


def make(name, plan, rows):
    path = os.path.join(HERE, "scenes", name + ".boxprobe.json")
    cameras = None
    with open(path) as file:
        names = list(json.load(file)["cameras"])
    for camera in names:
        for bounces in plan["bounces"]:
            picture = f"{name}-{camera}-{bounces}.exr"
            if picture in rows and os.path.exists(os.path.join(PICTURES, picture)):
                continue
            if cameras is None:
                cameras = lit_scene.load_scene(path, plan["width"], plan["height"], plan["portals"].get(name, []))
            truth_scene.set_camera(cameras[camera])
            lit_scene.set_bounces(bounces)
            start = time.process_time()
            mean, samples, noise = render_pair(plan)
            truth_scene.write_half(mean, os.path.join(PICTURES, picture), "RGB")
            rows[picture] = {"picture": picture, "scene": name, "camera": camera, "bounces": bounces, "samples": samples, "noise": round(noise, 6)}
            save_index(plan, rows)
            print(f"{picture}: {samples} samples, noise {noise:.4f}, light {mean[..., :3].mean():.4f}, {time.process_time() - start:.0f} s of CPU", flush=True)


def main():
    with open(os.path.join(HERE, "plan.json")) as file:
        plan = json.load(file)
    names = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    for name in names:
        if name not in plan["scenes"]:
            sys.exit(f"make.py: no scene {name} in plan.json; it has " + ", ".join(plan["scenes"]))
    os.makedirs(PICTURES, exist_ok=True)
    check_bounces(plan)
    rows = load_index()
    for name in names or plan["scenes"]:
        make(name, plan, rows)
    save_index(plan, rows)


main()
