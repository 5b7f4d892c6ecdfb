"""A glTF file in a plain VTK program, and a box-projected probe for its actors: probe_in_renderer.py FILE.glb OUT.png"""
import sys

import boxprobe
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOImport import vtkGLTFImporter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2

window = vtkRenderWindow()
window.SetMultiSamples(0)
renderer = vtkRenderer()
window.AddRenderer(renderer)
importer = vtkGLTFImporter()
importer.SetFileName(sys.argv[1])
importer.SetRenderWindow(window)
importer.Update()
renderer.GetActiveCamera().SetPosition(0.9, 0.5, 1.8)  # looks at 0 0 0
dark = vtkLight()  # the walls shine; but without any light VTK shades nothing physically
dark.SetIntensity(0.0)
renderer.AddLight(dark)

probes = boxprobe.attach(renderer)
# Captured at 0 0 0, in the middle of the ball, which must not be seen from there.
probes.add(bounds=(-2, 2, -2, 2, -2, 2))
for actor in renderer.GetActors():
    probes.SetSeenByProbes(actor, actor.GetProperty().GetTexture("albedoTex") is not None)
window.Render()  # captures first

pixels = vtkWindowToImageFilter()
pixels.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(pixels.GetOutputPort())
writer.SetFileName(sys.argv[2])
writer.Write()
