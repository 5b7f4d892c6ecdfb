// The wireframe boxes of probes in a vtkRenderer: the selected probe's box and, dashed, its box of full weight; those
// of other selected probes; proposed boxes; thin boxes of the other probes.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle.h"
#include "filters/vtk/widgets/handle_colors.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace boxprobe {

struct LineLook {
  glm::dvec3 color{1.0};
  double widthPixels = 1.0;  ///< logical pixels
  double opacity = 1.0;
  bool halo = true;  ///< a wider dark line behind it, for contrast on light and dark pictures
};

/// A set of world-space segments.
class HaloLines {
 public:
  HaloLines(vtkRenderer* renderer, const LineLook& look);
  void setSegments(const std::vector<glm::dvec3>& endpointPairsWorld);
  void setVisible(bool visible);
  void setColors(const glm::dvec3& line, const glm::dvec3& halo);
  /// Device pixels per logical pixel.
  void setPixelScale(double scale);
  /// Scales positions by `factor` about `eyeWorld`: the same on the screen, but nearer in depth.
  void pullTowards(const glm::dvec3& eyeWorld, double factor);

 private:
  void placeActors();

  LineLook look_;
  vtkSmartPointer<vtkPolyData> lines_;
  vtkSmartPointer<vtkActor> core_, halo_;  ///< halo_ may be null
  glm::dvec3 anchorWorld_{0.0};            ///< the points are relative to it, to preserve float precision far from 0
  glm::dvec3 eyeWorld_{0.0};
  double pull_ = 1.0;
  bool visible_ = true, empty_ = true;
};

class WireActors {
 public:
  /// `faint`: draws the lines where the scene hides them; another layer draws the visible parts.
  WireActors(vtkRenderer* renderer, bool faint);

  /// In HandleMode::Influence the influence box is drawn even if it equals the projection box. `together`: ascending
  /// indices of all selected probes.
  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
              const std::vector<std::size_t>& together, HandleMode mode);
  /// A line from a capture origin to the floor below it, with a cross there; nothing: none.
  void setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld);
  /// Proposed boxes, dashed.
  void setGhosts(const std::vector<Probe>& ghosts);
  void setColors(const HandleColors& colors);
  void setPixelScale(double scale);
  void pullTowards(const glm::dvec3& eyeWorld, double factor);

 private:
  std::array<HaloLines*, 7> all() { return {&idle_, &beside_, &influence_, &blend_, &box_, &ghost_, &drop_}; }

  HaloLines idle_, beside_, influence_, blend_, box_, ghost_, drop_;
};

}  // namespace boxprobe
