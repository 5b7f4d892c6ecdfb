"""Two PNGs by VTK's own reader: compare_pictures.py A.png B.png [DIFFERING]

Prints how many pixels differ and by how much at most; fails if more than DIFFERING do (none, unless given), or if a picture is
of one colour."""
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def pixels(name):
    reader = vtkPNGReader()
    if not reader.CanReadFile(name):
        sys.exit(f"{name}: is no PNG")
    reader.SetFileName(name)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


a, b = pixels(sys.argv[1]), pixels(sys.argv[2])
allowed = int(sys.argv[3]) if len(sys.argv) > 3 else 0
if a.shape != b.shape:
    sys.exit(f"sizes differ: {a.shape} and {b.shape}")
if a.std() < 5.0:
    sys.exit(f"{sys.argv[1]}: shows next to nothing")
off = abs(a - b).max(axis=2)
count = int((off > 0).sum())
print(f"{count} of {off.size} pixels differ, by {off.max()}/255 at most")
sys.exit(f"more than {allowed} pixels differ" if count > allowed else 0)
