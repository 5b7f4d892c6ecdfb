#include "filters/vtk/capture/level_filter.h"

#include <vtkOpenGLRenderWindow.h>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

LevelFilter::LevelFilter(vtkOpenGLRenderWindow* window, Prefilter* prefilter)
    : window_(window), prefilter_(prefilter) {}

void LevelFilter::make(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings) {
  window_->MakeCurrent();
  source_.allocate(chain.faceSize(), fullLevels(chain.faceSize()), GL_RGBA16F);
  prefilter_->copyLevel(chain, source_, 0);
  prefilter_->makeSourceLevels(source_);
  for (int level = 1; level < chain.levels(); ++level) {
    if ((levels >> level & 1u) == 0) continue;
    prefilter_->filterLevel(source_, chain, level, settings);
  }
  prefilter_->forgetSource();
  source_.release();
}

void LevelFilter::release() {
  source_.release();
}

}  // namespace boxprobe
