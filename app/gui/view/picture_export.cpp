// See picture_export.h.
#include "app/gui/view/picture_export.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QString>
#include <algorithm>

#include "app/gui/view/viewport.h"
#include "app/gui/view/whole_view.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

namespace {

void exportLinear(const std::string& path, SceneRenderer& renderer, const int* size) {
  constexpr int kSamples = 4;
  // Several samples per pixel have as many rays in as many frames fewer.
  const RefineSettings refined = renderer.refineSettings();
  if (refined.rays > 0) return saveExr(path, renderer.renderRefined(size[0], size[1], kSamples, refined));
  const int frames = (renderer.frameCount().wanted + kSamples - 1) / kSamples;
  saveExr(path, renderer.renderLinear(size[0], size[1], kSamples, std::max(frames, 1)));
}

}  // namespace

void exportPicture(const std::string& path, SceneRenderer& renderer, Viewport& viewport,
                   vtkReflectionProbeRepresentation& handles) {
  viewport.window3d()->MakeCurrent();
  const WholeView whole(renderer);
  if (QString::fromStdString(path).endsWith(".exr", Qt::CaseInsensitive)) {
    return exportLinear(path, renderer, viewport.window3d()->GetSize());
  }
  // What is saved is what is on the screen once it is at rest.
  for (int left = renderer.frameCount().wanted; left > 0 && renderer.frameCount().more(); --left) {
    viewport.window3d()->Render();
  }
  const PreviewSphereSettings sphere = renderer.previewSphere();
  renderer.showPreviewSphere({});
  const int shown = handles.GetVisibility();
  handles.VisibilityOff();
  const ImageRgba8 image = renderer.renderDisplay();
  handles.SetVisibility(shown);
  renderer.showPreviewSphere(sphere);
  savePng(path, image);
}

}  // namespace boxprobe
