// See handle_words.h.
#include "app/gui/handles/handle_words.h"

#include <QCoreApplication>

#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

namespace {

QString words(const char* text) {
  return handleWords(text);
}

QString axisLetter(const Handle& handle) {
  return QString("XYZ"[handle.face.axis]);
}

}  // namespace

QString handleWords(const char* text) {
  return QCoreApplication::translate("Handles", text);
}

QString handleHint(const Handle& handle, const Probe& probe, bool selected) {
  const QString name = QString::fromStdString(probe.name), face = faceName(handle.face);
  const QString keys = words(" Shift: finely. Ctrl: onto the wall under the pointer, or the grid. Alt: both sides.");
  switch (handle.kind) {
    case HandleKind::Face:
      return words("Drag to move face %1 of %2.").arg(face, name) + keys;
    case HandleKind::Influence:
      return words("Drag to move face %1 of the influence box of %2.").arg(face, name) + keys;
    case HandleKind::Blend:
      return words("Drag to set over what distance %2 fades towards %1.").arg(face, name) + keys;
    case HandleKind::OriginAxis:
      return words("Drag to move the capture origin of %2 along %1. Shift: finely. Ctrl: grid.")
          .arg(axisLetter(handle), name);
    case HandleKind::Move:
      return words("Drag to move all of %2 along its %1. Shift: finely. Ctrl: grid.").arg(axisLetter(handle), name);
    case HandleKind::Turn:
      return words("Drag to turn all of %2 about its %1. Shift: finely. Ctrl: by 15 degrees.")
          .arg(axisLetter(handle), name);
    case HandleKind::Origin:
      break;
  }
  if (!selected) return words("Click to select probe %1. Ctrl: beside those that are selected.").arg(name);
  return words("Drag to move the capture origin of %1. X, Y, Z: along that axis. Shift: finely. Ctrl: grid.").arg(name);
}

QString handleEditLabel(const Handle& handle, const QString& name) {
  const QString face = faceName(handle.face);
  switch (handle.kind) {
    case HandleKind::Face:
      return words("Move face %1 of %2").arg(face, name);
    case HandleKind::Influence:
      return words("Move influence face %1 of %2").arg(face, name);
    case HandleKind::Blend:
      return words("Set blend distance %1 of %2").arg(face, name);
    case HandleKind::Move:
      return words("Move %1").arg(name);
    case HandleKind::Turn:
      return words("Turn %1").arg(name);
    case HandleKind::Origin:
    case HandleKind::OriginAxis:
      break;
  }
  return words("Move origin of %1").arg(name);
}

}  // namespace boxprobe
