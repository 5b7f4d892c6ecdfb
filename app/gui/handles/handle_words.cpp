// See handle_words.h.
#include "app/gui/handles/handle_words.h"

#include <QCoreApplication>

#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

namespace {

/// What handle_readout.cpp says in the picture, for lupdate.
[[maybe_unused]] constexpr const char* kReadouts[] = {QT_TRANSLATE_NOOP("Handles", "size %1 × %2 × %3 %4"),
                                                      QT_TRANSLATE_NOOP("Handles", "influence %1  %2 %3"),
                                                      QT_TRANSLATE_NOOP("Handles", "blend %1  %2 %3"),
                                                      QT_TRANSLATE_NOOP("Handles", "moved by %1 %2"),
                                                      QT_TRANSLATE_NOOP("Handles", "rotation\n%1°  %2°  %3°"),
                                                      QT_TRANSLATE_NOOP("Handles", "origin\n%1  %2  %3 %4"),
                                                      QT_TRANSLATE_NOOP("Handles", "steps of %1°"),
                                                      QT_TRANSLATE_NOOP("Handles", "on the wall under the pointer"),
                                                      QT_TRANSLATE_NOOP("Handles", "on the wall ahead"),
                                                      QT_TRANSLATE_NOOP("Handles", "grid %1 %2")};

QString axisLetter(const Handle& handle) {
  return QString("XYZ"[handle.face.axis]);
}

}  // namespace

QString handleWords(const char* text) {
  return QCoreApplication::translate("Handles", text);
}

QString handleHint(const Handle& handle, const Probe& probe, bool selected) {
  const QString name = QString::fromStdString(probe.name), face = faceName(handle.face);
  const QString keys = QCoreApplication::translate(
      "Handles", " Shift: finely. Ctrl: onto the wall under the pointer, or the grid. Alt: both sides.");
  switch (handle.kind) {
    case HandleKind::Face:
      return QCoreApplication::translate("Handles", "Drag to move face %1 of %2.").arg(face, name) + keys;
    case HandleKind::Influence:
      return QCoreApplication::translate("Handles", "Drag to move face %1 of the influence box of %2.")
                 .arg(face, name) +
             keys;
    case HandleKind::Blend:
      return QCoreApplication::translate("Handles", "Drag to set over what distance %2 fades towards %1.")
                 .arg(face, name) +
             keys;
    case HandleKind::OriginAxis:
      return QCoreApplication::translate("Handles",
                                         "Drag to move the capture origin of %2 along %1. Shift: finely. Ctrl: grid.")
          .arg(axisLetter(handle), name);
    case HandleKind::Move:
      return QCoreApplication::translate("Handles", "Drag to move all of %2 along its %1. Shift: finely. Ctrl: grid.")
          .arg(axisLetter(handle), name);
    case HandleKind::Turn:
      return QCoreApplication::translate("Handles",
                                         "Drag to turn all of %2 about its %1. Shift: finely. Ctrl: by 15 degrees.")
          .arg(axisLetter(handle), name);
    case HandleKind::Origin:
      break;
  }
  if (!selected)
    return QCoreApplication::translate("Handles", "Click to select probe %1. Ctrl: beside those that are selected.")
        .arg(name);
  return QCoreApplication::translate(
             "Handles", "Drag to move the capture origin of %1. X, Y, Z: along that axis. Shift: finely. Ctrl: grid.")
      .arg(name);
}

QString handleEditLabel(const Handle& handle, const QString& name) {
  const QString face = faceName(handle.face);
  switch (handle.kind) {
    case HandleKind::Face:
      return QCoreApplication::translate("Handles", "Move face %1 of %2").arg(face, name);
    case HandleKind::Influence:
      return QCoreApplication::translate("Handles", "Move influence face %1 of %2").arg(face, name);
    case HandleKind::Blend:
      return QCoreApplication::translate("Handles", "Set blend distance %1 of %2").arg(face, name);
    case HandleKind::Move:
      return QCoreApplication::translate("Handles", "Move %1").arg(name);
    case HandleKind::Turn:
      return QCoreApplication::translate("Handles", "Turn %1").arg(name);
    case HandleKind::Origin:
    case HandleKind::OriginAxis:
      break;
  }
  return QCoreApplication::translate("Handles", "Move origin of %1").arg(name);
}

}  // namespace boxprobe
