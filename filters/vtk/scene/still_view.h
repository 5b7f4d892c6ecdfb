// Which props are hidden in a view at rest: determined once per view, kept until it changes.
#pragma once

#include <vtkType.h>

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace boxprobe {

/// Three frames of one view: the first draws all props, the second finds out which are invisible, later ones cull
/// those. Any change of the camera, the picture's size, the list of props, or the redraw time of a prop starts again.
/// Other changes (what a texture cuts out, for instance) must be reported by forget().
class StillView {
 public:
  StillView() = default;
  StillView(const StillView&) = delete;
  StillView& operator=(const StillView&) = delete;

  /// Starts a frame of the props that hide or may be hidden. Returns whether this frame must determine the hidden ones
  /// and call set().
  bool begin(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  /// The props that are invisible behind others of this frame.
  void set(std::unordered_set<vtkProp*> hidden);
  /// Are the hidden props of this view known?
  bool known() const { return stage_ == Stage::Known; }
  bool hides(vtkProp* prop) const { return known() && hidden_.count(prop) != 0; }
  /// The next frame draws everything.
  void forget() { stage_ = Stage::Unknown; }

 private:
  enum class Stage { Unknown, Drawn, Asked, Known };
  struct Key {
    std::vector<double> view;
    std::vector<std::pair<vtkProp*, vtkMTimeType>> props;
    bool operator==(const Key& o) const { return view == o.view && props == o.props; }
  };
  static Key keyOf(vtkRenderer* renderer, const std::vector<vtkProp*>& props);

  Key key_;
  Stage stage_ = Stage::Unknown;
  std::unordered_set<vtkProp*> hidden_;
};

}  // namespace boxprobe
