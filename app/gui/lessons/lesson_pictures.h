// A lesson's steps as pictures, with rays and boxes where a step has them, and its claims as measured. Called by the
// sheet and the page; shows no window.
#pragma once

#include <QImage>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/lessons/lesson_player.h"

namespace boxprobe {

class ProbeOverlay;

struct LessonPictures {
  std::vector<QImage> steps;
  struct Claim {
    std::string say;
    std::string measured;  ///< "0.21, which is 9.8 times 0.0215"
    bool holds = false;
  };
  std::vector<Claim> claims;
};

/// One for many lessons: its window and programs are used again. `quiet`: without VTK's warnings.
class LessonPhotographer {
 public:
  LessonPhotographer(int width, int height, std::function<bool()> goOn = {}, bool quiet = false);
  ~LessonPhotographer();
  /// Throws InputError for a scene that cannot be read, WorkError if stopped.
  LessonPictures take(const Lesson& lesson);
  LessonPlayer& player() { return player_; }

 private:
  QImage picture(const LessonStep& step);
  int width_, height_;
  LessonPlayer player_;
  std::unique_ptr<ProbeOverlay> boxes_;
};

/// "0.21, and 5 times 0.0215 is 0.107": what was found beside what it is held against.
std::string claimText(const LessonClaim& claim, const ClaimResult& result);

}  // namespace boxprobe
