"""Boxprobe's probes in Unreal Engine 5, as box reflection captures. Written from its documentation, not run.

Exported with: boxprobe export SCENE -o DIR --format hdr --ladder own
In the editor's Python console: import boxprobe_unreal; boxprobe_unreal.load("DIR")
"""
import json
from pathlib import Path

import unreal

CENTIMETRES = 100.0


def vector(v):
    """From metres, right-handed, +Y up to centimetres, left-handed, +Z up, as the glTF importer does."""
    return unreal.Vector(v[0] * CENTIMETRES, v[2] * CENTIMETRES, v[1] * CENTIMETRES)


def load(folder, game_path="/Game/Probes"):
    """Imports every picture in `folder` and places a capture for it."""
    for path in sorted(Path(folder).glob("*.json")):
        probe = json.loads(path.read_text())
        if probe.get("format") == "boxprobe-export":
            place(probe, import_picture(path.parent / probe["file"], game_path))


def import_picture(file, game_path):
    task = unreal.AssetImportTask()
    task.filename, task.destination_path = str(file), game_path
    task.automated, task.save, task.replace_existing = True, True, True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    return unreal.load_asset(task.imported_object_paths[0])


def place(probe, cubemap):
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.BoxReflectionCapture, vector(probe["box"]["center"]))
    actor.set_actor_label(probe["name"])
    x, y, z, w = probe["rotationQuaternion"]
    # The exchange of Y and Z mirrors: the axis is exchanged, too, and the sense of rotation turns round.
    actor.set_actor_rotation(unreal.Quat(-x, -z, -y, w).rotator(), False)
    half = [0.5 * side for side in probe["box"]["size"]]
    actor.set_actor_scale3d(vector(half))  # a capture's scale is its half size
    capture = actor.get_component_by_class(unreal.BoxReflectionCaptureComponent)
    capture.set_editor_property("reflection_source_type", unreal.ReflectionSourceType.SPECIFIED_CUBEMAP)
    capture.set_editor_property("cubemap", cubemap)
    capture.set_editor_property("brightness", probe["intensity"])
    capture.set_editor_property("box_transition_distance", CENTIMETRES * max(probe["blendDistance"]["min"]))
    offset = [a - b for a, b in zip(probe["origin"], probe["box"]["center"])]
    capture.set_editor_property("capture_offset", vector(offset))
