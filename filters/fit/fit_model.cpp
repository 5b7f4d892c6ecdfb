// See fit_model.h.
#include "filters/fit/fit_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "filters/core/base/file_extension.h"
#include "filters/core/base/number_text.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/fit/fitted_camera.h"
#include "filters/fit/room_probe.h"

namespace boxprobe {

namespace {

/// Points whose hull contains nearly every visible triangle, in the world; a sample of large models. `blending`: of
/// transparent surfaces, or of all others.
std::vector<glm::dvec3> cornersOf(const Scene& scene, const TriangleRays::Models& models, bool blending) {
  constexpr std::size_t kMost = 200000;
  std::size_t all = 0;
  for (const auto& model : models) {
    for (const Instance& each : model->instances) {
      all += model->meshes[static_cast<std::size_t>(each.mesh)].positions.size();
    }
  }
  const std::size_t stride = std::max<std::size_t>(1, all / kMost);
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      const auto object = scene.objects.find(instance.node);
      if (object != scene.objects.end() && !object->second.visible) continue;
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const bool blends = mesh.material >= 0 &&
                          models[i]->materials[static_cast<std::size_t>(mesh.material)].alphaMode == AlphaMode::Blend;
      if (blends != blending) continue;
      const glm::dmat4 world = movedInstance(placement * instance.worldFromModel, scene, instance.node);
      for (std::size_t k = 0; k < mesh.positions.size(); k += stride) {
        const glm::dvec3 corner(world * glm::dvec4(glm::dvec3(mesh.positions[k]), 1.0));
        if (std::isfinite(corner.x + corner.y + corner.z)) corners.push_back(corner);
      }
    }
  }
  return corners;
}

Box boundsOf(const std::vector<glm::dvec3>& corners) {
  if (corners.empty()) return Box{};
  Box bounds{corners.front(), corners.front()};
  for (const glm::dvec3& corner : corners) {
    bounds.min = glm::min(bounds.min, corner);
    bounds.max = glm::max(bounds.max, corner);
  }
  return bounds;
}

/// Everything that a picture should show: a blended shadow or glow that extends far beyond the rest does not count.
std::vector<glm::dvec3> shownCorners(const Scene& scene, const TriangleRays::Models& models) {
  const std::vector<glm::dvec3> firm = cornersOf(scene, models, false);
  std::vector<glm::dvec3> all = cornersOf(scene, models, true);
  all.insert(all.end(), firm.begin(), firm.end());
  const bool far = glm::length(boundsOf(all).size()) > 1.5 * glm::length(boundsOf(firm).size());
  return far && !firm.empty() ? firm : all;
}

std::vector<Light> fileLights(const Scene& scene, const TriangleRays::Models& models) {
  std::vector<Light> lights;
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (const Light& light : placedLights(*models[i], scene.models[i])) lights.push_back(light);
  }
  return lights;
}

std::vector<Camera> fileCameras(const Scene& scene, const TriangleRays::Models& models) {
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (const Camera& camera : placedCameras(*models[i], scene.models[i])) cameras.push_back(camera);
  }
  return cameras;
}

/// Lights the scene, and returns the reason in words. `stand` and `probe`: of an interior or a court with room to
/// stand.
Phrase light(Scene& scene, ModelFit& fit, const TriangleRays& rays, const FitWishes& wishes,
             const std::vector<Light>& ofFile, const StandingPoint* stand, const Probe* probe) {
  std::vector<Light> through;
  if (probe != nullptr) through = openingLights(rays, *probe);
  Phrase why = Phrase::tr("the file has no light: %1");
  if (wishes.light) {
    fit.light = *wishes.light;
    why = Phrase::tr("as you chose, %1");
  } else if (!ofFile.empty()) {
    fit.light = FitLight::File;
  } else if (fit.kind == ModelKind::Interior && probe != nullptr) {
    fit.light = through.empty() ? FitLight::Ceiling : FitLight::Openings;
  } else {
    fit.light = fit.kind == ModelKind::Open ? FitLight::Daylight : FitLight::Studio;
  }
  if (fit.light == FitLight::Ceiling && probe == nullptr) {
    fit.light = FitLight::Studio;
    why = Phrase::tr("there is no room with a ceiling: %1");
  }
  if (fit.light == FitLight::Openings && through.empty()) {
    fit.light = FitLight::Daylight;
    why = Phrase::tr("there are no openings: %1");
  }
  fit.lightKnown = fit.light == FitLight::Studio;
  scene.sky = SkyGradient{};
  switch (fit.light) {
    case FitLight::File:
      scene.lights = ofFile;
      if (ofFile.empty()) return Phrase::tr("the file has no light, and you chose the file's");
      return ofFile.size() == 1 ? Phrase::tr("the light is the file's") : Phrase::tr("the lights are the file's");
    case FitLight::Studio:
      scene.lights.clear();
      if (!wishes.studio.empty()) scene.sky = SkyImage{wishes.studio};
      return why.arg(Phrase::tr("a studio lights it"));
    case FitLight::Ceiling:
      scene.lights = ceilingLights(*probe, *stand);
      return why.arg(Phrase::tr("soft lamps hang under the ceiling"));
    case FitLight::Openings:
      scene.lights = through;
      return why.arg(Phrase::tr("the sky shines in through the openings"));
    case FitLight::Daylight:
      scene.lights = sunLight();
      return why.arg(Phrase::tr("sky and sun light it"));
  }
  return {};
}

/// "6,500 m wide: is the unit mm? --set models.0.unit=mm", for a size that is unlikely in metres.
std::string sizeRemark(ModelKind kind, const Box& bounds, const ModelFile& file) {
  const glm::dvec3 size = bounds.size();
  const double largest = std::max({size.x, size.y, size.z});
  const std::string extent = extentText(bounds).english();
  const LengthUnit likely = file.unit == LengthUnit::Metre ? likelyUnit(file.file, kind, largest) : LengthUnit::Metre;
  if (likely != LengthUnit::Metre) {
    const std::string unit = likely == LengthUnit::Centimetre ? "cm" : "mm";
    return extent + ": is the unit " + unit + "? --set models.0.unit=" + unit;
  }
  if (largest > 0.0 && largest < 0.002) {
    return extent + ": is it meant to be larger? --set models.0.scale=1000";
  }
  return {};
}

/// Scanners and printers use Z up as often as Y, and these formats do not say.
std::string upRemark(const ModelFile& file) {
  const std::string extension = lowerExtension(file.file);
  if (file.upAxis != UpAxis::Y || (extension != ".stl" && extension != ".ply")) return {};
  return extension.substr(1) + " files do not say which way is up: if it lies on its side, --set models.0.upAxis=z";
}

}  // namespace

ModelFit fitModel(Scene& scene, const TriangleRays::Models& models, const FitWishes& wishes) {
  const TriangleRays rays(scene, models);
  ModelFit fit;
  fit.survey = surveyModel(rays);
  fit.kind = wishes.kind.value_or(fit.survey.kind);
  scene.probes.clear();

  std::vector<StandingPoint> stands;
  const bool court = fit.kind == ModelKind::Open && (wishes.kind || fit.survey.walled >= 0.3);
  if (fit.kind == ModelKind::Interior || court) stands = standingPoints(rays, fit.survey);
  std::optional<Probe> probe;
  if (!stands.empty()) {
    probe = roomProbe(rays, stands.front());
    // It lights the whole model, but its box is fitted to the surrounding room.
    const std::optional<Box> whole = std::exchange(probe->influence, std::nullopt);
    fit.box = fitBox({rays, rays, fileCameras(scene, models)}, *probe, wishes.box);
    probe = fit.box->probe;
    if (fit.kind == ModelKind::Interior) probe->bounces = kRoomBounces;
    probe->influence = turnedInfluence(*whole, *probe);
  }
  const Phrase lit = light(scene, fit, rays, wishes, fileLights(scene, models),
                           stands.empty() ? nullptr : &stands.front(), probe ? &*probe : nullptr);

  const std::vector<Camera> cameras = fileCameras(scene, models);
  const std::vector<glm::dvec3> corners = shownCorners(scene, models);
  const Box bounds = boundsOf(corners);
  if (cameras.empty()) {
    scene.cameras = {stands.empty() ? objectCamera(corners, bounds, wishes.aspect)
                                    : roomCamera(rays, stands, wishes.aspect)};
  }

  fit.within = !stands.empty();
  const Phrase what = fit.kind == ModelKind::Open       ? Phrase::tr("an open place")
                      : fit.kind == ModelKind::Interior ? Phrase::tr("an interior")
                                                        : Phrase::tr("an object");
  const Phrase treated = wishes.kind ? Phrase::tr("treated as %1 as you chose").arg(what)
                                     : Phrase::tr("treated as %1 (%2)").arg(what).arg(fit.survey.reason);
  const Phrase reflects =
      probe ? Phrase::tr("one probe within it") : Phrase::tr("no probe, the surroundings alone are reflected");
  fit.decided = Phrase::tr("%1; %2; %3").arg(treated).arg(reflects).arg(lit);
  if (probe) scene.probes = {*std::move(probe)};
  fit.guess = guessImport(scene, models, fit.kind, rays.bounds());
  const ModelFile& first = scene.models.front();
  for (const std::string& remark : {sizeRemark(fit.kind, rays.bounds(), first), upRemark(first)}) {
    if (!remark.empty()) fit.warnings.push_back(first.file + ": " + remark);
  }
  return fit;
}

}  // namespace boxprobe
