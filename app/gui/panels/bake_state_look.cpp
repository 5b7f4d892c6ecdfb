// See bake_state_look.h.
#include "app/gui/panels/bake_state_look.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPainter>
#include <QPixmap>

#include "app/gui/widgets/axis_colors.h"

namespace boxprobe {

namespace {

const QColor kGood(0x6c, 0xc2, 0x6c), kWaiting(0xff, 0xb3, 0x1a), kBusy(0x5a, 0xb0, 0xff), kUnused(0x85, 0x8a, 0x92);

QString goodText(const Probe& probe) {
  if (probe.mode == ProbeMode::Realtime) return QCoreApplication::translate("BakeState", "Follows the scene");
  if (probe.mode == ProbeMode::Custom) {
    return QCoreApplication::translate("BakeState", "Custom image %1")
        .arg(QFileInfo(QString::fromStdString(probe.image)).fileName());
  }
  return QCoreApplication::translate("BakeState", "Up to date");
}

}  // namespace

BakeStateLook bakeStateLook(const Probe& probe, BakeState state, bool stopped) {
  const bool custom = probe.mode == ProbeMode::Custom;
  switch (state) {
    case BakeState::NotUsed:
      return {QCoreApplication::translate("BakeState", "Not used: its influence box reaches no visible object"),
              kUnused, false};
    case BakeState::Stale:
      if (stopped)
        return {QCoreApplication::translate("BakeState", "Out of date: capturing was stopped"), kWaiting, false};
      return {custom ? QCoreApplication::translate("BakeState", "Waiting for an image")
                     : QCoreApplication::translate("BakeState", "Out of date: waiting for capture"),
              kWaiting, false};
    case BakeState::Capturing:
      if (probe.mode == ProbeMode::Realtime)
        return {QCoreApplication::translate("BakeState", "Follows the scene"), kBusy, true};
      return {stopped  ? QCoreApplication::translate("BakeState", "Out of date: capturing was stopped")
              : custom ? QCoreApplication::translate("BakeState", "Filtering the image")
                       : QCoreApplication::translate("BakeState", "Capturing"),
              stopped ? kWaiting : kBusy, !stopped};
    case BakeState::UpToDate:
      return {goodText(probe), kGood, true};
    case BakeState::FromFile:
      return {QCoreApplication::translate("BakeState", "Loaded from disk, up to date"), kGood, true};
  }
  return {};
}

QIcon stateIcon(const BakeStateLook& look) {
  constexpr int kSize = 16;
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  // A dark rim: seen before light, dark and the selection's colour.
  painter.setPen(QPen(haloColor(), 4.0));
  painter.drawEllipse(QRectF(4.0, 4.0, 8.0, 8.0));
  painter.setPen(QPen(look.color, 2.0));
  painter.setBrush(look.filled ? QBrush(look.color) : QBrush(Qt::NoBrush));
  painter.drawEllipse(QRectF(4.0, 4.0, 8.0, 8.0));
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);  // else Qt tints it with the selection's colour
  return icon;
}

}  // namespace boxprobe
