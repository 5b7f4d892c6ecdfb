"""Box-projected reflection probes for the actors of a VTK renderer, beside VTK's own Python modules.

    probes = boxprobe.attach(renderer)                   # every physically shaded actor in it
    probes.add(bounds=(-2, 2, 0, 3, -2, 2))              # or probes.place(), probes.fit()
    window.Render()                                      # captures first

Probes and Probe are vtkReflectionProbes and vtkReflectionProbe with properties; both wrapped classes' methods are there,
too, and their help() explains each value. Lengths and positions are in the renderer's world frame. A wrong type is a
TypeError, a value that is refused or work that fails a RuntimeError of one line.
"""

from . import _version
from ._version import __version__

try:
    from vtkmodules.vtkCommonCore import vtkVersion
    from vtkmodules.vtkRenderingCore import vtkRenderer
    import vtkmodules.vtkRenderingOpenGL2  # draws what the others describe
except ImportError as missing:
    raise ImportError(f"boxprobe needs VTK's Python modules (Debian's package python3-vtk9): {missing}") from missing

_found = vtkVersion.GetVTKVersion()
if _found.split(".")[:2] != _version.vtk_version.split(".")[:2]:
    raise ImportError(f"boxprobe was built for VTK {_version.vtk_version}; this is VTK {_found}")

from .vtkBoxprobe import (vtkProjectionRays, vtkReflectionProbe, vtkReflectionProbeRepresentation, vtkReflectionProbes,
                          vtkReflectionProbeWidget)

try:
    from .vtkBoxprobe import vtkReflectionProbeFit
except ImportError:  # built without Embree
    vtkReflectionProbeFit = None

__all__ = ["ActorProbes", "Probe", "Probes", "attach", "vtkProjectionRays", "vtkReflectionProbe", "vtkReflectionProbeFit",
           "vtkReflectionProbeRepresentation", "vtkReflectionProbes", "vtkReflectionProbeWidget"]


def _value(name, doc):
    """A property on the methods SetName and GetName."""

    def get(self):
        return getattr(self, "Get" + name)()

    def put(self, value):
        if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
            getattr(self, "Set" + name)(*[float(v) for v in value])
        else:
            getattr(self, "Set" + name)(value)

    return property(get, put, doc=doc)


def _only_known(self, name, value):
    """A misspelt property is an error; names that begin with _ are the caller's own."""
    if not name.startswith("_") and not hasattr(type(self), name):
        raise AttributeError(f"{type(self).__name__} has no value {name}")
    object.__setattr__(self, name, value)


_ALL_BOUNCES = 16  # of SetBouncesToAll
_TONES = ("vtk", "none", "neutral", "agx", "aces")


class Probe(vtkReflectionProbe):
    """A place that is captured, and the box through which surfaces reflect it: Probe(bounds=(...), face_size=128)."""

    __setattr__ = _only_known

    def __new__(cls, **values):
        return super().__new__(cls)

    def __init__(self, **values):
        for name, value in values.items():
            if not isinstance(getattr(Probe, name, None), property):
                raise TypeError(f"Probe has no value {name}")
            setattr(self, name, value)

    name = _value("Name", "Named in messages.")
    enabled = _value("Enabled", "False: lights nothing and gives up its maps.")
    bounds = _value("Bounds", "The box: xmin, xmax, ymin, ymax, zmin, zmax.")
    origin = _value("Origin", "Where it is captured; the centre of the bounds until set.")
    orientation = _value("Orientation", "Degrees about world X, then Y, then Z, about the centre of the bounds.")
    blend_distances = _value("BlendDistances", "From each face inwards the weight rises over this: six values.")
    importance = _value("Importance", "Probes share what more important ones leave.")
    intensity = _value("Intensity", "Factor of its reflections.")
    technique = _value("Technique", '"box", "infinite", "sphere", ...')
    face_size = _value("FaceSize", "Texels, a power of two from 16 to 2048.")
    samples_per_pixel = _value("SamplesPerPixel", "1, 4 or 16.")
    near_distance = _value("NearDistance", "0: from the box.")
    far_distance = _value("FarDistance", "0: from what there is to see.")

    @property
    def bounces(self):
        """1 to 5, or "all": until another changes the light that they bring by less than 1 %."""
        return "all" if self.GetBounces() == _ALL_BOUNCES else self.GetBounces()

    @bounces.setter
    def bounces(self, count):
        if count == "all":
            self.SetBouncesToAll()
        else:
            self.SetBounces(count)

    @property
    def blend_distance(self):
        """The same at all faces; 0 by default: full weight up to them. Read: the largest."""
        return max(self.GetBlendDistances())

    @blend_distance.setter
    def blend_distance(self, distance):
        self.SetBlendDistance(distance)

    @property
    def influence_bounds(self):
        """The box within which it lights surfaces; None: the bounds."""
        return self.GetInfluenceBounds() if self.GetUseInfluenceBounds() else None

    @influence_bounds.setter
    def influence_bounds(self, bounds):
        self.SetUseInfluenceBounds(bounds is not None)
        if bounds is not None:
            self.SetInfluenceBounds(*[float(b) for b in bounds])


class Probes(vtkReflectionProbes):
    """The probes of one renderer. Deleted, it leaves no trace: keep it as long as they are to be seen."""

    __setattr__ = _only_known

    auto_update = _value("AutoUpdate", "Stale maps are captured at the next Render().")
    steps_per_render = _value("StepsPerRender", "Units of work for each Render(); 0: all.")
    exposure = _value("Exposure", "Factor on linear light before it is shown.")
    emission = _value("Emission", "Emissive factors show without a texture.")
    multiple_scattering = _value("MultipleScattering", "Adds light that meets more than one microfacet.")
    refine_at_rest = _value("RefineAtRest", "A view that rests is refined: by the interactor's timers, or RefineStep().")
    refine_rays = _value("RefineRays", "Per pixel, at the end.")
    refine_seconds = _value("RefineSeconds", "Longest time of it; 0: no limit.")
    refine_delay = _value("RefineDelay", "Seconds without a change before it begins.")

    @property
    def tone(self):
        """How light is shown: "vtk" (default, VTK's power of 1 / 2.2), or by sRGB's curve "none", "neutral", "agx", "aces"."""
        return _TONES[self.GetToneMapping()]

    @tone.setter
    def tone(self, name):
        if name not in _TONES:
            raise ValueError(f"tone: {name!r} is none of {', '.join(_TONES)}")
        self.SetToneMapping(_TONES.index(name))

    def __len__(self):
        return self.GetNumberOfProbes()

    def __bool__(self):
        return True

    def __getitem__(self, index):
        found = self.GetProbe(index + len(self) if index < 0 else index)
        if found is None:
            raise IndexError(f"there is no probe {index}; there are {len(self)}")
        return found

    def __iter__(self):
        return iter([self.GetProbe(i) for i in range(len(self))])

    def add(self, probe=None, **values):
        """Adds a probe, or makes one of these values; returns it."""
        if probe is None:
            probe = Probe(**values)
        elif values:
            raise TypeError("add: a probe or its values, not both")
        self.AddProbe(probe)
        return probe

    def remove(self, probe):
        self.RemoveProbe(probe)

    @property
    def stale(self):
        """Do maps show another state than the renderer's now?"""
        return self.GetStale()

    def update(self):
        """Captures what is stale."""
        self._done(self.Update())

    def capture(self):
        """Captures everything."""
        self._done(self.Capture())

    def load_maps(self, probe, file):
        """A file that `boxprobe bake` wrote, in place of captures."""
        self._done(self.LoadMaps(probe, str(file)))

    def fit(self, probe=None, up_axis=1, metres_per_unit=1.0):
        """Fits a probe's bounds to the walls; without one, those of all. Returns what was decided, as text."""
        fit = self._fitter(up_axis, metres_per_unit)
        report = ""
        for one in [probe] if probe is not None else list(self):
            fit.Fit(one)
            report += fit.GetReport()
        return report

    def place(self, most=64, up_axis=1, metres_per_unit=1.0):
        """Adds probes for all rooms; returns those that were added."""
        before = len(self)
        fit = self._fitter(up_axis, metres_per_unit)
        if fit.Place(most) < 0:
            raise RuntimeError("place: see the error before")
        return list(self)[before:]

    def _fitter(self, up_axis, metres_per_unit):
        if vtkReflectionProbeFit is None:
            raise RuntimeError("this build of boxprobe has no fitting: it was made without Embree")
        fit = vtkReflectionProbeFit()
        fit.SetProbes(self)
        fit.SetUpAxis(up_axis)
        fit.SetMetresPerUnit(metres_per_unit)
        return fit

    def _done(self, done):
        if not done:
            raise RuntimeError(self.GetLastError() or "not while probes are being captured")


def attach(renderer):
    """Probes for every physically shaded actor of a renderer."""
    if not isinstance(renderer, vtkRenderer):
        raise TypeError(f"renderer: must be a vtkRenderer, not {type(renderer).__name__}")
    probes = Probes()
    probes.SetRenderer(renderer)
    return probes


def __getattr__(name):
    if name == "ActorProbes":  # the name of before; needs a module of its own
        try:
            from .actor_probes import ActorProbes
        except ImportError as missing:
            raise AttributeError(f"boxprobe.ActorProbes was not built ({missing}); use boxprobe.attach()") from None
        return ActorProbes
    raise AttributeError(f"module boxprobe has no attribute {name}")
