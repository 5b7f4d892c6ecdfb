// See axis_colors.h.
#include "app/gui/widgets/axis_colors.h"

#include <cmath>

#include "filters/vtk/widgets/handle_colors.h"

namespace boxprobe {

namespace {

QColor toQt(const glm::dvec3& display) {
  const auto byte = [](double value) { return static_cast<int>(std::lround(255.0 * value)); };
  return {byte(display.x), byte(display.y), byte(display.z)};
}

}  // namespace

QColor axisColor(int axis) {
  return toQt(HandleColors().axes[static_cast<std::size_t>(axis)]);
}
QColor boxColor() {
  return toQt(HandleColors().box);
}
QColor blendColor() {
  return toQt(HandleColors().blend);
}
QColor influenceColor() {
  return toQt(HandleColors().influence);
}
QColor originColor() {
  return toQt(HandleColors().origin);
}
QColor haloColor() {
  return toQt(HandleColors().halo);
}

}  // namespace boxprobe
