// A glTF file in a plain VTK program, and a box-projected probe for its actors: probe_in_renderer FILE.glb OUT.png
#include <vtkCamera.h>
#include <vtkGLTFImporter.h>
#include <vtkLight.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"

int main(int, char** argv) {
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(argv[1]);
  importer->SetRenderWindow(window);
  importer->Update();
  renderer->GetActiveCamera()->SetPosition(0.9, 0.5, 1.8);  // looks at 0 0 0
  vtkNew<vtkLight> dark;  // the walls shine; but without any light VTK shades nothing physically
  dark->SetIntensity(0.0);
  renderer->AddLight(dark);
  vtkNew<vtkReflectionProbe> probe;  // captured at 0 0 0, in the middle of the ball, which must not be seen from there
  probe->SetBounds(-2, 2, -2, 2, -2, 2);
  vtkNew<vtkReflectionProbes> probes;
  probes->SetRenderer(renderer);
  probes->AddProbe(probe);
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* a = actors->GetNextActor()) probes->SetSeenByProbes(a, a->GetProperty()->GetTexture("albedoTex"));
  window->Render();  // captures first
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return *probes->GetLastError() == '\0' ? 0 : 1;
}
