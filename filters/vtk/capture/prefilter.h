// Prefilters a capture with OpenGL: copies level 0 (or blurs it, with the Gaussian filter) and filters each further
// level by its lobe. One level per call, so that a window stays responsive. filters/math/cube/cube_filter.h is the CPU
// version.
#pragma once

#include <vector>

#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/technique/levels_read.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/maps/flat_texture.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class Prefilter {
 public:
  Prefilter(vtkOpenGLRenderWindow* window, Counters* counters);

  /// Makes the source's own mip levels, and level 0 of the chain. Both must be allocated; the source needs as many
  /// levels as its size allows.
  void begin(const CubeTexture& source, const CubeTexture& chain, const PrefilterSettings& settings = {});
  /// Level 1 and up.
  void filterLevel(const CubeTexture& source, const CubeTexture& chain, int level,
                   const PrefilterSettings& settings = {});
  /// Filters with any samples; used with those of the level's own lobe above.
  void filterWith(const CubeTexture& source, const CubeTexture& chain, int level, const std::vector<LobeTap>& taps,
                  int edgeFixupWidth = 0);
  /// Copies a level to another chain of the same size.
  void copyLevel(const CubeTexture& from, const CubeTexture& to, int level);
  /// Makes only the source's levels.
  void makeSourceLevels(const CubeTexture& source);
  /// Diffuse irradiance by world normals, from a small level of the source.
  static ShCoefficients irradiance(const CubeTexture& source, const glm::dmat3& worldFromMap = glm::dmat3(1.0));

  /// Releases what was made from the current source.
  void forgetSource();
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  Counters* counters_;
  /// Does `source` get sampled from a flat picture? Makes it if so.
  bool flattened(const CubeTexture& source, std::size_t lookups);
  const std::vector<LobeTap>& tapsOf(const FilterLobe& lobe, int samples, int faceSize);

  CubeFramebuffer from_, to_;
  FullScreenPass sourcePass_, lobePass_, flatPass_, fixupPass_;
  FlatTexture flat_;   ///< of the source filtered last, if that is faster
  GLuint flatOf_ = 0;  ///< that source; 0: none
  std::shared_ptr<std::size_t> flatBytes_ = std::make_shared<std::size_t>(0);
  struct Taps {
    FilterLobe lobe;
    int samples = 0, faceSize = 0;
    std::vector<LobeTap> taps;
  };
  std::vector<Taps> taps_;  ///< of the lobes used last: probes of one size share them
  GLuint tapBuffer_ = 0;
};

}  // namespace boxprobe
