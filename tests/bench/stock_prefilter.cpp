// See stock_prefilter.h.
#include "tests/bench/stock_prefilter.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

#include <algorithm>

#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe::bench {

StockPrefilter::StockPrefilter(vtkOpenGLRenderWindow* window, const CubeMap& input, int levels, int samples)
    : renderer_(vtkSmartPointer<vtkRenderer>::New()),
      prefilter_(vtkSmartPointer<vtkPBRPrefilterTexture>::New()),
      window_(window),
      faceSize_(input.faceSize()) {
  window->AddRenderer(renderer_);
  vtkNew<vtkOpenGLTexture> cube;
  cube->CubeMapOn();
  cube->InterpolateOn();
  cube->MipmapOn();
  cube->SetColorModeToDirectScalars();
  for (int face = 0; face < 6; ++face) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(faceSize_, faceSize_, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* to = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < faceSize_ * faceSize_; ++i) std::copy_n(input.face(0, face) + 4 * i, 3, to + 3 * i);
    cube->SetInputDataObject(face, image);
  }
  cube->Render(renderer_);
  prefilter_->SetInputTexture(cube);
  prefilter_->SetPrefilterLevels(static_cast<unsigned int>(levels));
  prefilter_->SetPrefilterMaxSamples(static_cast<unsigned int>(samples));
}

StockPrefilter::~StockPrefilter() {
  prefilter_->ReleaseGraphicsResources(window_);
  window_->RemoveRenderer(renderer_);
}

double StockPrefilter::filter() {
  prefilter_->Modified();
  const PassState seamless(window_);  // as it is while VTK's image-based lighting draws
  window_->WaitForCompletion();
  double seconds = 0.0;
  {
    const CpuTimer timer(seconds);
    prefilter_->Load(renderer_);
    window_->WaitForCompletion();
  }
  prefilter_->PostRender(renderer_);
  return seconds;
}

CubeMap StockPrefilter::read() const {
  CubeMap result(faceSize_, levels());
  glBindTexture(GL_TEXTURE_CUBE_MAP, prefilter_->GetTextureObject()->GetHandle());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int level = 0; level < levels(); ++level) {
    for (int face = 0; face < 6; ++face) {
      glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level, GL_RGBA, GL_FLOAT,
                    result.face(level, face));
    }
  }
  glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
  return result;
}

int StockPrefilter::levels() const {
  return static_cast<int>(prefilter_->GetPrefilterLevels());
}

float StockPrefilter::bakedRoughness(int level) const {
  return static_cast<float>(level) / static_cast<float>(levels());
}

float StockPrefilter::levelLookedUp(float roughness) const {
  return roughness * static_cast<float>(levels() - 1);
}

}  // namespace boxprobe::bench
