// Three numbers side by side, X Y Z or R G B, each with a label in its axis' colour that can be scrubbed. Called by the
// panels; knows no document.
#pragma once

#include <QLabel>
#include <QWidget>
#include <array>
#include <glm/vec3.hpp>

#include "app/gui/widgets/value_field.h"

namespace boxprobe {

class VectorRow : public QWidget {
  Q_OBJECT

 public:
  VectorRow(const ValueField::Format& format, const QString& toolTip, QWidget* parent = nullptr,
            const QString& names = "XYZ");

  void show(const glm::dvec3& value);
  /// What the numbers are, for who does not see the label beside: "Origin" makes "Origin X".
  void setName(const QString& name);
  ValueField* field(int axis) const { return fields_[static_cast<std::size_t>(axis)]; }

 signals:
  void previewed(int axis, double value);
  void committed(int axis, double value);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colorNames();

  std::array<QLabel*, 3> labels_{};
  std::array<ValueField*, 3> fields_{};
};

}  // namespace boxprobe
