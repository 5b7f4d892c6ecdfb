// A probe's boxes as points in the world: corners, faces, the axes along which a face moves.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A face of a box: axis 0, 1, 2 = X, Y, Z of the box's own frame; `positive` for the face at the maximum.
struct BoxFace {
  int axis = 0;
  bool positive = true;
  bool operator==(const BoxFace& o) const { return axis == o.axis && positive == o.positive; }
  double sign() const { return positive ? 1.0 : -1.0; }
  int index() const { return 2 * axis + (positive ? 0 : 1); }
};

/// +X, -X, +Y, -Y, +Z, -Z.
constexpr std::array<BoxFace, 6> kBoxFaces = {{{0, true}, {0, false}, {1, true}, {1, false}, {2, true}, {2, false}}};

/// "+X"
const char* faceName(const BoxFace& face);

/// World position of `pointBox`, given as if the box were not rotated: rotates it about `pivot`.
glm::dvec3 worldFromBox(const glm::dmat3& rotation, const glm::dvec3& pivot, const glm::dvec3& pointBox);

/// Corner i has the maximum along X, Y, Z if bit 0, 1, 2 of i is set.
std::array<glm::dvec3, 8> boxCornersWorld(const Box& box, const glm::dmat3& rotation, const glm::dvec3& pivot);

/// The twelve edges as pairs of corner indices.
const std::array<std::array<int, 2>, 12>& boxEdges();

glm::dvec3 faceCenterWorld(const Probe& probe, const BoxFace& face);
/// Unit length, pointing out of the box.
glm::dvec3 faceAxisWorld(const Probe& probe, const BoxFace& face);

/// The region where the probe's weight is 1: the influence box shrunk by the blend distances. Where two opposite
/// distances meet, the region has no thickness along that axis and lies where the weight is highest.
Box fullWeightBox(const Probe& probe);

/// Sets the probe's box; an influence box of its own stays where it is in the world, although it rotates about the same
/// pivot.
void setBox(Probe& probe, const Box& box);

/// The box with `face` moved outwards by `offset` along its own axis and, if `symmetric`, the opposite face equally far
/// the other way. All other faces stay where they are in the world, also in a rotated box: its centre, the pivot of the
/// rotation, moves with the face. The result is never thinner than `minimumThickness` along that axis.
Box withFaceMoved(const Box& box, const glm::dvec3& rotationDegrees, const BoxFace& face, double offset, bool symmetric,
                  double minimumThickness);

/// Minimum distance, in metres, between opposite faces that are moved by hand: thin enough for the slab of a mirror,
/// thick enough to tell both handles apart and grab them.
constexpr double kMinimumThickness = 0.05;

}  // namespace boxprobe
