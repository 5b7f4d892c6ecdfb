// A plain VTK program: a probe's box dragged with the mouse, and a mirror floor that follows. With a file name it saves
// a picture instead.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"
#include "filters/vtk/widgets/vtkReflectionProbeWidget.h"

static void addPlane(vtkRenderer* renderer, double y, double z, double red, bool mirror) {
  vtkNew<vtkPlaneSource> source;  // from the edge at the floor's far side to (0, y, z) from there
  source->SetOrigin(-3, 0, -2.5);
  source->SetPoint1(3, 0, -2.5);
  source->SetPoint2(-3, y, -2.5 + z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetColor(red, 0.7, 0.3);
  actor->GetProperty()->SetMetallic(mirror ? 1.0 : 0.0);
  actor->GetProperty()->SetRoughness(mirror ? 0.05 : 0.8);
  renderer->AddActor(actor);
}

int main(int argc, char** argv) {
  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 360);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  addPlane(renderer, 0, 5, 0.9, true);
  addPlane(renderer, 3, 0, 0.8, false);
  renderer->GetActiveCamera()->SetPosition(1.5, 2.2, 8.5);
  renderer->GetActiveCamera()->SetFocalPoint(0, 1.0, 0);

  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-2, 2.5, 0, 2.5, -2, 2);
  probe->SetOrigin(0.2, 1.4, 0.1);  // stays while faces are dragged, so nothing is captured again
  vtkNew<vtkReflectionProbes> probes;
  probes->SetRenderer(renderer);
  probes->AddProbe(probe);

  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;  // beside the handles
  interactor->SetInteractorStyle(style);
  vtkNew<vtkReflectionProbeWidget> widget;
  widget->SetInteractor(interactor);
  widget->SetProbe(probe);
  widget->GetReflectionProbeRepresentation()->SetLengthUnit("m");
  widget->On();
  window->Render();

  if (argc > 1) {
    vtkNew<vtkWindowToImageFilter> pixels;
    pixels->SetInput(window);
    pixels->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(pixels->GetOutputPort());
    writer->SetFileName(argv[1]);
    writer->Write();
  } else {
    interactor->Start();
  }
  return *probes->GetLastError() == '\0' ? 0 : 1;
}
