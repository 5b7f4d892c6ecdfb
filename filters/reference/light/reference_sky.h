// The sky for references: radiance in any direction, and the light of first captures: nine coefficients for diffuse
// light, and a prefiltered chain for reflections where no probe reaches.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

class ReferenceSky {
 public:
  /// `image`: the picture of a SkyImage, null for any other sky (and for a missing picture: black).
  ReferenceSky(const Sky& sky, std::shared_ptr<const ImageRgbaF> image, double rotationDegrees = 0.0);

  glm::vec3 radiance(const glm::vec3& directionWorld) const;
  /// Level 0 is the radiance by direction.
  const CubeMap& chain() const { return chain_; }
  /// Over pi.
  glm::vec3 irradiance(const glm::vec3& normalWorld) const;
  /// As reflected by a surface of that roughness: one lookup, like the renderer's.
  glm::vec3 reflection(const glm::vec3& directionWorld, float roughness) const;

 private:
  glm::vec3 imageRadiance(const glm::vec3& direction) const;

  Sky sky_;
  std::shared_ptr<const ImageRgbaF> image_;
  double rotation_;  ///< about +Y, radians
  CubeMap chain_;
  ShCoefficients irradiance_{};
};

}  // namespace boxprobe
