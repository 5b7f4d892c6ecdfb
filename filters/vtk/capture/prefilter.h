// From a capture to the chain that lookups read, on the graphics side: level 0 copied (or blurred, by the frosty
// filter), each further level filtered by the lobe it stands for. One level a call, so that a window stays responsive.
// Its twin on the CPU is filters/math/cube/cube_filter.h.
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

  /// The source's own mip levels, and level 0 of the chain. Source and chain are allocated; the source needs as many
  /// levels as its size allows.
  void begin(const CubeTexture& source, const CubeTexture& chain, const PrefilterSettings& settings = {});
  /// Level 1 and up.
  void filterLevel(const CubeTexture& source, const CubeTexture& chain, int level,
                   const PrefilterSettings& settings = {});
  /// Any lookups into any level: what the above does with those of the level's own lobe.
  void filterWith(const CubeTexture& source, const CubeTexture& chain, int level, const std::vector<LobeTap>& taps,
                  int edgeFixupWidth = 0);
  /// The same level of another chain as large, as it is.
  void copyLevel(const CubeTexture& from, const CubeTexture& to, int level);
  /// The source's levels alone.
  void makeSourceLevels(const CubeTexture& source);
  /// Diffuse irradiance, by world normals, from a small level of the source.
  static ShCoefficients irradiance(const CubeTexture& source, const glm::dmat3& worldFromMap = glm::dmat3(1.0));

  /// No more levels of this source: gives back what was made of it.
  void forgetSource();
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  Counters* counters_;
  /// Is `source` looked up in a flat picture of it? That is made here.
  bool flattened(const CubeTexture& source, std::size_t lookups);
  const std::vector<LobeTap>& tapsOf(const FilterLobe& lobe, int samples, int faceSize);

  CubeFramebuffer from_, to_;
  FullScreenPass sourcePass_, lobePass_, flatPass_, fixupPass_;
  FlatTexture flat_;   ///< of the source that was filtered last, where that is quicker
  GLuint flatOf_ = 0;  ///< that source; 0: none
  std::shared_ptr<std::size_t> flatBytes_ = std::make_shared<std::size_t>(0);
  struct Taps {
    FilterLobe lobe;
    int samples = 0, faceSize = 0;
    std::vector<LobeTap> taps;
  };
  std::vector<Taps> taps_;  ///< of the lobes asked for last: probes of one size share them
};

}  // namespace boxprobe
