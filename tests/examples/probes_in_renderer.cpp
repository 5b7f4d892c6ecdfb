// A plain VTK program: a mirror floor between coloured walls, with a box-projected probe, and the picture saved.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"

static void addPlane(vtkRenderer* renderer, const double at[9], double red, double green, double blue, bool mirror) {
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(at[0], at[1], at[2]);
  source->SetPoint1(at[3], at[4], at[5]);
  source->SetPoint2(at[6], at[7], at[8]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetMetallic(mirror ? 1.0 : 0.0);
  actor->GetProperty()->SetRoughness(mirror ? 0.05 : 0.8);
  renderer->AddActor(actor);
}

int main(int argc, char** argv) {
  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 360);
  window->SetMultiSamples(0);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  const double floor[9] = {-3, 0, 2.5, 3, 0, 2.5, -3, 0, -2.5}, back[9] = {-3, 0, -2.5, 3, 0, -2.5, -3, 3, -2.5},
               left[9] = {-3, 0, 2.5, -3, 0, -2.5, -3, 3, 2.5}, right[9] = {3, 0, -2.5, 3, 0, 2.5, 3, 3, -2.5};
  addPlane(renderer, floor, 0.9, 0.9, 0.9, true);
  addPlane(renderer, back, 0.9, 0.8, 0.3, false);
  addPlane(renderer, left, 0.8, 0.2, 0.2, false);
  addPlane(renderer, right, 0.2, 0.5, 0.8, false);
  renderer->GetActiveCamera()->SetPosition(0, 1.6, 6.5);
  renderer->GetActiveCamera()->SetFocalPoint(0, 1.0, 0);
  vtkNew<vtkLight> lamp;
  lamp->PositionalOn();
  lamp->SetPosition(0, 2.5, 1);
  lamp->SetConeAngle(180);
  renderer->AddLight(lamp);

  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-3, 3, 0, 3, -2.5, 2.5);  // the walls; captured in their middle
  vtkNew<vtkReflectionProbes> probes;
  probes->SetRenderer(renderer);
  probes->AddProbe(probe);
  window->Render();  // captures first

  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  pixels->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "probes.png");
  writer->Write();
  return *probes->GetLastError() == '\0' ? 0 : 1;
}
