// Compares whole pictures with the path tracer's: errors on diffuse and glossy surfaces, where no lamp shines, in
// corners, by roughness and by view angle.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/trace/scene_tracer.h"

namespace boxprobe {

/// The surface in the middle of a pixel.
struct SeenPoint {
  bool surface = false;      ///< false: the background
  bool glossy = false;       ///< a metal, a coat, or smoother than 0.3; other surfaces are mostly diffuse
  bool glass = false;        ///< neither glossy nor diffuse
  bool lamp = false;         ///< emissive
  double roughness = 0.0;    ///< perceptual; of a coat its own
  double elevation = 0.0;    ///< of the eye above the surface, degrees
  bool facesNoLamp = false;  ///< all lamps and light sources are behind the surface; false in a scene without any
  bool nearAnother = false;  ///< another surface, outside its plane, is within 5 cm
};

/// `width` x `height` points, row by row from the top.
std::vector<SeenPoint> seenPoints(const Scene& scene, const SceneTracer& tracer, const Camera& camera, int width,
                                  int height);

/// The error of a picture for the pixels of one kind.
struct PartError {
  std::string part;  ///< "all", "diffuse", "glossy", "behind a lamp", "within 5 cm of a wall", "roughness 0-0.1", ...
  std::size_t pixels = 0;
  double light = 1.0;         ///< mean of the picture over that of the reference; 1 for black on black
  double relativeRmse = 0.0;  ///< root of summed squared differences over the reference's squares, noise off
  double noise = 0.0;         ///< of the reference, as relativeRmse
};

/// For every part that has pixels. The reference's noise, by its standard error, is subtracted from the squared
/// differences.
std::vector<PartError> partErrors(const ImageRgbaF& picture, const ReferencePicture& truth,
                                  const std::vector<SeenPoint>& seen);

/// A picture's row of the table.
struct WholeRow {
  std::string scene, camera, technique;
  std::string bounces;  ///< of the reference: a number or "all"
  std::vector<PartError> parts;
};

/// Light and relative RMSE of all, diffuse and glossy pixels, and of those behind lamps and near walls; one line per
/// picture.
std::string wholeTable(const std::vector<WholeRow>& rows);
/// {"complete", "rows": [{"scene", "camera", "technique", "reference": "path", "bounces", "parts": [..]}]}
nlohmann::ordered_json wholeJson(const std::vector<WholeRow>& rows, bool complete);

}  // namespace boxprobe
