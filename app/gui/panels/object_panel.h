// Where an object stands, whether it moves, and whether it is a planar mirror for those that do. A drag of a field
// previews, its end commits.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;

namespace boxprobe {

class ValueField;
class VectorRow;
class Workspace;

class ObjectPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectPanel(Workspace& workspace);

  /// The one of that name is shown; false if there is none.
  bool choose(const std::string& name);

 private:
  /// The objects to choose from: the models' nodes.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  void update();
  std::string node() const;
  QString label(const QString& pattern) const;
  Document::Edit objectEdit(const std::function<void(ObjectOverride&)>& change) const;
  Document::Edit mirrorEdit(const std::function<void(PlanarMirror&)>& change) const;
  void connectVector(VectorRow* row, const QString& pattern, glm::dvec3 ObjectOverride::*field);
  void connectNumber(ValueField* field, const QString& pattern, double PlanarMirror::*member);
  void makeMirror(bool on);
  void showPlane();

  Editor& editor_;
  std::vector<std::shared_ptr<const Model>> models_;
  QComboBox* nodes_;
  QCheckBox* dynamic_;
  VectorRow* position_;
  VectorRow* rotation_;
  QCheckBox* mirror_;
  QWidget* mirrorPart_;
  ValueField* maxRoughness_;
  ValueField* resolution_;
  QLabel* problem_;
  bool fresh_ = false;       ///< other models: none has been chosen yet
  std::string checkedNode_;  ///< `problem_` is of it
  ObjectOverride checkedPlace_;
};

}  // namespace boxprobe
