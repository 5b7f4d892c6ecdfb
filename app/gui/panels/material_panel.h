// Roughness and glass of the model's materials, set live: the slider previews, letting go commits.
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"

class QComboBox;
class QPushButton;
class QSlider;

namespace boxprobe {

class GlassFields;
class ValueField;
class Workspace;

class MaterialPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MaterialPanel(Workspace& workspace);

  /// The one of that name is shown; false if there is none.
  bool choose(const std::string& name);

 private:
  /// The materials to choose from: those with a name, in the models' order.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  void update();
  std::string material() const;
  float modelRoughness() const;
  QString label() const;
  void preview(double roughness);
  void commit(double roughness);

  Editor& editor_;
  std::vector<Material> known_;  ///< as the models have them, without textures
  QComboBox* materials_;
  QSlider* slider_;
  ValueField* field_;
  QPushButton* reset_;
  GlassFields* glass_;
};

}  // namespace boxprobe
