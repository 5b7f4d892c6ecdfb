#include "filters/reference/study/study.h"

#include <map>
#include <vector>

#include "filters/core/scene/technique_parameters.h"
#include "filters/math/technique/technique_errors.h"

namespace boxprobe {

namespace {

/// Does it use only the box, the map and the point's own pixel?
bool suits(const BenchTechnique& bench) {
  const auto technique = parseTechnique(bench.id);
  if (!technique || projectionRows()[static_cast<std::size_t>(technique->projection)].distances) return false;
  // Others use a table of bright directions, or neighbouring pixels.
  return bench.parameters.count("sampling") == 0 && bench.parameters.count("blur") == 0;
}

study::Technique inRoom(const BenchTechnique& bench, const std::vector<study::RoomPoint>& points) {
  Probe settings;
  settings.parameters = bench.parameters;
  const shading::TechniqueParameters parameters = techniqueParameters(settings);
  const Technique given = *parseTechnique(bench.id);
  const ParameterRow* budgetRow = findParameter("budget");
  const double budget = budgetRow != nullptr ? parameterNumber(settings, *budgetRow) : 0.0;
  // Errors measured in each room, as the renderer measures them for each probe.
  std::map<const study::PaddedCube*, TechniqueErrors> own;
  if (isAutomatic(given)) {
    for (const study::RoomPoint& at : points) {
      if (own.count(at.chain) == 0) own[at.chain] = measureTechniqueErrors(*at.chain, at.probe);
    }
  }
  return [=](const study::RoomPoint& at) {
    const double roughness = static_cast<double>(at.point.roughness);
    const Technique technique =
        isAutomatic(given) ? chooseAutomatic(roughness, roughness, budget, &own.at(at.chain)).technique : given;
    shading::ProbeShape probe = at.probe;
    probe.projection = technique.projection;
    probe.parameters = parameters;
    return glm::dvec3(
        evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate(at.chain, probe, at.point));
  };
}

}  // namespace

StudyResult runStudy(const StudyPlan& plan, const std::vector<BenchTechnique>& techniques,
                     const std::function<bool(double)>& progress) {
  StudyResult result;
  result.plan = plan;
  if (plan.rooms <= 0) return result;
  const auto goOn = [&](int done) { return !progress || progress(0.5 * done / plan.rooms); };
  const study::RoomPoints rooms =
      study::randomPoints(plan.seed, plan.rooms, plan.pointsEach, plan.faceSize, plan.rays, goOn);
  if (!goOn(plan.rooms)) return result;
  result.points = rooms.points.size();
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (progress && !progress(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(techniques.size()))) break;
    if (!suits(techniques[i])) continue;
    result.rows.push_back(
        {i, study::tally(study::valuesOf(inRoom(techniques[i], rooms.points), rooms.points), rooms.points)});
  }
  return result;
}

}  // namespace boxprobe
