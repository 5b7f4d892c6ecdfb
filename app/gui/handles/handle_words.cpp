// See handle_words.h.
#include "app/gui/handles/handle_words.h"

#include <QCoreApplication>
#include <glm/geometric.hpp>

#include "app/gui/handles/handle_picking.h"

namespace boxprobe {

namespace {

QString words(const char* text) {
  return QCoreApplication::translate("Handles", text);
}

QString inMetres(double value) {
  return QString::number(value, 'f', 3);
}

QString sizeText(const Box& box) {
  const glm::dvec3 size = box.size();
  return words("size %1 × %2 × %3 m").arg(inMetres(size.x), inMetres(size.y), inMetres(size.z));
}

QString placeText(const QString& what, const glm::dvec3& p) {
  return words("%1\n%2  %3  %4 m").arg(what, inMetres(p.x), inMetres(p.y), inMetres(p.z));
}

double sideOf(const Box& box, const BoxFace& face) {
  return face.positive ? box.max[face.axis] : box.min[face.axis];
}

QString axisLetter(const Handle& handle) {
  return QString("XYZ"[handle.face.axis]);
}

}  // namespace

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

QString handleReadout(const Handle& handle, const Probe& before, const Probe& now) {
  const QString face = faceName(handle.face);
  switch (handle.kind) {
    case HandleKind::Face:
      return words("%1  %2 m\n").arg(face, inMetres(sideOf(now.box, handle.face))) + sizeText(now.box);
    case HandleKind::Influence:
      return words("influence %1  %2 m\n").arg(face, inMetres(sideOf(now.influenceBox(), handle.face))) +
             sizeText(now.influenceBox());
    case HandleKind::Blend: {
      const glm::dvec3& distances = handle.face.positive ? now.blendDistance.max : now.blendDistance.min;
      return words("blend %1  %2 m").arg(face, inMetres(distances[handle.face.axis]));
    }
    case HandleKind::Move:
      return words("moved by %1 m").arg(inMetres(glm::length(now.origin - before.origin)));
    case HandleKind::Turn: {
      const glm::dvec3& r = now.rotationDegrees;
      return words("rotation\n%1°  %2°  %3°").arg(r.x, 0, 'f', 1).arg(r.y, 0, 'f', 1).arg(r.z, 0, 'f', 1);
    }
    case HandleKind::Origin:
    case HandleKind::OriginAxis:
      break;
  }
  return placeText(words("origin"), now.origin);
}

QString snapWords(const DragSnap& snap, const Handle& handle) {
  if (handle.kind == HandleKind::Turn) return words("steps of 15°");
  if (snap.target() == SnapTarget::Pointed) return words("on the wall under the pointer");
  if (snap.target() == SnapTarget::Opposite) return words("on the wall ahead");
  return words("grid %1 m").arg(snap.gridStep());
}

}  // namespace boxprobe
