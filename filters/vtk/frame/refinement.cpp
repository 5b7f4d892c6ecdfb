// See refinement.h.
#include "filters/vtk/frame/refinement.h"

#include <algorithm>
#include <cmath>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

// Fewer are noisier than what they replace is wrong.
constexpr int kFirstStage = 64, kTimes = 4;
// Few enough that a frame does not delay the next camera movement.
constexpr int kMostAFrame = 8;
// A stage with 4 times the rays has about half of the error of the previous one; the remaining error then equals their
// difference, and is larger where both miss the same light.
constexpr double kLeftOfChange = 1.2;
// Of the difference between a quarter of a stage and all of it, which has about twice its noise.
constexpr double kLeftOfPart = 0.4;
constexpr double kEvenness = 1.5;

// Omits stages that would be worse than the frame they replace: as many rays may miss a small lamp by more than a frame
// that is worth them. Its frames grow into the picture all the same.
std::vector<int> stagesTo(int rays, int firstGuess) {
  std::vector<int> stages;
  int first = kFirstStage;
  while (first <= firstGuess) first *= kTimes;
  for (int n = first; n < rays; n *= kTimes) stages.push_back(n);
  if (rays > 0) stages.push_back(rays);
  return stages;
}

int framesOf(int rays) {
  const int aFrame = std::clamp(rays / 4, 1, kMostAFrame);
  return (rays + aFrame - 1) / aFrame;
}

double shown(double light) {
  return 255.0 * static_cast<double>(shading::srgbEncoded(static_cast<float>(std::clamp(light, 0.0, 1.0))));
}

}  // namespace

void Refinement::begin(const RefineSettings& settings, int firstGuess) {
  settings_ = settings;
  stages_ = stagesTo(settings.rays, firstGuess);
  stage_ = 0;
  left_ = -1.0;
}

// The technique's own frame is of another kind: the first stage's change does not predict the remaining error.
void Refinement::endStage(const PictureChange& change, const PictureChange& within) {
  const bool first = stage_ == 0;
  if (!first) left_ = kLeftOfChange * change.relativeRms;
  if (within.relativeRms > 0.0) left_ = kLeftOfPart * within.relativeRms;
  ++stage_;
  const bool nothingShows = change.stepsOf8Bits < kNothingShows && settings_.until <= 0.0;
  const bool enough = settings_.until > 0.0 && left_ >= 0.0 && left_ <= settings_.until;
  if (nothingShows && first) left_ = 0.0;
  if (nothingShows || enough) stages_.resize(stage_);
}

RefinedRays Refinement::rays() const {
  if (!more()) return {};
  const int inAll = stages_[stage_], frames = framesOf(inAll);
  return {(inAll + frames - 1) / frames, inAll};
}

int Refinement::frames() const {
  return more() ? framesOf(stages_[stage_]) : 0;
}

double Refinement::share(int framesDone) const {
  if (!more()) return 1.0;
  const double all = frames(), done = std::min<double>(framesDone, all);
  // The technique's frame is wrong but smooth, and noise is seen first: rays count by their part of all.
  if (stage_ == 0) return done / all;
  const double before = stages_[stage_ - 1] / static_cast<double>(rays().aFrame);
  // By variance, which falls faster than the number of rays rises, since they are spread evenly.
  const double of = std::pow(done, kEvenness);
  return of / (of + std::pow(before, kEvenness) * (1.0 - done / all));
}

int Refinement::framesInAll() const {
  int sum = 1;
  for (const int stage : stages_) sum += framesOf(stage);
  return sum;
}

int Refinement::framesBefore() const {
  int sum = 1;
  for (std::size_t i = 0; i < stage_; ++i) sum += framesOf(stages_[i]);
  return sum;
}

PictureChange pictureChange(const std::vector<float>& before, const std::vector<float>& after, double exposure) {
  double squares = 0.0, changes = 0.0, allSquares = 0.0, allChanges = 0.0;
  std::vector<float> steps;
  const std::size_t pixels = std::min(before.size(), after.size()) / 4;
  steps.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    double most = 0.0, change = 0.0, square = 0.0;
    for (std::size_t c = 4 * i; c < 4 * i + 3; ++c) {
      const double a = before[c], b = after[c], difference = b - a;
      change += difference * difference;
      square += b * b;
      most = std::max(most, std::abs(shown(exposure * b) - shown(exposure * a)));
    }
    steps.push_back(static_cast<float>(most));
    allChanges += change;
    allSquares += square;
    // Pixels that rays hardly concern do not thin out the others: 0.3 % is less than a step of 8 bits.
    if (!(change > 1.0e-5 * square)) continue;
    changes += change;
    squares += square;
  }
  PictureChange result;
  if (steps.empty()) return result;
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() * 999 / 1000);
  std::nth_element(steps.begin(), at, steps.end());
  result.stepsOf8Bits = static_cast<double>(*at);
  if (squares > 0.0) result.relativeRms = std::sqrt(changes / squares);
  // So small a change everywhere is not none.
  if (squares <= 0.0 && allSquares > 0.0) result.relativeRms = std::sqrt(allChanges / allSquares);
  return result;
}

}  // namespace boxprobe
