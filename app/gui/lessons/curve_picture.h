// A step's curve as a picture: one measure over a number of the scene, with a second one as its cost. Called by the
// lesson photographer; needs a QGuiApplication for its letters, no window.
#pragma once

#include <QImage>
#include <string>

#include "app/lessons/lesson_player.h"

namespace boxprobe {

/// The values stand at equal distances, whatever lies between them. Both axes start at 0.
QImage curvePicture(const LessonCurve& curve, const CurvePoints& points, int width, int height);

/// The same as an <svg> for a page: its colours are those of the page's theme (classes of data/web/page.css). `title`
/// is read aloud.
std::string curveSvg(const LessonCurve& curve, const CurvePoints& points, const std::string& title);

}  // namespace boxprobe
