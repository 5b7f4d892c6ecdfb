// The published contact hardenings and level curves against a plain evaluation of their formulas in double precision,
// and that no input makes them look up anything that is not finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "filters/math/technique/technique_table.h"

namespace boxprobe {
namespace {

using glm::dvec3;
using glm::vec3;

struct Fetches : shading::CubeSampler {
  struct Fetch {
    vec3 direction;
    float level;
  };
  glm::vec4 fetch(const vec3& direction, float level) const override {
    list.push_back({direction, level});
    return glm::vec4(level);
  }
  mutable std::vector<Fetch> list;
};

struct Input {
  shading::ProbeShape probe{};
  shading::ShadingPoint point{};
};

class Inputs {
 public:
  Input next(double scale = 1.0) {
    Input in;
    const dvec3 low = scale * dvec3(-5 * unit(), -5 * unit(), -5 * unit());
    const dvec3 high = scale * dvec3(0.1 + 5 * unit(), 0.1 + 5 * unit(), 0.1 + 5 * unit());
    in.probe.boxMin = vec3(low);
    in.probe.boxMax = vec3(high);
    in.probe.maxLevel = 6.0f;
    in.probe.projection = parseTechnique("box")->projection;
    in.probe.parameters = standardParameters();
    in.point.position = vec3(low + (high - low) * dvec3(unit(), unit(), unit()));
    in.point.normal = direction();
    in.point.view = direction();
    if (glm::dot(in.point.normal, in.point.view) < 0.0f) in.point.view = -in.point.view;
    in.point.reflection = glm::reflect(-in.point.view, in.point.normal);
    in.point.roughness = static_cast<float>(unit());
    in.point.f0 = 1.0f;
    return in;
  }
  double unit() { return unit_(random_); }

 private:
  vec3 direction() {
    return glm::normalize(vec3(static_cast<float>(gauss_(random_)), static_cast<float>(gauss_(random_)),
                               static_cast<float>(gauss_(random_))));
  }
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
  std::normal_distribution<double> gauss_;
};

struct ExactHit {
  double distance;
  dvec3 hit;
};

ExactHit exactHit(const Input& in) {
  const dvec3 p(in.point.position), r(in.point.reflection);
  double t = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (r[i] != 0.0) t = std::min(t, ((r[i] < 0.0 ? in.probe.boxMin[i] : in.probe.boxMax[i]) - p[i]) / r[i]);
  }
  t = std::max(t, 0.0);
  return {t, p + t * r};
}

// The curves as published, of the fraction of the chain.
double exactLevel(const std::string& curve, double p, double last) {
  if (curve == "unity") return p * (1.7 - 0.7 * p) * last;
  if (curve == "linear" || curve == "three-level") return p * last;
  if (curve == "exact") {
    if (p == 0.0) return 0.0;
    const double m = p * p, n = (2.0 / (m * m) - 2.0) / 4.0;
    return std::pow(2.0 / (n + 2.0), 0.25) * last;
  }
  if (curve == "marmoset") return std::pow(p, 0.75) * last;
  return std::log2(1.0 + p * p * (std::exp2(last) - 1.0));
}

double exactLevel(const std::string& evaluation, const std::string& curve, const Input& in) {
  const ExactHit hit = exactHit(in);
  const double p = in.point.roughness, last = in.probe.maxLevel, mip0 = exactLevel(curve, p, last);
  const double s = in.probe.parameters.hardeningLength;
  if (evaluation == "none") return mip0;
  if (evaluation == "approximate") return mip0 * std::clamp(hit.distance, 0.0, s) / s;
  if (evaluation == "hdrp") {
    const double nearer = std::clamp(hit.distance / glm::length(hit.hit) * p, 0.0, p);
    return exactLevel(curve, nearer * (1.0 - p) + p * p, last);
  }
  if (evaluation == "godot") {
    const double nv = glm::dot(dvec3(in.point.normal), dvec3(in.point.view));
    const double f = std::pow(std::clamp(1.0 - nv, 0.0, 1.0), static_cast<double>(in.probe.parameters.power));
    const double q = std::clamp(hit.distance / s * (1.0 - f) + (1.0 - f) * p, 0.0, 1.0);
    const double alpha = p * p;
    return alpha * alpha * last * (1.0 - q) + mip0 * q;
  }
  return std::nan("");
}

const std::vector<std::string_view>& curves() {
  return findParameter("curve")->choices;
}

// Nothing is hit, whatever the call before has left in memory.
TEST(Projections, WithoutABoxHitNothing) {
  Inputs inputs;
  for (int i = 0; i < 100; ++i) {
    const Input in = inputs.next();
    for (const char* id : {"normal", "infinite"}) {
      for (const std::string_view each : {std::string_view("box"), std::string_view(id)}) {
        const auto row = std::find_if(projectionRows().begin(), projectionRows().end(),
                                      [&](const ProjectionRow& known) { return known.id == each; });
        const shading::ProbeHit hit = row->project(in.probe, in.point.position, in.point.normal, in.point.reflection);
        if (each == "box") continue;
        EXPECT_EQ(hit.slabFactors, vec3(hit.distance)) << id;
        EXPECT_GT(hit.distance, 1.0e30f) << id;
        EXPECT_EQ(hit.face, -1) << id;
        EXPECT_EQ(hit.refined, 0.0f) << id;
      }
    }
  }
}

TEST(Techniques, ChooseOnlyWhatTheyRead) {
  shading::TechniqueParameters values{};
  const auto aims = [&](const char* id) { return chooses(*parseTechnique(id), values, "sampling", "luminance"); };
  EXPECT_FALSE(aims("raytraced"));
  values.sampling = 1;
  EXPECT_TRUE(aims("raytraced"));
  EXPECT_FALSE(aims("footprint8"));
  EXPECT_FALSE(aims("box"));
}

TEST(Evaluations, LookUpTheLevelOfTheirPublishedFormula) {
  Inputs inputs;
  for (const char* id : {"none", "approximate", "hdrp", "godot"}) {
    const auto technique = parseTechnique(id);
    ASSERT_TRUE(technique) << id;
    const EvaluationRow& row = evaluationRows()[static_cast<std::size_t>(technique->evaluation)];
    for (std::size_t curve = 0; curve < curves().size(); ++curve) {
      double worst = 0.0, worstDirection = 0.0;
      for (int i = 0; i < 5000; ++i) {
        Input in = inputs.next();
        in.probe.parameters.curve = static_cast<int>(curve);
        in.probe.parameters.hardeningLength = static_cast<float>(0.1 + 8.0 * inputs.unit());
        in.probe.parameters.power = static_cast<float>(1 + i % 6);
        const Fetches fetches;
        const float level =
            row.evaluate(&fetches, in.probe, in.point).x;  // linear: the mean of two levels comes out too
        EXPECT_EQ(fetches.list.size(), curves()[curve] == "three-level" ? 2u : 1u);
        worst = std::max(worst, std::abs(level - exactLevel(id, std::string(curves()[curve]), in)));
        const double size = glm::length(in.probe.boxMax - in.probe.boxMin);
        worstDirection =
            std::max(worstDirection, glm::length(dvec3(fetches.list[0].direction) - exactHit(in).hit) / size);
      }
      // The own curve's slope is steepest near roughness 0, where it magnifies the rounding of p' the most.
      EXPECT_LT(worst, 2.0e-4) << id << ", curve " << curves()[curve];
      EXPECT_LT(worstDirection, 1.0e-6) << id;
    }
  }
}

TEST(Evaluations, ThreeLevelsAreTheFirstTheMiddleAndTheLast) {
  Input in = Inputs().next();
  in.probe.maxLevel = 8.0f;
  in.probe.parameters.curve = 5;
  for (const float p : {0.0f, 0.3f, 0.5f, 0.8f, 1.0f}) {
    in.point.roughness = p;
    const Fetches fetches;
    const auto& none = evaluationRows()[static_cast<std::size_t>(parseTechnique("none")->evaluation)];
    EXPECT_NEAR(none.evaluate(&fetches, in.probe, in.point).x, 8.0f * p, 1e-5f);
    for (const auto& fetch : fetches.list) EXPECT_TRUE(fetch.level == 0 || fetch.level == 4 || fetch.level == 8);
  }
}

TEST(Evaluations, CurvesRunFromTheFirstLevelToTheLast) {
  shading::ProbeShape probe{};
  probe.maxLevel = 7.0f;
  for (std::size_t curve = 0; curve < curves().size(); ++curve) {
    probe.parameters.curve = static_cast<int>(curve);
    EXPECT_EQ(shading::levelForCurve(probe, 0.0f), 0.0f) << curves()[curve];
    EXPECT_NEAR(shading::levelForCurve(probe, 1.0f), 7.0f, 1e-5f) << curves()[curve];
    float before = -1.0f;
    for (int i = 0; i <= 100; ++i) {
      const float level = shading::levelForCurve(probe, 0.01f * static_cast<float>(i));
      EXPECT_GT(level, before) << curves()[curve] << " must rise, " << i;
      before = level;
    }
  }
}

// Every row of the tables, whatever it is, on every kind of awkward input.
TEST(Evaluations, NeverLookUpAnythingThatIsNotFinite) {
  Inputs inputs;
  std::size_t nonFinite = 0;
  for (std::size_t p = 0; p < projectionRows().size(); ++p) {
    for (const EvaluationRow& row : evaluationRows()) {
      nonFinite = 0;
      for (int i = 0; i < 20000; ++i) {
        Input in = inputs.next(std::pow(10.0, -12.0 + 24.0 * inputs.unit()));
        in.probe.projection = static_cast<int>(p);
        in.probe.parameters.curve = static_cast<int>(inputs.unit() * static_cast<double>(curves().size()));
        in.probe.parameters.hardeningLength = static_cast<float>(std::pow(10.0, -6.0 + 12.0 * inputs.unit()));
        in.probe.parameters.power = static_cast<float>(0.01 + 16.0 * inputs.unit());
        vec3& at = in.point.position;
        if (i % 3 == 0) at.y = in.probe.boxMin.y;                           // on a face
        if (i % 5 == 0) at += (in.probe.boxMax - in.probe.boxMin) * 0.75f;  // outside
        if (i % 7 == 0) in.probe.boxMin = in.probe.boxMax = vec3(0.0f);     // a point at the capture origin
        if (i % 11 == 0) in.probe.boxMax.x = in.probe.boxMin.x;             // flat
        if (i % 13 == 0) in.point.reflection = vec3(0, 0, 1);
        if (i % 17 == 0) in.point.view = -in.point.view;  // from behind
        const vec3 n = in.point.normal, v = in.point.view;
        if (i % 19 == 0) in.point.normal = v;                                                    // no tangent
        if (i % 19 == 1) in.point.view = glm::normalize(v - n * glm::dot(v, n) + vec3(1e-20f));  // grazing
        if (i % 4 == 0) in.point.roughness = i % 8 == 0 ? 0.0f : 1.0f;
        if (i % 29 == 0) in.probe.maxLevel = 0.0f;
        const Fetches fetches;
        const float sum = row.evaluate(&fetches, in.probe, in.point).x;
        bool finite = std::isfinite(sum) && !fetches.list.empty();
        for (const auto& f : fetches.list) {
          finite = finite && std::isfinite(f.level) && std::isfinite(f.direction.x) && std::isfinite(f.direction.y) &&
                   std::isfinite(f.direction.z);
        }
        nonFinite += finite ? 0 : 1;
      }
      EXPECT_EQ(nonFinite, 0u) << projectionRows()[p].id << "+" << row.id;
    }
  }
}

TEST(Techniques, NameParametersOfTheTableThatTheMathematicsHolds) {
  for (const EvaluationRow& row : evaluationRows()) {
    for (const std::string_view name : row.parameters) {
      const ParameterRow* parameter = findParameter(name);
      ASSERT_NE(parameter, nullptr) << row.id << " " << name;
      // These two are about the picture as a whole: no lookup reads them.
      const int readers = name == "animated" || name == "blur" ? 0 : 1;
      EXPECT_EQ((parameter->number != nullptr ? 1 : 0) + (parameter->choice != nullptr ? 1 : 0), readers) << name;
      EXPECT_FALSE(parameter->help.empty()) << name;
      EXPECT_FALSE(parameter->label.empty()) << name;
      if (parameter->kind == ParameterKind::Choice) {
        EXPECT_LT(parameter->standard, static_cast<double>(parameter->choices.size())) << name;
      } else {
        EXPECT_GE(parameter->standard, parameter->min) << name;
        EXPECT_LE(parameter->standard, parameter->max) << name;
      }
    }
  }
}

}  // namespace
}  // namespace boxprobe
