// See ray_rig.h.
#include "app/gui/explain/ray_rig.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkXMLPolyDataWriter.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/vtk/rays/vtkProjectionRays.h"

namespace boxprobe {

namespace {

/// Of what has no length of its own, relative to the distance it is seen from: as long on the screen from anywhere.
constexpr double kNormalOfDistance = 0.06;

RaySample sampleOf(const Explanation& e) {
  RaySample sample{e.surface.object, e.surface.positionWorld, glm::dvec3(e.surface.normalWorld), e.surface.roughness};
  sample.back = e.surface.backSide;
  return sample;
}

}  // namespace

RayRig::RayRig(vtkRenderer* renderer, std::function<PixelRays()> pixels)
    : pixels_(std::move(pixels)), layer_(renderer) {
  setSettings({});
}

RayRig::~RayRig() = default;

void RayRig::setModels(std::vector<std::shared_ptr<const Model>> models) {
  models_ = std::move(models);
  sources_.reset();
  explained_.reset();
  clicks_.clear();
  stale_ = true;
}

void RayRig::setScene(const Scene& scene, bool geometry) {
  scene_ = scene;
  if (geometry) sources_.reset();
  filter_->SetProbes(scene.probes);
  filter_->SetLights(scene.lights);
  stale_ = true;
}

void RayRig::setSettings(const RaySettings& settings) {
  settings_ = settings;
  for (int kind = 0; kind < kRayKinds; ++kind) {
    filter_->SetKindEnabled(static_cast<RayKind>(kind), settings.kinds[static_cast<std::size_t>(kind)]);
  }
  filter_->SetMaximumNumberOfRays(settings.count);
  filter_->SetMaximumLength(settings.maximumLength);
  layer_.setColoring(settings.coloring, settings.locked);
  stale_ = true;
}

bool RayRig::explain(const Explanation* explanation) {
  const bool point = explanation != nullptr && explanation->hit;
  if (!point && !explained_) return false;
  explained_ = point ? std::optional(sampleOf(*explanation)) : std::nullopt;
  if (settings_.source != RaySource::Pointer) return false;
  stale_ = true;
  return settings_.shown;
}

void RayRig::addClick(const Explanation& explanation) {
  if (!explanation.hit) return;
  clicks_.push_back(sampleOf(explanation));
  stale_ = true;
}

void RayRig::setClicks(std::vector<RaySample> clicks) {
  clicks_ = std::move(clicks);
  stale_ = true;
}

RaySources& RayRig::sources() {
  if (!sources_) sources_ = std::make_unique<RaySources>(models_, scene_);
  return *sources_;
}

std::vector<std::string> RayRig::objects() {
  return models_.empty() ? std::vector<std::string>() : sources().objects();
}

std::vector<RaySample> RayRig::samples() {
  switch (settings_.source) {
    case RaySource::Pointer:
      if (!explained_)
        status_ =
            QCoreApplication::translate("RayRig", "Move the pointer over a surface with the Explain tool on (E).");
      return explained_ ? std::vector<RaySample>{*explained_} : std::vector<RaySample>();
    case RaySource::Clicked:
      if (clicks_.empty())
        status_ = QCoreApplication::translate("RayRig", "Click surfaces with the Explain tool on (E).");
      return clicks_;
    case RaySource::Object: {
      const std::string object = !settings_.object.empty() ? settings_.object
                                 : clicks_.empty()         ? ""
                                                           : clicks_.back().object;
      if (object.empty())
        status_ = QCoreApplication::translate("RayRig", "Choose an object, or click one with the Explain tool on (E).");
      return object.empty() ? std::vector<RaySample>() : sources().over(object, settings_.count);
    }
    case RaySource::Line: {
      if (clicks_.size() < 2) {
        status_ = QCoreApplication::translate("RayRig", "Click the two ends with the Explain tool on (E).");
        return {};
      }
      const RaySample& from = clicks_[clicks_.size() - 2];
      const RaySample& to = clicks_.back();
      // Lifted off the surfaces first: dropped from right on them, rounding would decide what lies below.
      glm::dvec3 up = from.normalWorld + to.normalWorld;
      up = glm::length(up) > 0.1 ? glm::normalize(up) : glm::dvec3(0.0, 1.0, 0.0);
      const double lift = 0.05 * std::max(glm::length(to.positionWorld - from.positionWorld), 1e-6);
      return sources().alongLine(from.positionWorld + lift * up, to.positionWorld + lift * up, settings_.count, -up);
    }
    case RaySource::Screen: {
      const PixelRays pixels = pixels_();
      const double aspect = static_cast<double>(pixels.width()) / std::max(pixels.height(), 1);
      const int rows = std::max(1, static_cast<int>(std::floor(std::sqrt(settings_.count / aspect))));
      return sources().screenGrid(pixels, std::max(1, settings_.count / rows), rows);
    }
  }
  return {};
}

bool RayRig::update() {
  if (!stale_) return false;
  stale_ = false;
  status_.clear();
  if (!settings_.shown || models_.empty()) {
    const bool was = layer_.visible();
    layer_.setVisible(false);
    return was;
  }
  std::vector<RaySample> points = samples();
  for (RaySample& point : points) point.glass = sources().glassOf(point.object);
  const bool was = layer_.visible();
  if (points.empty()) {
    layer_.setVisible(false);
    return was;
  }
  status_ = points.size() == 1 ? QCoreApplication::translate("RayRig", "1 point")
                               : QCoreApplication::translate("RayRig", "%1 points").arg(points.size());
  compute(points);
  layer_.setVisible(true);
  return true;
}

void RayRig::compute(const std::vector<RaySample>& points) {
  const PixelRay eye = pixels_().through(0.5, 0.5);
  filter_->SetEye(eye.originWorld.x, eye.originWorld.y, eye.originWorld.z);
  const double distance = glm::length(points.front().positionWorld - eye.originWorld);
  filter_->SetNormalLength(kNormalOfDistance * distance);
  const auto on = [this](RayKind kind) { return settings_.kinds[static_cast<std::size_t>(kind)]; };
  // The true hit is traced in the scene only where it is to be seen.
  const bool truth = on(RayKind::TrueHit) || on(RayKind::Error) || settings_.coloring == RayColoring::Error;
  filter_->SetSceneData(truth ? sources().triangles() : nullptr);
  filter_->SetGlass(sources().glass());
  filter_->SetInputDataObject(0, rayPoints(points));
  filter_->Update();
  layer_.setRays(filter_->GetOutput());
}

long long RayRig::rays() const {
  return layer_.visible() ? filter_->GetOutput()->GetNumberOfCells() : 0;
}

void RayRig::save(const std::string& path) {
  update();
  if (rays() == 0) {
    const QString todo =
        status_.isEmpty() ? QCoreApplication::translate("RayRig", "show rays in the debug dock first") : status_;
    throw InputError(QCoreApplication::translate("RayRig", "no rays are shown that could be saved to %1; %2")
                         .arg(QString::fromStdString(path), todo)
                         .toStdString());
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(filter_->GetOutput());
  writer->SetWriteToOutputString(true);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOn();
  if (writer->Write() == 0) throw WorkError(path + ": VTK could not write the rays");
  writeTextAtomically(path, writer->GetOutputString());
}

}  // namespace boxprobe
