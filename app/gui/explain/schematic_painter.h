// Paints plan and elevation of a pixel's projection: lines, arrows, labels that keep clear of each other. Called by the
// inset; the geometry comes from filters/explain/schematic.h. Everything is measured in logical pixels, so that it is
// crisp at any resolution of the screen.
#pragma once

#include <QRectF>

#include "filters/explain/schematic.h"

class QPainter;

namespace boxprobe {

void paintSchematic(QPainter& painter, const QRectF& area, const Schematic& schematic);

}  // namespace boxprobe
