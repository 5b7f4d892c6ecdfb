// A step's picture of what a probe holds: mip levels of its cubemap, or where in it pixels sample and where they
// should. Called by the lesson photographer; needs a QGuiApplication for its letters, no window.
#pragma once

#include <QImage>

#include "app/lessons/lesson_player.h"

namespace boxprobe {

/// Of the first probe of the scene that the player shows. Throws WorkError where it has none, or not that level.
/// Levels: those of the lesson's face as seen from within the cube, texels as squares; the program's above, plain means
/// below. Lookups: the capture as a latitude-longitude map, made pale; a dot where a pixel samples, a ring where it
/// should by the captured distances, and a line between the two.
QImage mapPicture(const LessonMap& map, LessonPlayer& player, int width, int height);

}  // namespace boxprobe
