// See probe_preview.h.
#include "app/gui/panels/probe_preview.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/cube_view.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_slider.h"
#include "app/gui/widgets/value_field.h"
#include "filters/math/cube/srgb.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kLightMap = 0, kDistanceMap = 1;
constexpr const char* kFaceNames[6] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

/// Distances as greys, white at `farthest` and beyond.
CubeMap greys(const CubeMap& distance, double farthest) {
  CubeMap result(distance.faceSize(), 1);
  const std::size_t count =
      static_cast<std::size_t>(distance.faceSize()) * static_cast<std::size_t>(distance.faceSize());
  for (int face = 0; face < 6; ++face) {
    const float* from = distance.face(0, face);
    float* to = result.face(0, face);
    for (std::size_t i = 0; i < count; ++i) {
      // Undoes the display's curve: the grey itself is to be proportional.
      const double grey = linearOfSrgbValue(std::min(from[4 * i] / std::max(farthest, 1e-30), 1.0));
      for (std::size_t c = 0; c < 3; ++c) to[4 * i + c] = static_cast<float>(grey);
      to[4 * i + 3] = 1.0f;
    }
  }
  return result;
}

double largestRed(const CubeMap& cube) {
  float largest = 0.0f;
  const std::size_t count = 4 * static_cast<std::size_t>(cube.faceSize()) * static_cast<std::size_t>(cube.faceSize());
  for (int face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < count; i += 4) largest = std::max(largest, cube.face(0, face)[i]);
  }
  return static_cast<double>(largest);
}

}  // namespace

ProbePreview::ProbePreview(Workspace& workspace)
    : workspace_(workspace),
      editor_(workspace.editor()),
      renderer_(workspace.renderer()),
      view_(new CubeFaces(this)),
      readout_(helpLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  buildFields();
  layout->addWidget(view_);
  layout->addWidget(readout_);
  layout->addStretch(1);
  view_->setObjectName("cubeView");
  readout_->setObjectName("cubeReadout");
  readout_->setMinimumHeight(3 * readout_->fontMetrics().lineSpacing());  // or the picture would jump with the text
  readout_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &ProbePreview::readOne);
  connect(view_, &CubeFaces::pointed, this, &ProbePreview::tell);
  connect(view_, &CubeFaces::widthChanged, this, &ProbePreview::draw);
  // Its maps come with the pictures that follow them.
  workspace.changes().add("cubemap", {&Changes::probeList, &Changes::selection, &Changes::exposure},
                          [this](const Changes&) { update(); });
  connect(&workspace.scheduler(), &RenderScheduler::rendered, this, &ProbePreview::update);
  tell(std::nullopt);
}

void ProbePreview::buildFields() {
  QFormLayout* form = addSection(this, tr("Cubemap of the selected probe"));
  what_ = addProbeChoice(
      form, tr("Show"),
      {{tr("Light"), kLightMap, tr("Captured and filtered radiance at the picture's exposure")},
       {tr("Distance"), kDistanceMap,
        tr("Distance from the capture origin to the captured surfaces; black where nothing was captured")}},
      tr("Which of the probe's maps is shown"), [this](int) { update(); });
  kind_ = addProbeChoice(
      form, tr("As"),
      {{tr("Cross"), static_cast<int>(CubePictureKind::Cross), tr("The six faces: -Z +X +Z -X around, +Y above")},
       {tr("Latitude-longitude"), static_cast<int>(CubePictureKind::LatLong), tr("The whole sphere in one picture")}},
      tr("Seen from the origin: +Z in the middle, +X to its left, +Y up"), [this](int) { draw(); });
  level_ = new QuietSlider(Qt::Horizontal, this);
  level_->setPageStep(1);
  level_->setRange(0, 0);
  addRow(form, tr("Level"), level_,
         tr("Mip level 0 is the capture itself; each further level is filtered for rougher surfaces"));
  levelText_ = new QLabel(this);
  form->addRow(QString(), levelText_);
  connect(level_, &QSlider::valueChanged, this, [this] {
    updateLevelText();
    updateSphere();
    update();
  });
  stops_ = new ValueField({-16.0, 16.0, 0.5, 1, tr(" stops")}, this);
  addRow(form, tr("Brightness"), stops_,
         tr("Exposure of this preview on top of the picture's exposure; one stop doubles the light"));
  connect(stops_, &ValueField::previewed, this, &ProbePreview::draw);
  connect(stops_, &ValueField::committed, this, &ProbePreview::draw);
  sphere_ = addProbeChoice(
      form, tr("Sphere"),
      {{tr("None"), static_cast<int>(SphereKind::Off)},
       {tr("Chrome"), static_cast<int>(SphereKind::Chrome), tr("A mirror: the capture itself")},
       {tr("Roughness of this mip level"), static_cast<int>(SphereKind::Rough), tr("A metal with the roughness above")},
       {tr("Diffuse"), static_cast<int>(SphereKind::Diffuse), tr("Diffuse white: the probe's irradiance")}},
      tr("Shows a sphere at the capture origin in the 3D view, lit by this probe's maps alone. Captures do not see it"),
      [this](int) { updateSphere(); });
  const std::pair<QWidget*, const char*> names[] = {{what_, "previewWhat"},   {kind_, "previewKind"},
                                                    {level_, "previewLevel"}, {levelText_, "previewLevelText"},
                                                    {stops_, "previewStops"}, {sphere_, "previewSphere"}};
  for (const auto& [widget, name] : names) widget->setObjectName(name);
}

bool ProbePreview::showsDistance() const {
  return what_->currentData().toInt() == kDistanceMap;
}

int ProbePreview::level() const {
  return showsDistance() ? 0 : level_->value();
}

void ProbePreview::setWatched(bool watched) {
  watched_ = watched;
  if (watched) return update();
  // What was half read is read again when someone looks again.
  if (reader_.pending()) maps_.reset();
  reader_.stop();
  timer_.stop();
}

void ProbePreview::update() {
  if (sphere_->currentData().toInt() != static_cast<int>(SphereKind::Off)) updateSphere();
  if (!watched_) return;
  const Probe* probe = editor_.probe();
  setEnabled(probe != nullptr);
  const std::string name = probe ? probe->name : std::string();
  const auto maps = probe ? renderer_.shownMaps(name) : nullptr;
  level_->setEnabled(maps && !showsDistance());
  {
    const QSignalBlocker quiet(level_);
    if (maps) level_->setMaximum(levelCount(*maps) - 1);
  }
  updateLevelText();
  const bool same = name == probe_ && maps == maps_.lock() && level() == readLevel_ && showsDistance() == readDistance_;
  if (!same) {
    probe_ = name;
    maps_ = maps;
    start();
  } else if (editor_.scene().exposure != exposure_ && !reader_.pending()) {
    draw();
  }
}

void ProbePreview::start() {
  readLevel_ = level();
  readDistance_ = showsDistance();
  reader_.start(maps_.lock(), readLevel_, readDistance_);
  if (reader_.pending()) {
    timer_.start();
    if (cube_.empty()) draw();  // says that it is on its way
  } else {
    timer_.stop();
    cube_ = {};
    draw();
  }
}

void ProbePreview::readOne() {
  workspace_.viewport().window3d()->MakeCurrent();
  reader_.step();
  ++facesRead_;
  if (reader_.pending()) return;
  timer_.stop();
  cube_ = reader_.cube();
  draw();
}

void ProbePreview::draw() {
  exposure_ = editor_.scene().exposure;
  const auto kind = static_cast<CubePictureKind>(kind_->currentData().toInt());
  const QString instead = !editor_.probe()    ? tr("No probe selected")
                          : reader_.pending() ? tr("Reading the cubemap")
                          : showsDistance()
                              ? tr("This probe has no distances: its picture was imported, or it is not captured yet")
                              : tr("Not captured yet");
  if (readDistance_) {
    // What lies far outside would leave the room itself black: the scale ends at the box's diagonal.
    const Probe* probe = editor_.probe();
    const double diagonal = probe ? glm::length(probe->box.size()) : 0.0;
    farthest_ = cube_.empty() ? 0.0 : largestRed(cube_);
    if (diagonal > 0.0) farthest_ = std::min(farthest_, diagonal);
    farthest_ *= std::exp2(-stops_->value());
    const CubeMap grey = cube_.empty() ? CubeMap() : greys(cube_, farthest_);
    view_->show(&grey, kind, 1.0f, instead);
  } else {
    view_->show(&cube_, kind, static_cast<float>(exposure_ * std::exp2(stops_->value())), instead);
  }
  tell(std::nullopt);
}

void ProbePreview::updateLevelText() {
  const int last = level_->maximum();
  const auto maps = maps_.lock();
  if (maps && showsDistance()) return levelText_->setText(tr("one level, %1 × %1").arg(faceSize(*maps)));
  const int size = maps ? std::max(faceSize(*maps) >> level_->value(), 1) : 0;
  const float roughness =
      last > 0 ? shading::roughnessForLevel(static_cast<float>(level_->value()), static_cast<float>(last)) : 0.0f;
  levelText_->setText(maps ? tr("%1: roughness %2, %3 × %3").arg(level_->value()).arg(roughness, 0, 'f', 2).arg(size)
                           : QString());
}

void ProbePreview::updateSphere() {
  PreviewSphereSettings settings;
  const Probe* probe = editor_.probe();
  if (probe) settings.kind = static_cast<SphereKind>(sphere_->currentData().toInt());
  if (settings.kind != SphereKind::Off) settings.probe = probe->name;
  if (settings.kind == SphereKind::Rough && level_->maximum() > 0) {
    settings.roughness =
        shading::roughnessForLevel(static_cast<float>(level_->value()), static_cast<float>(level_->maximum()));
  }
  if (settings == renderer_.previewSphere()) return;
  renderer_.showPreviewSphere(settings);
  workspace_.requestPicture();
}

void ProbePreview::tell(const std::optional<glm::vec3>& direction) {
  if (!direction || cube_.empty()) {
    readout_->setText(cube_.empty() ? QString()
                      : readDistance_
                          ? tr("Black: nothing was captured. White: %1 m and beyond.").arg(farthest_, 0, 'g', 4)
                          : tr("Point at the picture to read a texel."));
    return;
  }
  const CubePoint point = cubePoint(*direction);
  const int size = cube_.faceSize();
  const auto index = [size](float s) {
    return std::clamp(static_cast<int>((0.5f * s + 0.5f) * static_cast<float>(size)), 0, size - 1);
  };
  const int column = index(point.s), row = index(point.t);
  const glm::vec4 value = cube_.texel(0, point.face, column, row);
  const auto number = [](float x) { return QString::number(static_cast<double>(x), 'g', 4); };
  const QString where = tr("Face %1, column %2, row %3").arg(kFaceNames[point.face]).arg(column).arg(row);
  readout_->setText(readDistance_
                        ? tr("%1\n%2").arg(where, value.r > 0.0f ? number(value.r) + " m" : tr("nothing seen"))
                        : tr("%1\nlinear light %2  %3  %4   coverage %5")
                              .arg(where, number(value.r), number(value.g), number(value.b), number(value.a)));
}

}  // namespace boxprobe
