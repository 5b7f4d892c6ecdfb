"""The object of before; new programs use boxprobe.attach().

    probes = boxprobe.ActorProbes(renderer)
    probes.add_probe("room", box={"min": (-2, 0, -2), "max": (2, 3, 2)}, origin=(0, 1.5, 0))
    probes.add_actor(actor)       # its property set to physically based shading
    probes.capture()              # once the scene stands
    window.Render()               # the window's own, as ever

Fields of a probe and of the sky have the names, units and ranges that scene files have: faceSize, technique,
blendDistance. Lengths and positions are in the renderer's world frame. A wrong type is a TypeError, a wrong value a
ValueError, a failure of the work itself a RuntimeError: one line each.
"""

import json
import math
import os
import warnings

try:
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
    import vtkmodules.vtkRenderingOpenGL2  # draws what the first one describes
except ImportError as missing:
    raise ImportError(f"boxprobe needs VTK's Python modules (Debian's package python3-vtk9): {missing}") from missing

from . import _actor_probes

__all__ = ["ActorProbes"]


def _plain(value):
    """Arrays and numbers of NumPy's as Python's own."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a {type(value).__name__} is no value of a field")


def _fields(fields):
    for key, value in fields.items():
        try:
            json.dumps(value, allow_nan=False, default=_plain).encode()
        except (TypeError, ValueError, RecursionError) as wrong:
            kind = ValueError if isinstance(wrong, ValueError) else TypeError
            raise kind(f"{key}: {wrong}") from None
    return json.dumps(fields, default=_plain)


def _checked(what, value, kind):
    if not isinstance(value, kind):
        raise TypeError(f"{what}: must be a {kind.__name__}, not {type(value).__name__}")
    if kind is str:
        try:
            value.encode()
        except UnicodeEncodeError:
            raise ValueError(f"{what}: is no text that could be written") from None
    return value


class ActorProbes:
    """Lights actors of `renderer` by reflection probes; their mappers, properties, lights, camera and window stay what
    they are. Deleted, or told to let an actor go, it leaves no trace. The renderer belongs to a window by the time it is
    first drawn."""

    def __init__(self, renderer):
        self._probes = _actor_probes.Probes(_checked("renderer", renderer, vtkRenderer))

    def add_probe(self, name, **fields):
        """Adds a probe: box, origin, technique, faceSize ... Nothing has changed where this raises."""
        self._probes.add_probe(_checked("name", name, str), _fields(fields))

    def set_probe(self, name, **fields):
        """Changes the fields named, for instance technique="sphere". Its maps are kept, and looked up from where they
        were captured: a box may be dragged without capturing again. None takes an optional field away."""
        self._probes.set_probe(_checked("name", name, str), _fields(fields))

    def probe(self, name):
        """Every field of a probe, as a dictionary."""
        return json.loads(self._probes.probe(_checked("name", name, str)))

    def probes(self):
        """The names of all, in the order in which they were added."""
        return self._probes.names()

    def add_actor(self, actor, seen_by_probes=True):
        """Lights an actor by the probes whose influence it meets, at most four, from the next frame on. Captures show
        it, too, unless seen_by_probes is False."""
        self._probes.add_actor(_checked("actor", actor, vtkActor), bool(seen_by_probes))

    def remove_actor(self, actor):
        """VTK's own shading again."""
        self._probes.remove_actor(_checked("actor", actor, vtkActor))

    def remove_all_actors(self):
        self._probes.remove_all_actors()

    def set_sky(self, **fields):
        """What is reflected where no probe says otherwise: image="sky.hdr", color=(1, 1, 1), or top, horizon and ground.
        Unless set, the renderer's environment texture while image-based lighting is on, else nothing."""
        self._probes.set_sky(_fields(fields))

    def set_exposure(self, exposure):
        """Factor on the linear light of actors with probes before it is shown; 1 unless set, which is VTK's."""
        try:
            exposure = float(exposure)
        except (TypeError, ValueError):
            raise TypeError(f"exposure: must be a number, not {type(exposure).__name__}") from None
        if not math.isfinite(exposure):
            raise ValueError(f"exposure: is {exposure}; use a finite number")
        self._probes.set_exposure(exposure)

    def set_energy(self, energy):
        """Light that meets more than one microfacet: "multiple" adds it; "single" unless set."""
        self._probes.set_energy(_checked("energy", energy, str))

    def set_emission(self, shown):
        """VTK up to 9.1 leaves out emissive factors without a texture. True shows them: for actors whose factors are
        meant, such as vtkGLTFImporter's."""
        self._probes.set_emission(bool(shown))

    def capture(self):
        """Captures and filters all probes from the actors that were added, lit by the renderer's lights as they stand.
        Draws off the screen. Raises ValueError while the renderer has no window, RuntimeError where it fails; warns of
        a probe that lights nothing."""
        if not self._probes.capture():
            raise RuntimeError(self._probes.error())
        for remark in self._probes.remarks():  # such as a probe that lights nothing
            warnings.warn(remark, RuntimeWarning, stacklevel=2)

    def set_maps(self, name, file):
        """A baked file (`boxprobe bake`) in place of a capture."""
        try:
            path = os.fspath(file)
        except TypeError:
            raise TypeError(f"file: must be a path, not {type(file).__name__}") from None
        self._probes.set_maps(_checked("name", name, str), _checked("file", path, str))

    def error(self):
        """Empty while all is well; else the first failure of a frame or a capture, one line. An actor that it names is
        drawn without reflections."""
        return self._probes.error()

    def clear_error(self):
        self._probes.clear_error()

    def release_graphics(self):
        """Frees what the graphics side holds, with the window still there. Captures start over afterwards."""
        self._probes.release_graphics()
