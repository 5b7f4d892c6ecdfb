// See sky_turn.h.
#include "app/gui/view/sky_turn.h"

#include <cmath>
#include <variant>

namespace boxprobe {

namespace {

// -180 to 180, to a tenth of a degree as the field shows it.
double shownDegrees(double degrees) {
  return std::remainder(std::round(degrees * 10.0) / 10.0, 360.0);
}

Document::Edit turnedTo(double degrees) {
  return [degrees](Scene& scene) { scene.skyRotationDegrees = degrees; };
}

}  // namespace

// A colour, or one above another, looks the same turned.
bool SkyTurn::hasPicture() {
  if (std::holds_alternative<SkyImage>(editor_.scene().sky)) return true;
  emit message(tr("The sky has no picture that could be turned"));
  return false;
}

void SkyTurn::turnBy(double degrees) {
  if (!hasPicture()) return;
  editor_.commit(tr("Turn the sky"), turnedTo(shownDegrees(editor_.scene().skyRotationDegrees + degrees)));
}

void SkyTurn::drag(double degrees) {
  if (!before_) {
    if (!hasPicture()) return;
    before_ = editor_.scene().skyRotationDegrees;
  }
  turned_ = shownDegrees(*before_ + degrees);
  editor_.preview({this}, tr("Turn the sky"), turnedTo(turned_));
}

void SkyTurn::endDrag() {
  if (!before_) return;
  before_.reset();
  editor_.commit({this}, tr("Turn the sky"), turnedTo(turned_));
}

}  // namespace boxprobe
