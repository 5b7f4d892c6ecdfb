// See axis_colors.h.
#include "app/gui/widgets/axis_colors.h"

namespace boxprobe {

QColor axisColor(int axis) {
  if (axis == 0) return {0xf0, 0x55, 0x50};
  if (axis == 1) return {0x7a, 0xc9, 0x43};
  return {0x4f, 0x9d, 0xff};
}

QColor boxColor() {
  return {0xff, 0xb3, 0x1a};
}
QColor blendColor() {
  return {0x4d, 0xe0, 0xe0};
}
QColor influenceColor() {
  return {0xc0, 0x8c, 0xff};
}
QColor originColor() {
  return {0xff, 0x5f, 0xd2};
}
QColor idleColor() {
  return {0xe8, 0xe8, 0xe8};
}
QColor ghostColor() {
  return {0x6d, 0xe8, 0x7a};
}
QColor haloColor() {
  return {0x10, 0x12, 0x16};
}

}  // namespace boxprobe
