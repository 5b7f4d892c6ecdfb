// What is on the screen, and by how much two pictures differ.
#pragma once

#include <QImage>
#include <QRect>

namespace boxprobe {

class Viewport;

/// The viewport as it was last drawn.
QImage shownPicture(Viewport& viewport);

/// Share of the pixels, 0..1, that differ by more than `tolerance` of 255 in a channel.
double differingShare(const QImage& a, const QImage& b, int tolerance = 8);

/// Pixels within `radius` of the segment whose colour is within `tolerance` of `color` in every channel.
int pixelsNear(const QImage& image, const QPointF& from, const QPointF& to, double radius, const QColor& color,
               int tolerance);

}  // namespace boxprobe
