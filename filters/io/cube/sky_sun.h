// The sun in a picture of the surroundings: a small disc that holds much of the light. As texels of a map it throws no
// shadow, and nine coefficients of diffuse light ring around it; as a directional light it is what it is.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// What was taken out of a picture.
struct SkySun {
  glm::dvec3 towards{0.0, 1.0, 0.0};  ///< unit length, in the picture's frame: not turned by the scene
  glm::vec3 irradiance{0.0f};         ///< of a surface that faces it
  double angleDegrees = 0.53;  ///< apparent diameter of an even disc of its light, as bright as its brighter part
};

/// Takes the sun out of a picture, if it has one, and leaves the light around it in its place: the sum of both lights
/// every surface that the whole sun reaches as before. `beyondHalf`: how many texels are above the largest half float,
/// before and after. A sun is the brightest texel with all around it above 1/64 of that, at most above 65504, where
/// - these lie within 3.5 degrees of their centre, a texel's width apart, and further out to 7 degrees there is less
///   than 2 % of their light, and
/// - they are beyond half floats, or above 256 times the picture's mean and light a surface that faces them at least an
///   eighth as much as the rest of the picture would, were it even.
/// A picture without one is not changed.
std::optional<SkySun> takeSun(ImageRgbaF& latLong, std::size_t& beyondHalf);
std::optional<SkySun> takeSun(CubeMap& cube, std::size_t& beyondHalf);

/// The light that is drawn in its place, in a sky turned about +Y: 90 degrees take +Z to +X.
Light lightOf(const SkySun& sun, double skyRotationDegrees);

}  // namespace boxprobe
