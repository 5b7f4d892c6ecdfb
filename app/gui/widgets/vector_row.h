// Three numbers side by side, X Y Z or R G B, each with a label in its axis' colour that can be scrubbed. Called by the
// panels; knows no document.
#pragma once

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
  ValueField* field(int axis) const { return fields_[static_cast<std::size_t>(axis)]; }

 signals:
  void previewed(int axis, double value);
  void committed(int axis, double value);

 private:
  std::array<ValueField*, 3> fields_{};
};

}  // namespace boxprobe
