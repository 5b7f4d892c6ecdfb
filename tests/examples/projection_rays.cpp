// A plain VTK program: the box-projection rays of a mirror floor, saved as lines for ParaView.
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkXMLPolyDataWriter.h>

#include "filters/vtk/rays/vtkProjectionRays.h"

int main(int argc, char** argv) {
  vtkNew<vtkPlaneSource> floor;  // points with normals (up): 9 x 9 of a floor, 4 m a side
  floor->SetOrigin(-2, 0, 2);
  floor->SetPoint1(2, 0, 2);
  floor->SetPoint2(-2, 0, -2);
  floor->SetResolution(8, 8);

  vtkNew<vtkProjectionRays> rays;
  rays->SetInputConnection(floor->GetOutputPort());
  rays->SetEye(0, 1.6, 2.4);
  const int room = rays->AddProbe();  // a room of 6 x 3 x 5 m, captured in its middle
  rays->SetProbeName(room, "room");
  rays->SetProbeOrigin(room, 0, 1.5, 0);
  rays->SetProbeBounds(room, -3, 3, 0, 3, -2.5, 2.5);
  rays->SetProbeBlendDistance(room, 0);  // full weight up to the walls, and so on the floor
  rays->SetProbeTechnique(room, "box");

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(rays->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "rays.vtp");
  return writer->Write() == 1 ? 0 : 1;
}
