// The rotation is about the box's centre, so moving one face of a rotated box moves the pivot, too.
#include "filters/core/geometry/probe_frame.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

const char* faceName(const BoxFace& face) {
  static constexpr std::array<const char*, 6> names = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return names[static_cast<std::size_t>(face.index())];
}

glm::dvec3 worldFromBox(const glm::dmat3& rotation, const glm::dvec3& pivot, const glm::dvec3& pointBox) {
  return pivot + rotation * (pointBox - pivot);
}

std::array<glm::dvec3, 8> boxCornersWorld(const Box& box, const glm::dmat3& rotation, const glm::dvec3& pivot) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 corner(i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y,
                            i & 4U ? box.max.z : box.min.z);
    corners[i] = worldFromBox(rotation, pivot, corner);
  }
  return corners;
}

const std::array<std::array<int, 2>, 12>& boxEdges() {
  static constexpr std::array<std::array<int, 2>, 12> edges = {{{{0, 1}},
                                                                {{2, 3}},
                                                                {{4, 5}},
                                                                {{6, 7}},
                                                                {{0, 2}},
                                                                {{1, 3}},
                                                                {{4, 6}},
                                                                {{5, 7}},
                                                                {{0, 4}},
                                                                {{1, 5}},
                                                                {{2, 6}},
                                                                {{3, 7}}}};
  return edges;
}

glm::dvec3 faceCenterWorld(const Probe& probe, const BoxFace& face) {
  const glm::dvec3 center = probe.box.center();
  return center + faceAxisWorld(probe, face) * (0.5 * probe.box.size()[face.axis]);
}

glm::dvec3 faceAxisWorld(const Probe& probe, const BoxFace& face) {
  return rotationMatrix(probe.rotationDegrees)[face.axis] * face.sign();
}

Box fullWeightBox(const Probe& probe) {
  const Box& influence = probe.influenceBox();
  Box inner{influence.min + probe.blendDistance.min, influence.max - probe.blendDistance.max};
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.min[axis] <= inner.max[axis]) continue;
    const double both = probe.blendDistance.min[axis] + probe.blendDistance.max[axis];
    const double meeting =
        influence.min[axis] + influence.size()[axis] * (both > 0.0 ? probe.blendDistance.min[axis] / both : 0.5);
    inner.min[axis] = inner.max[axis] = meeting;
  }
  return inner;
}

void setBox(Probe& probe, const Box& box) {
  if (probe.influence && probe.rotationDegrees != glm::dvec3(0.0)) {
    const glm::dmat3 rotation = rotationMatrix(probe.rotationDegrees);
    const glm::dvec3 centerWorld = worldFromBox(rotation, probe.box.center(), probe.influence->center());
    const glm::dvec3 center = box.center() + glm::transpose(rotation) * (centerWorld - box.center());
    const glm::dvec3 shift = center - probe.influence->center();
    probe.influence->min += shift;
    probe.influence->max += shift;
  }
  probe.box = box;
}

Box withFaceMoved(const Box& box, const glm::dvec3& rotationDegrees, const BoxFace& face, double offset, bool symmetric,
                  double minimumThickness) {
  const double size = box.size()[face.axis];
  // A box that a file made thinner than the minimum may stay so, but not become thinner.
  const double thinnest = std::min(minimumThickness, size);
  const double sides = symmetric ? 2.0 : 1.0;
  const double outwards = std::max(offset, (thinnest - size) / sides);

  Box moved = box;
  if (rotationDegrees == glm::dvec3(0.0)) {
    // Separate from the rotated case, so that the other five numbers stay bit-identical.
    if (face.positive || symmetric) moved.max[face.axis] = box.max[face.axis] + outwards;
    if (!face.positive || symmetric) moved.min[face.axis] = box.min[face.axis] - outwards;
    return moved;
  }
  const glm::dvec3 axisWorld = rotationMatrix(rotationDegrees)[face.axis] * face.sign();
  const glm::dvec3 center = box.center() + (symmetric ? glm::dvec3(0.0) : axisWorld * (0.5 * outwards));
  glm::dvec3 newSize = box.size();
  newSize[face.axis] = size + sides * outwards;
  moved.min = center - 0.5 * newSize;
  moved.max = center + 0.5 * newSize;
  return moved;
}

}  // namespace boxprobe
