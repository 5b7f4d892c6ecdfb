// Two rooms with a door between them and a window, furniture and lamps, in which nothing is symmetric: what the tests
// of core_test that keep values derive lamps, sights, lattices and mirrors from. Its rays are the tests' own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/sight_lines.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe::test {

/// A rectangle across an axis, whose front is on the side of `sign`.
struct Panel {
  std::string node;
  int axis = 0;
  double at = 0.0, sign = 1.0;
  double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};  ///< along the next axis and the one after
  glm::vec3 albedo{0.5f};
  glm::vec3 emitted{0.0f};
};

struct House : SightLines {
  House();

  bool empty() const override { return panels.empty(); }
  bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool shining) const override;
  std::optional<Met> first(const glm::dvec3& from, const glm::dvec3& direction) const override;
  Box bounds() const override;

  /// Its panels by node, and lamps that are no rectangles across an axis.
  std::shared_ptr<const Model> model() const;
  /// With that model, two probes, lights and lamps of all kinds.
  Scene scene() const;

  std::vector<Panel> panels;

 private:
  void panel(const std::string& node, int axis, double at, double sign, double u0, double u1, double v0, double v1,
             const glm::vec3& albedo, const glm::vec3& emitted = glm::vec3(0.0f));
  void wall(const std::string& node, int axis, double at, double sign, double u0, double u1, double v0, double v1,
            double holeU0, double holeU1, double holeV0, double holeV1, const glm::vec3& albedo);
  void block(const std::string& node, const Box& box, const glm::vec3& albedo,
             const glm::vec3& emitted = glm::vec3(0.0f));
};

std::string keptBox(const Box& box);

/// The count of `values`, four means that each of them is part of, and some of them.
std::string digest(const std::vector<double>& values);

}  // namespace boxprobe::test
