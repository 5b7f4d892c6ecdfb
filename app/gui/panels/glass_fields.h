// What a material of glass has beside its roughness: transmission, index, thickness, absorption, the form it is drawn
// in, set live. Part of the material panel, which says of which material; edits through the editor.
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace boxprobe {

class ValueField;
class VectorRow;

class GlassFields : public QWidget {
  Q_OBJECT

 public:
  explicit GlassFields(Editor& editor, QWidget* parent = nullptr);

  /// `model`: the material as its file has it.
  void show(const std::string& name, const Material& model);

 private:
  /// A number of the material, by its key in the scene file.
  ValueField* addNumber(QFormLayout* form, const QString& name, const char* key, double step);
  /// `control`: what previews before it commits; null for a control that does not.
  void preview(const void* control, const QString& what, const std::function<void(MaterialOverride&)>& edit);
  void commit(const void* control, const QString& what, const std::function<void(MaterialOverride&)>& edit);
  glm::vec3 shownColor() const;
  void enable(bool transmits, bool thin);

  Editor& editor_;
  std::string name_;
  Material model_;
  ValueField* transmission_;
  ValueField* ior_;
  QCheckBox* thin_;
  ValueField* thickness_;
  ValueField* distance_;
  VectorRow* color_;
  QComboBox* form_;
  QPushButton* reset_;
};

}  // namespace boxprobe
