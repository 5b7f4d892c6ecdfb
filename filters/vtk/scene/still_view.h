// Which props a view at rest hides: found out once for a view, kept until anything about it changes. Owned by the
// culled renderer, which draws; knows no OpenGL and not what the props are.
#pragma once

#include <vtkType.h>

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace boxprobe {

/// Three frames of one view: the first draws all props, the second finds out which of them nothing shows of, those from
/// the third on leave them out. Any change of the camera, the picture's size, the list of props, or the redraw time of
/// one of them begins again. What changes a picture in ways that none of these tells of (what a texture cuts out, say)
/// must be told by forget().
class StillView {
 public:
  StillView() = default;
  StillView(const StillView&) = delete;
  StillView& operator=(const StillView&) = delete;

  /// Begins a frame of the props that hide or may be hidden. Returns whether this frame shall find out and set().
  bool begin(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  /// What nothing shows of, past the others of this frame's props.
  void set(std::unordered_set<vtkProp*> hidden);
  /// Is it known what this frame's view hides?
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
