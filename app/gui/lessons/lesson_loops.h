// Short films without sound for a page of lessons: a scene that moves to and fro, drawn by the lesson photographer and
// encoded as WebM (VP9) by ffmpeg, an external program: one Debian package in every release, needed by whoever makes
// the loops alone, and it writes the container as well. Called by `boxprobe lessons --loops`.
#pragma once

#include <QImage>
#include <functional>
#include <string>
#include <vector>

#include "app/gui/lessons/lesson_pictures.h"
#include "app/lessons/page_widgets.h"

namespace boxprobe {

constexpr int kLoopRate = 20;                  // pictures a second
constexpr std::size_t kLargestLoop = 1000000;  // bytes

/// Throws InputError if there is no ffmpeg that encodes VP9: with what to install.
void requireLoopEncoder();

/// All pictures of the loop, the first one once. The scene goes and comes back by the same pictures. `drawn` is told
/// the share that is done. Throws InputError for a field or step that the lesson does not have, WorkError if stopped.
std::vector<QImage> drawLoop(LessonPhotographer& photographer, const Lesson& lesson, const LessonLoop& loop,
                             const std::function<void(double)>& drawn);

/// Writes `path` (see writeAtomically), at most kLargestLoop bytes: less sharp, where need be. Throws WorkError with
/// what ffmpeg said.
void encodeLoop(const std::vector<QImage>& pictures, const std::string& path);

}  // namespace boxprobe
