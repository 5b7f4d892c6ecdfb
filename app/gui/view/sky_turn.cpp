// See sky_turn.h.
#include "app/gui/view/sky_turn.h"

#include <cmath>
#include <variant>

#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"

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

SkyTurn::SkyTurn(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  constexpr double kStep = 5.0;  // degrees a key press
  connect(workspace.actions().skyLeft, &QAction::triggered, this, [this] { turnBy(kStep); });
  connect(workspace.actions().skyRight, &QAction::triggered, this, [this] { turnBy(-kStep); });
  connect(&workspace.viewport(), &Viewport::skyTurned, this, &SkyTurn::drag);
  connect(&workspace.viewport(), &Viewport::skyTurnEnded, this, &SkyTurn::endDrag);
}

// A colour, or one above another, looks the same turned.
bool SkyTurn::hasPicture() {
  if (std::holds_alternative<SkyImage>(workspace_.editor().scene().sky)) return true;
  emit workspace_.message(tr("The sky has no picture that could be turned"));
  return false;
}

void SkyTurn::turnBy(double degrees) {
  if (!hasPicture()) return;
  workspace_.editor().commit(tr("Turn the sky"),
                             turnedTo(shownDegrees(workspace_.editor().scene().skyRotationDegrees + degrees)));
}

void SkyTurn::drag(double degrees) {
  if (!before_) {
    if (!hasPicture()) return;
    before_ = workspace_.editor().scene().skyRotationDegrees;
  }
  turned_ = shownDegrees(*before_ + degrees);
  workspace_.editor().preview({this}, tr("Turn the sky"), turnedTo(turned_));
}

void SkyTurn::endDrag() {
  if (!before_) return;
  before_.reset();
  workspace_.editor().commit({this}, tr("Turn the sky"), turnedTo(turned_));
}

}  // namespace boxprobe
