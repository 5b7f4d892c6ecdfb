// See picture_check.h.
#include "app/session/picture_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "app/session/fit_scene.h"
#include "app/session/shared_work.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/core/scene/bounces.h"
#include "filters/fit/fit_model.h"
#include "filters/io/scene/scene_file.h"
#include "filters/reference/path/reference_path.h"
#include "filters/reference/trace/picture_rays.h"
#include "filters/reference/trace/scene_tracer.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

constexpr int kWidth = 48, kHeight = 27;
constexpr int kViewWidth = 96, kViewHeight = 54;                       // for people to look at
constexpr std::size_t kLeastEyes = 16, kMostEyes = 64, kRoomEyes = 2;  // at most; of each room, where there are many
constexpr std::size_t kMostParts = 4, kMostMoved = 4;
constexpr int kFaceSize = 64;           // of captures: sixteen times as fast as what is drawn later
constexpr std::size_t kMany = 16;       // probes: more are captured with at most kBouncesOfMany
constexpr int kBouncesOfMany = 4;       // all, 16 at most, would be up to four times the captures
constexpr double kGlossy = 4.0;         // weight: a wrong mirror is seen at once
constexpr double kWhite = 5.0;          // over the mean: lamps seen in mirrors would outweigh rooms
constexpr double kDim = 0.1;            // of the mean of all eyes: what is darker counts as that bright
constexpr double kNoisy = 0.5;          // of value and a tenth of white: what the truth does not know is left out
constexpr double kCertain = 0.1;        // of the light: with less that is known the truth tells nothing
constexpr double kBetter = 0.99;        // of the error: one trial over another
constexpr double kSurely = 0.95;        // over the scene's own probes, whatever single eyes say
constexpr double kAlike = 2.0;          // or the gain over its standard error, from eye to eye
constexpr std::size_t kFewestEyes = 6;  // of six, twice that error is what chance exceeds in 5 % (Student)
constexpr double kNoWorse = 1.005;      // without a probe: it is left out

std::string errorText(double error) {
  return decimalText(error, 3);
}

struct Eye {
  std::size_t number = 0;
  std::size_t room = 0;
  Camera camera;
  ReferencePicture truth;
  std::vector<float> weights;  ///< per pixel; 0: left out
  double white = 0.0;          ///< brighter counts as that
  bool judges = false;         ///< some pixel is neither left out nor too noisy
};

/// One, or at least so many.
int bouncesTried(int of, int bounces) {
  return bounces == 1 ? 1 : std::max(of, bounces);
}

Phrase bouncesText(int bounces) {
  return bounces == kAllBounces ? Phrase::tr("all") : Phrase::plain(std::to_string(bounces));
}

std::vector<Probe> withBounces(std::vector<Probe> probes, int bounces) {
  for (Probe& probe : probes) probe.bounces = bouncesTried(probe.bounces, bounces);
  return probes;
}

class Checker {
 public:
  Checker(const LoadedScene& loaded, Placement& placement, OffscreenScene& shown,
          const std::function<bool(double)>& progress, const PictureCheckSettings& settings)
      : loaded_(loaded),
        placement_(placement),
        shown_(shown),
        progress_(progress),
        settings_(settings),
        path_(loaded.scene, loaded.models, loadSkyImage(loaded.scene)),
        many_(std::max(placement.all().size(), loaded.scene.probes.size()) > kMany) {}

  std::optional<PictureCheck> check() {
    const auto begun = std::chrono::steady_clock::now();
    if (!look()) return std::nullopt;
    check_.eyes = eyes_.size();
    if (placement_.rooms.empty()) return check_;
    if (eyes_.empty() || !(mean_ > 0.0) || !measurable()) {
      check_.sentences.push_back(
          eyes_.empty() ? Phrase::tr("pictures were not compared: nobody can stand in these rooms")
          : !surfaces_  ? Phrase::tr("pictures were not compared: only lamps and unlit surfaces are seen")
          : mean_ > 0.0
              ? Phrase::tr("pictures were not compared: the light that reaches the rooms is too little to tell "
                           "it from noise")
              : Phrase::tr("pictures were not compared: the scene has no light"));
      check_.better = true;
      return check_;
    }
    if (many_) {
      check_.sentences.push_back(
          Phrase::tr("pictures of more than %1 probes were compared with at most %2 bounces of light")
              .arg(std::to_string(kMany))
              .arg(std::to_string(kBouncesOfMany)));
    }
    expected_ = trialsExpected();
    if (!choose()) return std::nullopt;
    placement_.rate();
    tellRooms();
    if (settings_.views && check_.better && !lookCloser()) return std::nullopt;
    check_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return check_;
  }

 private:
  bool report(double done) const { return !progress_ || progress_(done); }

  /// Probes as they are measured: with small captures, which show the same errors. All trials use the same ones, so
  /// that their errors compare.
  std::vector<Probe> measured(std::vector<Probe> probes) const {
    for (Probe& probe : probes) {
      if (probe.mode == ProbeMode::Custom) continue;
      probe.faceSize = std::min(probe.faceSize, kFaceSize);
      probe.samplesPerPixel = 1;
      probe.filterSamples = std::min(probe.filterSamples, 32);
      if (many_) probe.bounces = std::min(probe.bounces, kBouncesOfMany);
    }
    return probes;
  }

  /// An estimate: what is chosen on the way decides how many follow. More share the last part of the bar.
  double trialsExpected() const {
    const std::vector<PlacedProbe>& placed = placement_.probes;
    const auto parts = static_cast<std::size_t>(
        std::count_if(placed.begin(), placed.end(), [](const PlacedProbe& each) { return each.part; }));
    std::size_t moves = 3;  // of many at once
    if (placed.size() <= kMostMoved) {
      moves = 0;
      for (const PlacedProbe& each : placed) moves += each.part ? 0 : placement_.rooms[each.room].origins.size();
    }
    const std::size_t own = loaded_.scene.probes.empty() ? 0 : 1, boxes = placement_.kept.empty() ? 2 : 0;
    return static_cast<double>(placed.empty() ? 1 + own : 3 + own + boxes + std::min(parts, kMostParts) + moves);
  }

  /// The eyes of rooms with probes in turn, the first ones of all rooms first; then one of each other room.
  std::vector<std::pair<std::size_t, Camera>> cameras() const {
    std::vector<bool> lit(placement_.rooms.size(), placement_.probes.empty());
    for (const PlacedProbe& placed : placement_.probes) lit[placed.room] = lit[placed.room] || !placed.surroundings;
    const auto rooms = static_cast<std::size_t>(std::count(lit.begin(), lit.end(), true));
    const std::size_t most = std::clamp(kRoomEyes * rooms, kLeastEyes, kMostEyes);
    std::vector<std::pair<std::size_t, Camera>> cameras;
    const auto add = [&](bool withProbes, std::size_t turn) {
      bool any = false;
      for (std::size_t i = 0; i < placement_.rooms.size(); ++i) {
        if (lit[i] != withProbes || turn >= placement_.rooms[i].eyes.size()) continue;
        any = true;
        if (cameras.size() < most) cameras.emplace_back(i, placement_.rooms[i].eyes[turn]);
      }
      return any;
    };
    for (std::size_t turn = 0; add(true, turn); ++turn) {
    }
    add(false, 0);
    return cameras;
  }

  bool look() {
    const std::vector<std::pair<std::size_t, Camera>> cameras = this->cameras();
    const SceneTracer tracer(makeTriangleScene(loaded_.scene, loaded_.models));
    for (const TracedObject& object : tracer.scene().objects) {
      for (const glm::vec3& position : object.positions) {
        const glm::dvec3 world = tracer.scene().anchorWorld + glm::dvec3(position);
        model_ = {glm::min(model_.min, world), glm::max(model_.max, world)};
      }
    }
    std::vector<double> sums, counts;
    const SharedWork* shared = settings_.shared;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      if (shared != nullptr && shared->sharing() && !shared->mine(i)) continue;
      Eye eye{i, cameras[i].first, cameras[i].second, traced(i, cameras), {}, 0.0, false};
      if (!eye.truth.complete) return false;
      const PictureRays rays(cameras[i].second, kWidth, kHeight);
      double sum = 0.0, count = 0.0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          eye.weights.push_back(weightOf(tracer, rays.origin(x + 0.5, y + 0.5), rays.direction(x + 0.5, y + 0.5)));
          if (!(eye.weights.back() > 0.0f)) continue;
          for (std::size_t c = 0; c < 3; ++c) sum += eye.truth.color.pixels[4 * (eye.weights.size() - 1) + c];
          count += 3.0;
        }
      }
      eyes_.push_back(std::move(eye));
      sums.push_back(sum);
      counts.push_back(count);
    }
    const double count = std::accumulate(counts.begin(), counts.end(), 0.0);
    surfaces_ = count > 0.0;
    mean_ = surfaces_ ? std::accumulate(sums.begin(), sums.end(), 0.0) / count : 0.0;
    for (std::size_t k = 0; k < eyes_.size(); ++k) {
      Eye& eye = eyes_[k];
      eye.white = kWhite * std::max(counts[k] > 0.0 ? sums[k] / counts[k] : 0.0, kDim * mean_);
      for (std::size_t i = 0; i < eye.weights.size() && !eye.judges; ++i) {
        eye.judges = eye.weights[i] > 0.0f && !noisy(eye, i);
      }
    }
    return true;
  }

  /// Is most of the light more than its noise? Single rays that slip between the faces of closed rooms are none to
  /// judge by.
  bool measurable() const {
    double all = 0.0, certain = 0.0;
    for (const Eye& eye : eyes_) {
      for (std::size_t i = 0; i < eye.weights.size(); ++i) {
        if (!(eye.weights[i] > 0.0f)) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const double light = clamped(eye, eye.truth.color, i, c);
          all += light;
          if (!noisy(eye, i)) certain += light;
        }
      }
    }
    return certain > kCertain * all;
  }

  ReferencePicture traced(std::size_t i, const std::vector<std::pair<std::size_t, Camera>>& cameras) const {
    const std::string name = "eye-" + std::to_string(i + 1) + "-traced";
    if (settings_.shared != nullptr) {
      if (auto known = settings_.shared->findTraced(name, kWidth, kHeight)) return *std::move(known);
    }
    PathSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.raysPerPixel = settings_.paths;
    ReferencePicture picture = path_.render(cameras[i].second, settings, [&](double done) {
      return report(0.4 * (static_cast<double>(i) + done) / static_cast<double>(cameras.size()));
    });
    if (settings_.shared != nullptr && picture.complete) settings_.shared->keepTraced(name, picture);
    return picture;
  }

  static float weightOf(const SceneTracer& tracer, const glm::dvec3& from, const glm::dvec3& along) {
    const auto hit = tracer.firstHit(from, along);
    if (!hit) return 0.0f;
    const SurfacePoint surface = tracer.surface(*hit, from);
    if (tracer.object(*hit).material.unlit || surface.emissive != glm::vec3(0.0f)) return 0.0f;
    const bool coated = surface.coatStrength > 0.0f;
    const double roughness = coated ? surface.coatRoughness : surface.roughness;
    return static_cast<float>(coated || surface.metallic > 0.5f || roughness < 0.3 ? kGlossy : 1.0);
  }

  static double clamped(const Eye& eye, const ImageRgbaF& image, std::size_t i, std::size_t c) {
    return std::clamp(static_cast<double>(image.pixels[4 * i + c]), 0.0, eye.white);
  }

  static bool noisy(const Eye& eye, std::size_t i) {
    double noise = 0.0, bright = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      noise += eye.truth.standardError.pixels[4 * i + c];
      bright += clamped(eye, eye.truth.color, i, c) + 0.1 * eye.white;
    }
    return noise > kNoisy * bright;
  }

  /// Nothing if it was stopped.
  std::optional<PictureErrors> errorsWith(const std::vector<Probe>& probes) {
    const double share = (settings_.views ? 0.3 : 0.6) / expected_;
    const double from = 0.4 + share * std::min(trials_, expected_ - 1.0);
    trials_ += 1.0;
    Scene scene = loaded_.scene;
    scene.probes = measured(probes);
    double glossy = 0.0, glossyTruths = 0.0, sum = 0.0, truthSum = 0.0;
    squares_.assign(eyes_.size(), 0.0);
    noise_.assign(eyes_.size(), 0.0);
    const std::string trial = settings_.shared != nullptr ? ContentHash().add(sceneText(scene, "/")).text() : "";
    for (std::size_t k = 0; k < eyes_.size(); ++k) {
      const Eye& eye = eyes_[k];
      const auto onward = [&](double part) { return report(from + share * shareDone(k, eyes_.size(), part)); };
      const auto seen = onward(0.0) ? pictureOf(eye, scene, trial, onward) : std::nullopt;
      if (!seen) return std::nullopt;
      const ImageRgbaF& picture = *seen;
      double truths = 0.0, dim = 0.0;
      for (std::size_t i = 0; i < eye.weights.size(); ++i) {
        const double weight = eye.weights[i];
        if (!(weight > 0.0) || noisy(eye, i)) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const double p = clamped(eye, picture, i, c), t = clamped(eye, eye.truth.color, i, c);
          const double e = eye.truth.standardError.pixels[4 * i + c];
          squares_[k] += weight * (p - t) * (p - t);
          noise_[k] += weight * e * e;
          truths += weight * t * t;
          dim += weight * kDim * kDim * mean_ * mean_;
          sum += p;
          truthSum += t;
          if (weight < kGlossy) continue;
          glossy += (p - t) * (p - t) - e * e;
          glossyTruths += t * t;
        }
      }
      const double whole = std::max(truths, dim);
      if (!(whole > 0.0)) continue;
      squares_[k] /= whole;
      noise_[k] /= whole;
    }
    PictureErrors errors;
    errors.error = errorOf(squares_, [](const Eye&) { return true; });
    if (glossyTruths > 0.0) errors.glossy = std::sqrt(std::max(glossy, 0.0) / glossyTruths);
    if (truthSum > 0.0) errors.light = sum / truthSum;
    return errors;
  }

  /// The share of a trial's work that is done while picture `k` of `count` is being captured. The first picture asks
  /// for most captures; in large buildings it asks for those near it alone.
  static double shareDone(std::size_t k, std::size_t count, double part) {
    if (k == 0) return 0.5 * part;
    return 0.5 + 0.5 * (static_cast<double>(k - 1) + part) / static_cast<double>(count - 1);
  }

  /// Nothing if it was stopped. `trial`: fingerprint of the scene, if pictures are shared.
  std::optional<ImageRgbaF> pictureOf(const Eye& eye, const Scene& scene, const std::string& trial,
                                      const std::function<bool(double)>& onward) {
    const std::string name = "eye-" + std::to_string(eye.number + 1) + "-" + trial.substr(0, 16);
    if (settings_.shared != nullptr) {
      if (auto known = settings_.shared->findPicture(name, kWidth, kHeight)) return known;
    }
    shown_.show(scene, loaded_.models, {eye.camera});
    if (!shown_.capture(onward)) return std::nullopt;
    ImageRgbaF picture = shown_.renderer().renderLinear(kWidth, kHeight, 4);
    shown_.requireHealthy();
    if (settings_.shared != nullptr) settings_.shared->keepPicture(name, picture);
    return picture;
  }

  /// Of a bare model, whose one probe nobody has changed since.
  bool asOpened() const {
    const auto& fit = loaded_.fit;
    const std::vector<Probe>& own = loaded_.scene.probes;
    return fit && fit->box && own.size() == 1 && own.front().box == fit->box->probe.box &&
           own.front().bounces == (fit->kind == ModelKind::Interior ? kRoomBounces : 1);
  }

  /// What measured best, over the scene's own probes.
  bool surelyBetter(const PictureErrors& best, const PictureErrors& own) const {
    return best.error < kSurely * own.error || (isBetter(best, own) && eyesAgree(ownSquares_, bestSquares_));
  }

  static bool isBetter(const PictureErrors& errors, const PictureErrors& best) {
    return errors.error < kBetter * best.error;
  }

  /// What was measured last is the best so far.
  void take(const PictureErrors& errors, PictureErrors& best) {
    best = errors;
    bestSquares_ = squares_;
  }

  bool choose() {
    const std::vector<Probe>& own = loaded_.scene.probes;
    const auto before = errorsWith(own);
    if (!before) return false;
    ownSquares_ = bestSquares_ = squares_;
    check_.before = check_.after = *before;
    std::optional<PictureErrors> best;
    enum class Choice { Placed, OneBox, OwnWithBounces } choice = Choice::Placed;
    if (!placement_.probes.empty()) {
      best = errorsWith(placement_.all());
      bestSquares_ = squares_;
      if (!best || !tryBounces(*best) || !leaveOut(*best)) return false;
    }
    const bool both = placement_.indoorsAndOutdoors();
    // Mean light of a whole flat may be closer than that of a room that sees little of it.
    struct OneBox {
      Probe probe;
      Phrase tried, reason;
    };
    std::vector<OneBox> boxes;
    std::size_t chosenBox = 0;
    const auto outside = std::count_if(placement_.probes.begin(), placement_.probes.end(),
                                       [](const PlacedProbe& each) { return each.surroundings; });
    if (best && placement_.kept.empty() && !both) {
      if (placement_.probes.size() > 1 + static_cast<std::size_t>(outside)) {
        boxes.push_back({aroundAll(), Phrase::tr("one box around all rooms: error %1"),
                         Phrase::tr("one box around all rooms measured better than one for each")});
      }
      boxes.push_back({aroundModel(), Phrase::tr("one box around all of the model: error %1"),
                       Phrase::tr("one box around all of the model measured better than those of rooms")});
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto errors = errorsWith({boxes[i].probe});
      if (!errors) return false;
      check_.sentences.push_back(boxes[i].tried.arg(errorText(errors->error)));
      if (errors->error < kBetter * best->error) {
        best = *errors, choice = Choice::OneBox;
        chosenBox = i;
        bestSquares_ = squares_;
      }
    }
    std::vector<Probe> bounced = own;
    const bool acrossBoth = both && asOpened();  // nobody set that box by hand
    int bouncesOfOwn = 0;
    if (!own.empty() && placement_.kept.empty() && !acrossBoth) {
      for (const int bounces : {kRoomBounces, 1}) {
        if (bounces == 1 && !asOpened()) continue;  // what a person has chosen is not lowered
        const std::vector<Probe> others = withBounces(own, bounces);
        if (measured(others) == measured(own)) continue;
        const auto errors = errorsWith(others);
        if (!errors) return false;
        check_.sentences.push_back(Phrase::tr("the scene's own probes, bounces of light: %1; error %2")
                                       .arg(bouncesText(bounces))
                                       .arg(errorText(errors->error)));
        if (!best || errors->error < kBetter * best->error) {
          best = *errors, choice = Choice::OwnWithBounces;
          bounced = others;
          bouncesOfOwn = bounces;
          bestSquares_ = squares_;
        }
      }
    }
    if (choice == Choice::OneBox) {
      PlacedProbe one = placement_.probes.front();
      one.probe = boxes[chosenBox].probe;
      one.part = false;
      one.reason = boxes[chosenBox].reason;
      placement_.probes = {one};
    } else if (choice == Choice::OwnWithBounces) {
      placement_.probes.clear();
      placement_.kept = bounced;
      if (asOpened()) {  // it is nobody's own
        placement_.kept.clear();
        placement_.probes.push_back({bounced.front(), 0, false, 0.0, *loaded_.fit->box});
        placement_.probes.back().reason =
            Phrase::tr("fitted to all of the model, which measured better than its rooms");
      }
    }
    if (best && !moveOrigins(*best)) return false;
    check_.better = best && surelyBetter(*best, *before);
    if (!check_.better) {
      const Phrase none = own.empty()
                              ? Phrase::tr("no probe surely made the pictures better: none is proposed")
                              : Phrase::tr("nothing measured surely better than the scene's own probes, which stay");
      check_.sentences.push_back(none);
      placement_.probes.clear();
      placement_.kept = own;
      return true;
    }
    check_.after = *best;
    if (choice == Choice::OwnWithBounces && placement_.probes.empty()) {
      check_.sentences.push_back(
          Phrase::tr("the scene's own probes stay, bounces of light: %1").arg(bouncesText(bouncesOfOwn)));
    }
    return true;
  }

  /// Root mean square over the eyes that judge and for which `counts` is true, with the truth's noise taken off, which
  /// is the same for all pictures.
  template <class Counts>
  double errorOf(const std::vector<double>& squares, const Counts& counts) const {
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < eyes_.size(); ++k) {
      if (!eyes_[k].judges || !counts(eyes_[k])) continue;
      sum += squares[k] - noise_[k];
      count += 1.0;
    }
    return count > 0.0 ? std::sqrt(std::max(sum, 0.0) / count) : 0.0;
  }

  double roomError(std::size_t room, const std::vector<double>& squares) const {
    return errorOf(squares, [room](const Eye& eye) { return eye.room == room; });
  }

  double ofRoom(std::size_t room, const std::vector<double>& squares) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < eyes_.size(); ++i) sum += eyes_[i].room == room ? squares[i] : 0.0;
    return sum;
  }

  void tellRooms() {
    check_.rooms.resize(placement_.rooms.size());
    for (const Eye& eye : eyes_) {
      RoomErrors& room = check_.rooms[eye.room];
      room.seen = true;
      room.before = roomError(eye.room, ownSquares_);
      room.after = check_.better ? roomError(eye.room, bestSquares_) : room.before;
    }
  }

  /// The eye nearest to the middle of a probe's box, of those in its room.
  std::optional<std::size_t> eyeFor(const Probe& probe, std::optional<std::size_t> room) const {
    std::optional<std::size_t> best;
    double least = 1e300;
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
      if (room && eyes_[i].room != *room) continue;
      const double away = glm::length(eyes_[i].camera.position - probe.box.center());
      if (away < least) best = i, least = away;
    }
    return best;
  }

  /// Pictures for people: finer, and only those that show what is proposed.
  bool lookCloser() {
    std::vector<std::size_t> eyeOfView;
    const auto show = [&](const Probe& probe, std::optional<std::size_t> room) {
      const std::optional<std::size_t> eye = eyeFor(probe, room);
      if (!eye) return check_.viewOf.push_back(std::nullopt);
      const auto known = std::find(eyeOfView.begin(), eyeOfView.end(), *eye);
      check_.viewOf.emplace_back(static_cast<std::size_t>(known - eyeOfView.begin()));
      if (known == eyeOfView.end()) eyeOfView.push_back(*eye);
    };
    for (const Probe& probe : placement_.kept) show(probe, std::nullopt);
    for (const PlacedProbe& placed : placement_.probes) show(placed.probe, placed.room);
    for (const std::size_t i : eyeOfView) {
      const double done = static_cast<double>(check_.views.size()) / static_cast<double>(eyeOfView.size());
      const double step = 1.0 / static_cast<double>(eyeOfView.size());
      PathSettings path;
      path.width = kViewWidth;
      path.height = kViewHeight;
      path.raysPerPixel = std::max(settings_.paths / 2, 1);
      EyePictures view{eyes_[i].room, eyes_[i].camera, {}, {}, {}};
      const ReferencePicture truth =
          path_.render(view.camera, path, [&](double part) { return report(0.7 + 0.2 * (done + part * step)); });
      if (!truth.complete) return false;
      view.truth = truth.color;
      check_.views.push_back(std::move(view));
    }
    const auto draw = [&](const std::vector<Probe>& probes, ImageRgbaF EyePictures::*picture, double from) {
      Scene scene = loaded_.scene;
      scene.probes = measured(probes);
      for (std::size_t k = 0; k < check_.views.size(); ++k) {
        EyePictures& view = check_.views[k];
        const auto onward = [&](double part) { return report(from + 0.05 * shareDone(k, check_.views.size(), part)); };
        shown_.show(scene, loaded_.models, {view.camera});
        if (!onward(0.0) || !shown_.capture(onward)) return false;
        view.*picture = shown_.renderer().renderLinear(kViewWidth, kViewHeight, 8);
        shown_.requireHealthy();
      }
      return true;
    };
    return draw(loaded_.scene.probes, &EyePictures::before, 0.9) && draw(placement_.all(), &EyePictures::after, 0.95);
  }

  /// Captured from elsewhere in the same room: what the origin sees is what every point of the room shows.
  bool moveOrigins(PictureErrors& best) {
    if (placement_.probes.size() > kMostMoved) return moveMany(best);
    for (std::size_t i = 0; i < placement_.probes.size(); ++i) {
      if (placement_.probes[i].part) continue;
      for (const glm::dvec3& origin : placement_.rooms[placement_.probes[i].room].origins) {
        const Probe still = placement_.probes[i].probe;
        if (glm::length(origin - still.origin) < 0.05 * glm::length(still.box.size())) continue;
        placement_.probes[i].probe.origin = origin;
        const auto errors = errorsWith(placement_.all());
        if (!errors) return false;
        const bool better = isBetter(*errors, best);
        check_.sentences.push_back((better ? Phrase::tr("\"%1\" captured at (%2, %3, %4): error %5 -> %6")
                                           : Phrase::tr("\"%1\" captured at (%2, %3, %4): error %5 -> %6, left out"))
                                       .arg(oneLine(still.name))
                                       .arg(decimalText(origin.x, 2))
                                       .arg(decimalText(origin.y, 2))
                                       .arg(decimalText(origin.z, 2))
                                       .arg(errorText(best.error))
                                       .arg(errorText(errors->error)));
        if (better) {
          take(*errors, best);
        } else {
          placement_.probes[i].probe = still;
        }
      }
    }
    return true;
  }

  /// The same for many rooms at once: each takes the origin that is best for the eyes in it.
  bool moveMany(PictureErrors& best) {
    const std::vector<PlacedProbe> still = placement_.probes;
    std::vector<double> least;
    for (std::size_t room = 0; room < placement_.rooms.size(); ++room) least.push_back(ofRoom(room, bestSquares_));
    std::vector<glm::dvec3> chosen;
    chosen.reserve(still.size());
    for (const PlacedProbe& placed : still) chosen.push_back(placed.probe.origin);
    for (std::size_t turn = 0; turn < 2; ++turn) {
      for (PlacedProbe& placed : placement_.probes) {
        const std::vector<glm::dvec3>& origins = placement_.rooms[placed.room].origins;
        if (!placed.part && turn < origins.size()) placed.probe.origin = origins[turn];
      }
      if (!errorsWith(placement_.all())) return false;
      for (std::size_t i = 0; i < still.size(); ++i) {
        const std::size_t room = still[i].room;
        const double squares = ofRoom(room, squares_);
        if (squares >= kBetter * kBetter * least[room]) continue;
        chosen[i] = placement_.probes[i].probe.origin;
        least[room] = squares;
      }
    }
    std::size_t moved = 0;
    for (std::size_t i = 0; i < still.size(); ++i) {
      moved += chosen[i] != still[i].probe.origin ? 1 : 0;
      placement_.probes[i].probe.origin = chosen[i];
    }
    if (moved == 0) return true;
    const auto errors = errorsWith(placement_.all());
    if (!errors) return false;
    const bool better = isBetter(*errors, best);
    check_.sentences.push_back((better ? Phrase::tr("%1 probes captured from elsewhere: error %2 -> %3")
                                       : Phrase::tr("%1 probes captured from elsewhere: error %2 -> %3, left out"))
                                   .arg(std::to_string(moved))
                                   .arg(errorText(best.error))
                                   .arg(errorText(errors->error)));
    if (better) {
      take(*errors, best);
    } else {
      placement_.probes = still;
    }
    return true;
  }

  bool tryBounces(PictureErrors& best) {
    // What a person has chosen is not lowered.
    const bool lower = asOpened() && std::any_of(placement_.probes.begin(), placement_.probes.end(),
                                                 [](const PlacedProbe& placed) { return placed.probe.bounces != 1; });
    for (const int bounces : {kRoomBounces, 1}) {
      if (bounces == 1 && !lower) continue;
      const std::vector<PlacedProbe> still = placement_.probes;
      const std::vector<Probe> known = measured(placement_.all());
      for (PlacedProbe& placed : placement_.probes) {
        placed.probe.bounces = bouncesTried(placed.probe.bounces, bounces);
      }
      if (measured(placement_.all()) == known) {
        placement_.probes = still;
        continue;
      }
      const auto errors = errorsWith(placement_.all());
      if (!errors) return false;
      const bool better = isBetter(*errors, best);
      check_.sentences.push_back((better ? Phrase::tr("bounces of light in the captures: %1; error %2 -> %3")
                                         : Phrase::tr("bounces of light in the captures: %1; error %2 -> %3, left out"))
                                     .arg(bouncesText(bounces))
                                     .arg(errorText(best.error))
                                     .arg(errorText(errors->error)));
      if (better) {
        take(*errors, best);
      } else {
        placement_.probes = still;
      }
    }
    return true;
  }

  /// Probes of parts of rooms that the pictures do not miss.
  bool leaveOut(PictureErrors& best) {
    std::size_t tried = 0;
    for (std::size_t i = placement_.probes.size(); i-- > 0 && tried < kMostParts;) {
      const PlacedProbe candidate = placement_.probes[i];
      const auto sameRoom =
          std::count_if(placement_.probes.begin(), placement_.probes.end(),
                        [&](const PlacedProbe& each) { return each.room == candidate.room && !each.surroundings; });
      if (!candidate.part || (sameRoom < 2 && !candidate.surroundings)) continue;
      ++tried;
      placement_.probes.erase(placement_.probes.begin() + static_cast<std::ptrdiff_t>(i));
      const auto errors = errorsWith(placement_.all());
      if (!errors) return false;
      // What is seen outside stays lit unless that is plainly worse.
      const bool missed = errors->error > (candidate.surroundings ? kBetter : kNoWorse) * best.error;
      check_.sentences.push_back((missed ? Phrase::tr("without \"%1\": error %2 -> %3, it stays")
                                         : Phrase::tr("without \"%1\": error %2 -> %3, left out"))
                                     .arg(oneLine(candidate.probe.name))
                                     .arg(errorText(best.error))
                                     .arg(errorText(errors->error)));
      if (missed) {
        placement_.probes.insert(placement_.probes.begin() + static_cast<std::ptrdiff_t>(i), candidate);
        const double gain = errors->error - best.error;
        Phrase& reason = placement_.probes[i].reason;
        reason = gain > 0.0005 ? Phrase::tr("%1; without it the error grows by %2").arg(reason).arg(errorText(gain))
                               : Phrase::tr("%1; without it the error is the same").arg(reason);
      } else {
        take(*errors, best);
      }
    }
    return true;
  }

  /// From the origin of the largest room's probe.
  Probe aroundAll() const {
    Box bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const Eye& eye : eyes_)
      bounds = {glm::min(bounds.min, eye.camera.position), glm::max(bounds.max, eye.camera.position)};
    for (const PlacedProbe& placed : placement_.probes) {
      const glm::dvec3 half = 0.5 * placed.probe.box.size(), middle = placed.probe.box.center();
      const double yaw = placed.probe.rotationDegrees.y * 0.017453292519943295;
      const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
      const glm::dvec3 reach(c * half.x + s * half.z, half.y, s * half.x + c * half.z);
      bounds = {glm::min(bounds.min, middle - reach), glm::max(bounds.max, middle + reach)};
    }
    return withBox(bounds);
  }

  /// From its middle.
  Probe aroundModel() const {
    Probe probe = withBox(model_);
    probe.origin = fittedProbe(model_).origin;
    return probe;
  }

  Probe withBox(const Box& bounds) const {
    Probe probe = placement_.probes.front().probe;
    const Probe about = fittedProbe(bounds);
    probe.box = about.box;
    probe.influence = about.influence;
    probe.rotationDegrees = about.rotationDegrees;
    probe.blendDistance = about.blendDistance;
    probe.importance = 1.0;
    return probe;
  }

  const LoadedScene& loaded_;
  Placement& placement_;
  OffscreenScene& shown_;
  const std::function<bool(double)>& progress_;
  const PictureCheckSettings& settings_;
  ReferencePath path_;
  std::vector<Eye> eyes_;
  Box model_{glm::dvec3(1e300), glm::dvec3(-1e300)};  ///< around all surfaces
  double mean_ = 0.0;                                 ///< light of what the eyes see
  bool surfaces_ = false;                             ///< the eyes see some that count
  bool many_ = false;                                 ///< probes: kMany
  double trials_ = 0.0, expected_ = 1.0;
  std::vector<double> squares_, bestSquares_, ownSquares_;  ///< by eye: measured last; the best; the scene's own
  std::vector<double> noise_;                               ///< by eye: the truth's
  PictureCheck check_;
};

}  // namespace

bool eyesAgree(const std::vector<double>& before, const std::vector<double>& after) {
  const auto count = static_cast<double>(before.size());
  if (before.size() < kFewestEyes) return false;
  double gain = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) gain += (before[i] - after[i]) / count;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double off = before[i] - after[i] - gain;
    spread += off * off / (count * (count - 1.0));
  }
  return gain > kAlike * std::sqrt(spread);
}

std::optional<PictureCheck> checkPictures(const LoadedScene& loaded, Placement& placement, OffscreenScene& shown,
                                          const std::function<bool(double)>& progress,
                                          const PictureCheckSettings& settings) {
  double furthest = 0.0;
  const std::function<bool(double)> onward = [&](double done) {
    furthest = std::max(furthest, done);
    return !progress || progress(furthest);
  };
  return Checker(loaded, placement, shown, onward, settings).check();
}

}  // namespace boxprobe
