// A path tracer of the scene as its files describe it: emission, the scene's lights with their sizes, the sky, every
// material. The reference for whole pictures. Apart from the file readers and the triangles it shares nothing with what
// it judges: no probe, no map, no coefficient, no table, no line of shaders/shared.
//
// Exact definition:
// - Light is scattered at most `bounces` + 1 times on its way to the camera: 0 bounces show emission, and direct light
//   of lamps, light sources and sky on what the camera sees, with shadows.
// - Materials follow glTF 2.0 and its extensions (path_lobes.h), with single scattering between microfacets whatever
//   `energy` says. Occlusion textures are ignored: they approximate what is traced here.
// - Light sources with a size are spheres and discs, visible in reflections but not to the camera. Emission is visible
//   from the front of single-sided triangles only; other single-sided triangles block all rays except the camera's.
// - Shows what the picture shows, not what probes see: without stand-ins.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

/// What a picture shows.
enum class PathQuantity {
  Radiance,
  /// At the surface in the middle of each pixel: irradiance over pi of emission, sky and other surfaces, that is what a
  /// white matte surface in its place would show. Excludes what light sources of the scene send there directly.
  /// Blended surfaces count as opaque.
  DiffuseLight,
};

struct PathSettings {
  int width = 1280;
  int height = 720;
  int raysPerPixel = 256;      ///< paths that start at the camera
  std::optional<int> bounces;  ///< empty: unlimited
  std::uint64_t seed = 1;
  PathQuantity quantity = PathQuantity::Radiance;
  PicturePart part;  ///< the rectangle to compute; the rest stays black
};

/// Diffuse light as SceneRenderer::setDiffuseTruth takes it: alpha is the squared standard error over the three
/// channels, -1 where there is no surface.
ImageRgbaF diffuseTruthImage(const ReferencePicture& light);

/// World space.
struct PathRay {
  glm::dvec3 from{0.0}, along{0.0};  ///< unit
  std::uint32_t stream = 0;  ///< rays of one stream draw the same random numbers: their difference has less noise
};

class ReferencePath {
 public:
  /// `models` in the order of scene.models; `skyImage`: the sky's picture if it has one. Throws WorkError.
  ReferencePath(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                std::shared_ptr<const ImageRgbaF> skyImage);
  ~ReferencePath();
  ReferencePath(const ReferencePath&) = delete;
  ReferencePath& operator=(const ReferencePath&) = delete;

  /// Linear. Of radiance each pixel is the mean over its square; alpha is 1 where its middle shows a surface.
  /// Bit-identical for any number of threads and any part.
  ReferencePicture render(const Camera& camera, const PathSettings& settings,
                          const ReferenceProgress& progress = {}) const;

  /// Radiance that arrives along each ray, as a camera at its start would see it: linear, the mean of `paths` paths.
  /// Bit-identical for any number of threads. Empty if `progress` stopped it.
  std::vector<glm::dvec3> radianceAlong(const std::vector<PathRay>& rays, int paths, std::uint64_t seed = 1,
                                        const ReferenceProgress& progress = {}) const;

  /// Sentences without a full stop: there is no light; parts of the scene that are ignored.
  std::vector<std::string> remarks() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace boxprobe
