// A probe's box, influence and capture origin in the probe frame of shaders/shared/types.glsl. Double precision until
// the last step.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

struct ProbeGeometry {
  glm::dvec3 originWorld{0.0};     ///< where the probe was captured
  glm::dmat3 worldFromProbe{1.0};  ///< rotation only
  bool rotated = false;
  glm::dmat3 mapFromProbe{1.0};          ///< rotation to the axes of the probe's maps
  bool mapTurned = false;                ///< is mapFromProbe a rotation? Not for maps captured with the box as it is
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};  ///< probe frame: relative to the capture origin, along the box's axes
  glm::vec3 influenceMin{0.0f}, influenceMax{0.0f};
  glm::vec3 rateMin{0.0f}, rateMax{0.0f};  ///< 1 / blend distance, by face
  float intensity = 1.0f;
  bool bevelled = false;  ///< edges rounded by bevelRadius + bevelFromRoughness * roughness, scene units
  float bevelRadius = 0.0f, bevelFromRoughness = 0.0f;
  bool occluded = false;      ///< darkened by hit distance; see shared/box_occlusion.glsl
  glm::vec3 occlusion{1.0f};  ///< multiplier, power, strength
  double importance = 1.0;
  Technique technique;
  shading::TechniqueParameters parameters = standardParameters();
  bool animated = false;  ///< the technique draws another pattern each frame: the picture is an average of frames
  bool blurred = false;   ///< its samples are smoothed afterwards
};

/// What the techniques take. `maxLevel`: last level of the probe's maps; `roughness`: of the surface, perceptual.
shading::ProbeShape probeShape(const ProbeGeometry& geometry, float maxLevel, float roughness);

/// The technique that draws the probe: with projection off, the bare reflection vector is sampled.
Technique probeTechnique(const Probe& probe);

/// Rotation about X, then Y, then Z (world axes).
glm::dmat3 rotationMatrix(const glm::dvec3& rotationDegrees);

/// `capturedAt` may differ from probe.origin while a new capture is under way: lookups must use the position where the
/// map was captured. So may `capturedRotation` (degrees, as rotationMatrix takes them) from the box's: maps lie along
/// the axes the box had when they were captured; those of pictures and of the sky along the world's.
ProbeGeometry probeGeometry(const Probe& probe, const glm::dvec3& capturedAt,
                            const glm::dvec3& capturedRotation = glm::dvec3(0.0));

/// Does every point of an axis-aligned box have full weight?
bool fullWeightEverywhere(const Probe& probe, const Box& boundsWorld);

/// Axis-aligned world bounds of the influence box and its skin.
Box influenceBounds(const Probe& probe);

}  // namespace boxprobe
