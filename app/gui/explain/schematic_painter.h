// Paints plan and elevation of a pixel's projection: lines, arrows, labels that keep clear of each other. Called by the
// inset; the geometry comes from filters/explain/schematic.h. Everything is measured in logical pixels, so that it is
// crisp at any resolution of the screen.
#pragma once

#include <QRectF>
#include <QSizeF>
#include <QString>

#include "filters/explain/schematic.h"

class QPainter;

namespace boxprobe {

void paintSchematic(QPainter& painter, const QRectF& area, const Schematic& schematic);

/// Of one view alone, at most as large as `most`, by the painter's font.
QSizeF insetSize(const QPainter& painter, const SchematicView& view, const QSizeF& most);
/// On an area of that size, under a line of words.
void paintInset(QPainter& painter, const QRectF& area, const SchematicView& view, const QString& words);

}  // namespace boxprobe
