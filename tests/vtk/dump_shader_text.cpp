// Writes the text of the surface shader of the VTK that runs, as fixtures for tests/vtk/text: a folder, and the name
// that the files begin with.
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

#include <iostream>

#include "tests/vtk/shader_text.h"

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  const std::string name = argc > 2 ? argv[2] : vtkVersion::GetVTKVersion();
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
  for (const auto& [program, text] : boxprobe::test::runningText(window)) {
    const std::string file = folder + "/" + name + "-" + program + ".glsl";
    boxprobe::test::writeText(file, text);
    std::cout << file << "\n";
  }
  return 0;
}
