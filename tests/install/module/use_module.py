"""Classes of the module beside VTK's own: use_module.py FOLDER, which holds the extension."""
import sys

import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkRenderingCore import vtkRenderer

sys.path.insert(0, sys.argv[1])
from vtkBoxprobeReflectionProbes import vtkReflectionProbe, vtkReflectionProbes, vtkReflectionProbeWidget

renderer, probes, probe = vtkRenderer(), vtkReflectionProbes(), vtkReflectionProbe()
probes.SetRenderer(renderer)
probe.SetBounds(-1, 2, 0, 3, -4, 5)
probes.AddProbe(probe)
assert probes.GetRenderer() is renderer and probes.GetProbe(0) is probe
assert probe.GetBounds() == (-1, 2, 0, 3, -4, 5)
assert vtkReflectionProbeWidget().IsA("vtkAbstractWidget")
print("the VTK module gives and takes vtkmodules' objects")
