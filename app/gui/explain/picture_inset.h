// A lesson's inset: in a corner of a picture, from above or from the side, where the ray of one of its pixels goes, and
// a P at that pixel. One drawing for sheets, pages and the window. Called by the lesson photographer and the lesson
// stage; the geometry comes from filters/explain/schematic.h.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <functional>
#include <optional>

#include "filters/core/scene/lesson.h"
#include "filters/explain/schematic.h"

class QPainter;

namespace boxprobe {

/// A slanted letter with a rim, its middle at `middle`, pixels: legible on any picture.
void paintPictureLetter(QPainter& painter, const QPointF& middle, const char* text);

/// `picture`: all of it, pixels. Does not mark the pixel.
void paintPictureInset(QPainter& painter, const QRectF& picture, const LessonInset& inset, const SchematicView& view);
/// A dot and the letter P.
void paintInsetPlace(QPainter& painter, const QPointF& place);

/// The inset over the window's picture. Takes no mouse.
class PictureInset : public QWidget {
 public:
  /// `explain`: of the pixel at a place of the parent, logical pixels, as its picture is now.
  PictureInset(QWidget* parent, std::function<Explanation(const QPointF&)> explain);

  /// Nothing: it is hidden, and explains nothing.
  void show(const std::optional<LessonInset>& inset);
  /// Another ray may start at the place.
  void invalidate() { stale_ = true; }
  /// The picture was drawn, `place` being the inset's in it: explained once after each change.
  void update(const QPointF& place);
  const std::optional<SchematicView>& view() const { return view_; }  ///< what it shows

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<Explanation(const QPointF&)> explain_;
  std::optional<LessonInset> inset_;
  std::optional<SchematicView> view_;
  QPointF place_;
  bool stale_ = false;
};

}  // namespace boxprobe
