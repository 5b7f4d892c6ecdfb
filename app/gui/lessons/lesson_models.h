// The models of a lesson's scene: those that are loaded already are used again, the others are read with a box that
// shows how far and can be stopped. Called by the lesson visit; knows no lesson.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

class QWidget;

namespace boxprobe {

class LessonModels {
 public:
  using List = std::vector<std::shared_ptr<const Model>>;

  /// In the order of scene.models. `shown` of `shownScene` are at hand. Throws InputError, or LoadCancelled if the user
  /// stopped it.
  List load(const Scene& scene, const Scene& shownScene, const List& shown, QWidget* window);
  void forget() { known_.clear(); }

 private:
  std::map<std::string, std::shared_ptr<const Model>> known_;  ///< by file
};

}  // namespace boxprobe
