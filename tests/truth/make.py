# Renders the truth pictures by plan.json; pictures that are there are left alone. Called by make.sh inside Blender.
# Arguments after `--`: names of scenes; none: all of them.
import json
import os
import sys

import bpy
import numpy

sys.dont_write_bytecode = True  # nothing but pictures is left here
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import truth_scene  # noqa: E402

PICTURES = os.path.join(HERE, "pictures")
INDEX = os.path.join(HERE, "truth.json")


def noise_of(a, b):
    """Of the mean of two independent pictures: the root mean square of its error over that of its light, where the floor
    covers the pixel."""
    full = a[..., 3] > 0.9999
    mean = 0.5 * (a + b)[full][:, :3]
    half = 0.5 * (a - b)[full][:, :3]
    return float(numpy.sqrt((half**2).sum() / max((mean**2).sum(), 1e-12)))


def two_seeds(samples, seeds):
    path = os.path.join(PICTURES, "part.exr")
    return [truth_scene.render(samples, seed, path) for seed in seeds]


def render_pair(plan, samples):
    """Two pictures of independent noise, with more samples than that where it takes them; returns them and how many."""
    pair = two_seeds(samples, plan["seeds"])
    while noise_of(*pair) > plan["noise"] and samples < plan["mostSamples"]:
        # The error of well spread samples falls faster than their root.
        wanted = samples * min(4.0, max(1.25, 1.05 * (noise_of(*pair) / plan["noise"]) ** 1.3))
        samples = int(min(plan["mostSamples"], 64 * -(-wanted // 64)))
        pair = two_seeds(samples, plan["seeds"])
    return pair, samples


def load_index():
    if not os.path.exists(INDEX):
        return {}
    with open(INDEX) as file:
        return {(row["picture"], row["kind"]): row for row in json.load(file)["pictures"]}


def save_index(plan, rows):
    index = {
        "format": "boxprobe-truth",
        "version": 1,
        "renderer": "Cycles of Blender " + bpy.app.version_string,
        "width": plan["width"],
        "height": plan["height"],
        "seeds": plan["seeds"],
        "boxScenes": plan["boxScenes"],
    }
    text = json.dumps(index, indent=2)[:-2] + ',\n  "pictures": [\n'
    text += ",\n".join("    " + json.dumps(rows[name]) for name in sorted(rows)) + "\n  ]\n}\n"
    with open(INDEX + ".part", "w") as file:
        file.write(text)
    os.replace(INDEX + ".part", INDEX)


class SceneMaker:
    """The pictures of one scene."""

    def __init__(self, name, plan, rows):
        self.name, self.plan, self.rows = name, plan, rows
        scene_file = os.path.join(HERE, "scenes", name + ".boxprobe.json")
        self.floor, self.cameras = truth_scene.load_scene(scene_file, plan["width"], plan["height"])

    def picture(self, camera, kind, roughness):
        return f"{self.name}-{camera}-{kind}-{round(100 * roughness):03d}.exr"

    def wanted(self, picture):
        return not any(made == picture for made, _ in self.rows) or not os.path.exists(os.path.join(PICTURES, picture))

    def note(self, picture, camera, kind, roughness, samples, noise, **more):
        material = dict(self.plan["kinds"][kind])
        material["coatRoughness" if material.get("coat", 0) > 0 else "roughness"] = roughness
        row = {"scene": self.name, "camera": camera, "kind": kind, "roughness": roughness, **more}
        row = {"picture": picture, **row, "material": material, "samples": samples, "noise": noise}
        self.rows[(picture, kind)] = row

    def keep(self, picture, pair, samples, camera, kind, roughness, **more):
        truth_scene.write_half(0.5 * (pair[0] + pair[1]), os.path.join(PICTURES, picture))
        noise = round(noise_of(*pair), 6)
        self.note(picture, camera, kind, roughness, samples, noise, **more)
        if kind == "dielectric" and not more:
            # A coat over what reflects nothing is the interface of a dielectric: one picture judges both.
            self.note(picture, camera, "coat", roughness, samples, noise)
        save_index(self.plan, self.rows)
        print(f"{picture}: {samples} samples, noise {noise:.4f}", flush=True)

    def make_whole(self):
        """Walls and sky as the camera sees them: that both renderers have the same picture, the right way round."""
        whole, picture = self.plan["whole"], self.name + "-whole.exr"
        if not self.wanted(picture):
            return
        truth_scene.set_camera(self.cameras[whole["camera"]])
        truth_scene.make_floor(self.floor, self.plan["kinds"][whole["kind"]], whole["roughness"])
        truth_scene.show_floor_alone(False)
        pair = two_seeds(whole["samples"], self.plan["seeds"])
        self.keep(picture, pair, whole["samples"], whole["camera"], whole["kind"], whole["roughness"], whole=True)

    def make_kind(self, camera, kind):
        for roughness, samples in zip(self.plan["roughness"], self.plan["samples"]):
            picture = self.picture(camera, kind, roughness)
            if not self.wanted(picture):
                continue
            truth_scene.make_floor(self.floor, self.plan["kinds"][kind], roughness)
            pair, samples = render_pair(self.plan, samples)
            self.keep(picture, pair, samples, camera, kind, roughness)

    def make(self):
        self.make_whole()
        truth_scene.show_floor_alone(True)
        for kind in (self.plan["scenes"][self.name], "dielectric"):
            for camera, placed in self.cameras.items():
                truth_scene.set_camera(placed)
                self.make_kind(camera, kind)


def main():
    if bpy.app.version < (4, 1, 0):
        sys.exit(f"make.py: Blender {bpy.app.version_string} masks GGX separably; take 4.1 or later")
    with open(os.path.join(HERE, "plan.json")) as file:
        plan = json.load(file)
    names = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    for name in names:
        if name not in plan["scenes"]:
            sys.exit(f"make.py: no scene {name} in plan.json; it has " + ", ".join(plan["scenes"]))
    os.makedirs(PICTURES, exist_ok=True)
    rows = load_index()
    for name in names or plan["scenes"]:
        SceneMaker(name, plan, rows).make()
    save_index(plan, rows)


main()
