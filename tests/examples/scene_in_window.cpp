// A plain VTK program: a scene file drawn with its probes in a render window, and the picture saved.
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>

#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/scene_renderer.h"

int main(int argc, char** argv) {
  const boxprobe::Scene scene = boxprobe::loadSceneFile(argc > 1 ? argv[1] : "data/scenes/room.boxprobe.json");
  std::vector<std::shared_ptr<const boxprobe::Model>> models;
  for (const auto& entry : scene.models) {
    models.push_back(std::make_shared<boxprobe::Model>(boxprobe::loadModelFile(entry.file)));
  }
  vtkNew<vtkRenderWindow> window;  // a window of your own: Qt's, or any other of OpenGL
  window->SetSize(640, 360);
  window->SetMultiSamples(0);
  auto* openGl = vtkOpenGLRenderWindow::SafeDownCast(window);
  openGl->Initialize();
  boxprobe::SceneRenderer renderer(openGl);
  renderer.setModels(models);
  renderer.sync(scene, boxprobe::Changes::all());
  renderer.applyCamera(scene.cameras.front());
  renderer.finishWork();  // captures and filters the probes
  boxprobe::savePng(argc > 2 ? argv[2] : "scene.png", renderer.renderDisplay());
  return renderer.error().empty() ? 0 : 1;
}
