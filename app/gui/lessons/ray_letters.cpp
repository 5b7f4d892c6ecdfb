// See ray_letters.h.
#include "app/gui/lessons/ray_letters.h"

#include <QPainter>

#include "app/gui/explain/picture_inset.h"

namespace boxprobe {

namespace {

/// `offset`: of its middle from the place.
void letter(QPainter& painter, const std::optional<glm::dvec2>& place, const QPointF& offset, const char* text) {
  if (place) paintPictureLetter(painter, QPointF(place->x, place->y) + offset, text);
}

}  // namespace

void drawRayLetters(QImage& picture, const Explanation& explanation, const ViewProjection& view) {
  if (!explanation.hit || explanation.dominant < 0) return;
  const ProbeExplanation& probe = explanation.probes[static_cast<std::size_t>(explanation.dominant)];
  if (!probe.hitDistance) return;
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const glm::dvec3& from = explanation.surface.positionWorld;
  // Below its middle: there the handle of a face often stands.
  const glm::dvec3 along = from + 0.42 * (probe.hitWorld - from), lookup = 0.5 * (probe.originWorld + probe.hitWorld);
  letter(painter, view.pixel(from), {-20, 8}, "P");
  letter(painter, view.pixel(along), {20, 0}, "R");
  letter(painter, view.pixel(probe.hitWorld), {22, -8}, "H");
  letter(painter, view.pixel(probe.originWorld), {-20, -6}, "C");
  letter(painter, view.pixel(lookup), {0, -22}, "H − C");
}

}  // namespace boxprobe
