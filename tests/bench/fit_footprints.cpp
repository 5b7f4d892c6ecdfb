// Fits the constants of the footprint techniques to this project's prefilter and level mapping, and prints them as they
// stand in shaders/technique; or judges the techniques as they are in rooms that the fit never saw:
//   fit_footprints 1|2|4|8|16 [ROUNDS [RESTARTS]]
//   fit_footprints judge [FACE_SIZE]
// Rounds and restarts are those of the table below, unless said. With 0 rounds the constants for surfaces that reflect
// all stay as they are, and only those for others are fitted.
// What is minimised: the error of display values and that of linear light, each relative to the HDRP form's, and light
// gained or lost at any roughness and view angle.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "tests/bench/footprint_form.h"
#include "tests/bench/least_squares.h"

namespace {

using namespace boxprobe;

// The rooms of fit and judgement have different seeds; unit tests have others.
constexpr unsigned kTrainingSeed = 1, kJudgementSeed = 77;
constexpr int kRays = 4096;
constexpr float kNonMetal = 0.04f;  // F0

// What the constants in shaders/technique were fitted with: each form has its own, since what its few numbers can do
// about light, they take from the errors.
struct Settings {
  int lookups, rooms, pointsEach;
  double linearWeight, lightWeight;
  int rounds, restarts;
  double edgeLightWeight;  // of what non-metals have beside
};
constexpr Settings kSettings[] = {
    {1, 96, 32, 1.0, 14.0, 20, 3, 14.0}, {2, 256, 12, 0.3, 5.0, 16, 0, 14.0}, {4, 256, 12, 1.0, 14.0, 14, 0, 14.0},
    {8, 64, 32, 1.0, 6.0, 20, 3, 6.0},   {16, 64, 32, 1.0, 6.0, 20, 3, 14.0},
};
constexpr double kLightFreely = 0.004;  // what the rays of the reference leave open

using Values = std::vector<glm::dvec3>;

class Errors {
 public:
  Errors(const std::vector<study::RoomPoint>& points, const Settings& settings)
      : points_(points), linearWeight_(settings.linearWeight), lightWeight_(settings.lightWeight) {
    for (const auto& p : points) {
      for (int c = 0; c < 3; ++c) display_.push_back(study::displayValue(p.truth[c]));
      light_[bucketOf(p)] += p.truth.x + p.truth.y + p.truth.z;
    }
    const Values hdrp = study::valuesOf(study::techniqueOf("hdrp"), points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        displaySquares_ +=
            std::pow(study::displayValue(hdrp[i][c]) - display_[3 * i + static_cast<std::size_t>(c)], 2.0);
        linearSquares_ += std::pow(hdrp[i][c] - points[i].truth[c], 2.0);
      }
    }
  }
  std::vector<double> residuals(const Values& values) const {
    const double display = 1.0 / std::sqrt(displaySquares_), linear = std::sqrt(linearWeight_ / linearSquares_);
    std::vector<double> result;
    std::array<double, study::kBuckets> light{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        result.push_back(display * (study::displayValue(values[i][c]) - display_[3 * i + static_cast<std::size_t>(c)]));
        result.push_back(linear * (values[i][c] - points_[i].truth[c]));
      }
      light[bucketOf(points_[i])] += values[i].x + values[i].y + values[i].z;
    }
    for (std::size_t b = 0; b < light.size(); ++b) {
      const double off = light[b] / light_[b] - 1.0;
      result.push_back(lightWeight_ / std::sqrt(3.0) * std::copysign(std::max(std::abs(off) - kLightFreely, 0.0), off));
    }
    return result;
  }

 private:
  static std::size_t bucketOf(const study::RoomPoint& p) {
    return static_cast<std::size_t>(p.roughness) * study::kAngles + static_cast<std::size_t>(p.angle);
  }
  const std::vector<study::RoomPoint>& points_;
  double linearWeight_, lightWeight_;
  std::vector<double> display_;
  std::array<double, study::kBuckets> light_{};
  double displaySquares_ = 0.0, linearSquares_ = 0.0;
};

void print(const std::string& name, const study::TechniqueTally& t, double hdrp) {
  std::printf("%-12s %.4f  %.3f  %.3f  %.3f |", name.c_str(), t.rmse, t.rmse / hdrp, t.relativeRmse, t.worstLight());
  for (const double e : t.rmseByRoughness) std::printf(" %.4f", e);
  std::printf(" |");
  for (std::size_t b = 0; b < t.light.size(); ++b)
    std::printf("%s%.3f", b % study::kAngles == 0 ? "  " : " ", t.light[b]);
  std::printf("\n");
}

void judge(int faceSize, float f0) {
  const study::RoomPoints rooms = study::randomPoints(kJudgementSeed, 192, 16, faceSize, kRays, {}, f0);
  const double hdrp = study::tally(study::valuesOf(study::techniqueOf("hdrp"), rooms.points), rooms.points).rmse;
  std::printf(
      "%zu points, faces of %d, F0 %g\n%-12s error   /hdrp  linear light | error by roughness | light by roughness: "
      "from "
      "above, oblique, grazing\n",
      rooms.points.size(), faceSize, static_cast<double>(f0), "");
  for (const char* id : {"infinite+none", "none", "approximate", "godot", "hdrp", "footprint1", "footprint2",
                         "footprint4", "footprint8", "footprint16"}) {
    print(id, study::tally(study::valuesOf(study::techniqueOf(id), rooms.points), rooms.points), hdrp);
  }
}

std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// First of surfaces that reflect all, then what non-metals add.
void fit(const Settings& s, int rounds, int restarts) {
  const bench::FootprintForm form = bench::footprintForm(s.lookups);
  const study::RoomPoints rooms = study::randomPoints(kTrainingSeed, s.rooms, s.pointsEach, 128, kRays);
  const auto report = [&](const char* name, const std::vector<double>& c, const study::RoomPoints& of) {
    const double hdrp = study::tally(study::valuesOf(study::techniqueOf("hdrp"), of.points), of.points).rmse;
    print(name, study::tally(study::valuesOf(form.technique(c), of.points), of.points), hdrp);
  };
  const Errors errors(rooms.points, s);
  const bench::Residuals residuals = [&](const std::vector<double>& c) {
    return joined(errors.residuals(study::valuesOf(form.technique(c), rooms.points)), form.plain(c));
  };
  std::vector<double> best = form.start;
  double least = rounds > 0 ? bench::leastSquares(residuals, best, rounds) : 0.0;
  std::mt19937 random(9);
  std::normal_distribution<double> gauss(0.0, 0.12);
  for (int i = 0; i < restarts; ++i) {  // out of a local minimum
    std::vector<double> c = best;
    for (double& x : c) x += gauss(random);
    const double there = bench::leastSquares(residuals, c, rounds);
    std::fprintf(stderr, "restart %d: %.5f, least %.5f\n", i + 1, there, least);
    if (there < least) least = there, best = c;
  }
  report("reflect all", best, rooms);
  if (s.lookups > 1) {
    const study::RoomPoints others =
        study::randomPoints(kTrainingSeed + 1, s.rooms, s.pointsEach, 128, kRays, {}, kNonMetal);
    Settings weighted = s;
    weighted.lightWeight = s.edgeLightWeight;
    const Errors otherErrors(others.points, weighted);
    report("others before", best, others);
    std::vector<double> edge(bench::kEdgeConstants, 0.0);
    const bench::Residuals edgeResiduals = [&](const std::vector<double>& e) {
      std::vector<double> plain = e;
      for (double& x : plain) x *= 0.004;
      return joined(otherErrors.residuals(study::valuesOf(form.technique(joined(best, e)), others.points)), plain);
    };
    bench::leastSquares(edgeResiduals, edge, 2 * s.rounds);
    best = joined(best, edge);
    report("others", best, others);
  }
  std::printf("%s", form.shader(best).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  if (what == "judge") {
    for (const float f0 : {1.0f, kNonMetal}) judge(number(2, 256), f0);
    return 0;
  }
  for (const Settings& settings : kSettings) {
    if (settings.lookups != number(1, 0)) continue;
    fit(settings, number(2, settings.rounds), number(3, settings.restarts));
    return 0;
  }
  std::fprintf(stderr, "usage: fit_footprints 1|2|4|8|16 [ROUNDS [RESTARTS]] | judge [FACE_SIZE]\n");
  return 2;
}
