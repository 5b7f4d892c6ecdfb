// Whole pictures against the path tracer's: what a technique's picture is off on diffuse and on glossy surfaces, where
// no lamp shines, in corners, by roughness and by the angle of view. Called by `bench --whole`; knows no renderer.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

/// What a pixel's middle shows.
struct SeenPoint {
  bool surface = false;      ///< false: the background
  bool glossy = false;       ///< a metal, a coat, or smoother than 0.3; else its light is mostly diffuse
  bool glass = false;        ///< neither of both
  bool lamp = false;         ///< it shines itself
  double roughness = 0.0;    ///< perceptual; of a coat the coat's
  double elevation = 0.0;    ///< of the eye over the surface, degrees
  bool facesNoLamp = false;  ///< every lamp and light source lies behind the surface; false in a scene without any
  bool nearAnother = false;  ///< a surface that is not in its own plane is within 5 cm
};

/// Row by row from the top, `width` x `height` of them.
std::vector<SeenPoint> seenPoints(const Scene& scene, const SceneTracer& tracer, const Camera& camera, int width,
                                  int height);

/// The pixels of one kind: what a picture is off there.
struct PartError {
  std::string part;  ///< "all", "diffuse", "glossy", "behind a lamp", "within 5 cm of a wall", "roughness 0-0.1", ...
  std::size_t pixels = 0;
  double light = 1.0;         ///< mean of the picture over that of the truth; 1 for black on black
  double relativeRmse = 0.0;  ///< root of the sum of squared differences over that of the truth's squares, noise off
  double noise = 0.0;         ///< of the truth, in the same measure
};

/// Of every part that has pixels. The truth's noise, as its standard error has it, is taken off the squared
/// differences.
std::vector<PartError> partErrors(const ImageRgbaF& picture, const ReferencePicture& truth,
                                  const std::vector<SeenPoint>& seen);

/// One picture's row of the table.
struct WholeRow {
  std::string scene, camera, technique;
  std::string bounces;  ///< of the truth: a number or "all"
  std::vector<PartError> parts;
};

/// Light and relative RMSE of all, diffuse and glossy pixels, of those behind lamps and near walls; a line a picture.
std::string wholeTable(const std::vector<WholeRow>& rows);
/// {"complete", "rows": [{"scene", "camera", "technique", "reference": "path", "bounces", "parts": [..]}]}
nlohmann::ordered_json wholeJson(const std::vector<WholeRow>& rows, bool complete);

}  // namespace boxprobe
