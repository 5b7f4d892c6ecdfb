from os import PathLike
from typing import Any, Iterator, Optional, Sequence

from vtkmodules.vtkRenderingCore import vtkRenderer

from .vtkBoxprobe import vtkProjectionRays as vtkProjectionRays
from .vtkBoxprobe import vtkReflectionProbe as vtkReflectionProbe
from .vtkBoxprobe import vtkReflectionProbeFit as vtkReflectionProbeFit
from .vtkBoxprobe import vtkReflectionProbeRepresentation as vtkReflectionProbeRepresentation
from .vtkBoxprobe import vtkReflectionProbes as vtkReflectionProbes
from .vtkBoxprobe import vtkReflectionProbeWidget as vtkReflectionProbeWidget

__version__: str

class Probe(vtkReflectionProbe):
    def __init__(self, **values: Any) -> None: ...
    name: str
    enabled: bool
    bounds: Sequence[float]
    origin: Sequence[float]
    orientation: Sequence[float]
    influence_bounds: Optional[Sequence[float]]
    blend_distance: float
    blend_distances: Sequence[float]
    importance: float
    intensity: float
    technique: str
    face_size: int
    bounces: int
    samples_per_pixel: int
    near_distance: float
    far_distance: float

class Probes(vtkReflectionProbes):
    auto_update: bool
    steps_per_render: int
    exposure: float
    tone: str
    emission: bool
    multiple_scattering: bool
    refine_at_rest: bool
    refine_rays: int
    refine_seconds: float
    refine_delay: float
    @property
    def stale(self) -> bool: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> Any: ...
    def __iter__(self) -> Iterator[Any]: ...
    def add(self, probe: Optional[vtkReflectionProbe] = None, **values: Any) -> vtkReflectionProbe: ...
    def remove(self, probe: vtkReflectionProbe) -> None: ...
    def update(self) -> None: ...
    def capture(self) -> None: ...
    def load_maps(self, probe: vtkReflectionProbe, file: str | PathLike[str]) -> None: ...
    def fit(self, probe: Optional[vtkReflectionProbe] = None, up_axis: int = 1, metres_per_unit: float = 1.0) -> str: ...
    def place(self, most: int = 64, up_axis: int = 1, metres_per_unit: float = 1.0) -> list[vtkReflectionProbe]: ...

def attach(renderer: vtkRenderer) -> Probes: ...
