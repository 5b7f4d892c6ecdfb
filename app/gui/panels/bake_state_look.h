// How far a probe's maps are, as a coloured mark and a line of text: the same in the list and in the bake panel. Called
// by both; knows no renderer.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

#include "filters/core/scene/scene.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

struct BakeStateLook {
  QString text;
  QColor color;
  bool filled = true;  ///< a ring where there is nothing to see yet: told apart without colour
  bool operator==(const BakeStateLook& o) const { return text == o.text && color == o.color && filled == o.filled; }
  bool operator!=(const BakeStateLook& o) const { return !(*this == o); }
};

/// `stopped`: nothing is being made until someone asks for it.
BakeStateLook bakeStateLook(const Probe& probe, BakeState state, bool stopped);
QIcon stateIcon(const BakeStateLook& look);

}  // namespace boxprobe
