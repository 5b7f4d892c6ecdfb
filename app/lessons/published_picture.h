// What published forms of the projection make of a picture, for lessons on their mistakes: the picture as the program
// draws it, with every pixel's lookup done again by the other form, on the CPU. Called by the lesson player and the
// window; none of these forms is a technique.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class SceneRenderer;
struct BakedMaps;

/// One of publishedForms(); see published_picture.cpp.
bool isPublishedForm(const std::string& id);

/// A row at a time, so that a window can go on in between. The renderer's camera and maps must not change meanwhile.
class PublishedPicture {
 public:
  PublishedPicture(SceneRenderer& renderer, const Scene& scene, std::string form, int width, int height);
  /// So many more rows; false when the picture is complete.
  bool draw(int rows);
  /// Linear; what is not a number, as nothing else in a scene: magenta.
  const ImageRgbaF& linear() const { return picture_; }
  /// At the scene's exposure, so many times as large.
  ImageRgba8 display(int scale) const;
  /// Share of the pixels that reflect whose lookup is not a number.
  double brokenShare() const;
  /// Mean angle between what the form looks up and what the program does, degrees, over all pixels where both are
  /// numbers; 0 where there are none.
  double meanTurn() const;

 private:
  glm::vec3 lookedUp(const BakedMaps& maps, const glm::vec3& along, float level);

  SceneRenderer& renderer_;
  const Scene& scene_;
  std::string form_;
  std::map<const BakedMaps*, CubeMap> made_;  ///< out of those maps, for forms that keep them in another way
  ImageRgbaF picture_;
  int next_ = 0;
  long long reflecting_ = 0, broken_ = 0;
  double turned_ = 0.0;  ///< degrees, in all
};

}  // namespace boxprobe
