// The report on scenes as one HTML file without anything outside it: pictures stand in it as data, no address is asked.
// Called by `boxprobe report` and the window.
#pragma once

#include <optional>
#include <string>

#include "app/session/scene_review.h"

namespace boxprobe {

struct ReviewPageSettings {
  std::string command;              ///< that makes the same page, shown in it
  std::optional<double> failAbove;  ///< relative RMSE above which a camera fails
  ReviewSettings review;            ///< of the pictures
};

/// How well the box fits, as one clause: "fits: mean error 0.42°".
std::string fitVerdict(const BoxFit& fit);

/// The traced picture's noise is larger than what is measured by it.
bool tooNoisy(const PartError& error);

class ReviewPage {
 public:
  explicit ReviewPage(ReviewPageSettings settings) : settings_(std::move(settings)) {}

  void add(const SceneReview& review);
  /// The whole file.
  std::string text() const;

 private:
  ReviewPageSettings settings_;
  std::string names_, rows_, sections_;
  std::size_t scenes_ = 0, cameras_ = 0, failed_ = 0;
};

}  // namespace boxprobe
