// Reads one level of a probe's maps back a face at a time, so that a window goes on answering. Called by previews, with
// the window's context current. Knows no scene, and shows its callers nothing of OpenGL.
#pragma once

#include <memory>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class CubeTexture;
struct ProbeMaps;

/// Of the light's chain.
int levelCount(const ProbeMaps& maps);
int faceSize(const ProbeMaps& maps);

class LevelReader {
 public:
  /// Begins again. `level` is brought into the chain; `distance` reads the distances, which have one level.
  void start(std::shared_ptr<const ProbeMaps> maps, int level, bool distance);
  void stop();
  bool pending() const { return face_ < 6; }
  /// One face.
  void step();
  /// Complete once nothing is pending: the level read, as level 0. Empty for maps without distances.
  const CubeMap& cube() const { return cube_; }

 private:
  std::shared_ptr<const ProbeMaps> maps_;
  const CubeTexture* texture_ = nullptr;
  int level_ = 0;
  int face_ = 6;  ///< the next to read; 6: none
  CubeMap cube_;
};

}  // namespace boxprobe
