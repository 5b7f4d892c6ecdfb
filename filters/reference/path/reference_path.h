// A path tracer of the scene as its files have it: emission, the scene's lights with their sizes, the sky, every
// material. What whole pictures are judged by. Beside the readers of files and the triangles they give it shares
// nothing with what it judges: no probe, no map, no coefficient, no table, no line of shaders/shared.
//
// What it is, exactly:
// - Light is scattered at most `bounces` + 1 times on its way to the camera: 0 bounces are what shines, and what lamps,
//   light sources and sky send to what the camera sees, if nothing stands between.
// - Materials as glTF 2.0 and its extensions have them (path_lobes.h), single scattering between microfacets whatever
//   `energy` says. Occlusion textures are left out: they stand in for light that is traced here.
// - Light sources with a size are spheres and discs, seen in reflections and not by the camera. Emission is seen from
// the
//   front of single-sided triangles alone; other single-sided triangles stop all rays but the camera's.
// - What the picture shows, and not what probes see: stand-ins for probes are not there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

struct PathSettings {
  int width = 1280;
  int height = 720;
  int raysPerPixel = 256;      ///< paths that begin at the camera
  std::optional<int> bounces;  ///< nothing: all
  std::uint64_t seed = 1;
  PicturePart part;  ///< what of the picture is wanted; the rest stays black
};

class ReferencePath {
 public:
  /// `models` in the order of scene.models; `skyImage`: the sky's picture if it has one. Throws WorkError.
  ReferencePath(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                std::shared_ptr<const ImageRgbaF> skyImage);
  ~ReferencePath();
  ReferencePath(const ReferencePath&) = delete;
  ReferencePath& operator=(const ReferencePath&) = delete;

  /// Linear radiance. Each pixel is the mean over its square; alpha is 1 where the middle shows a surface. The same
  /// bits for any number of threads and any part.
  ReferencePicture render(const Camera& camera, const PathSettings& settings,
                          const ReferenceProgress& progress = {}) const;

  /// Sentences without a full stop: nothing sends light; what of the scene is left out.
  std::vector<std::string> remarks() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace boxprobe
