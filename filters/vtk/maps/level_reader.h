// Reads back one level of a probe's maps, a face at a time, so that a window stays responsive. Its interface is free of
// OpenGL. Needs the window's context current.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class CubeTexture;
struct ProbeMaps;

/// Of the radiance chain.
int levelCount(const ProbeMaps& maps);
int faceSize(const ProbeMaps& maps);

class LevelReader {
 public:
  /// Starts again. `level` is clamped to the chain; `distance` reads the distances, which have one level.
  void start(std::shared_ptr<const ProbeMaps> maps, int level, bool distance);
  void stop();
  bool pending() const { return face_ < 6; }
  /// Reads one face.
  void step();
  /// Complete when nothing is pending: the level that was read, as level 0. Empty for maps without distances.
  const CubeMap& cube() const { return cube_; }

 private:
  std::shared_ptr<const ProbeMaps> maps_;
  const CubeTexture* texture_ = nullptr;
  int level_ = 0;
  int face_ = 6;  ///< the next face to read; 6: none
  CubeMap cube_;
};

}  // namespace boxprobe
