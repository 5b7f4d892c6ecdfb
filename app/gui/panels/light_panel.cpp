// See light_panel.h.
#include "app/gui/panels/light_panel.h"

#include <QColorDialog>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/edit/field_form.h"
#include "app/gui/edit/probe_fields.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/math/cube/srgb.h"
#include "filters/math/shared/display_math.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

glm::vec3 linearOf(const QColor& shown) {
  const auto linear = [](int byte) { return linearOfSrgb(static_cast<std::uint8_t>(byte)); };
  return {linear(shown.red()), linear(shown.green()), linear(shown.blue())};
}

/// As the light is shown, its brightest component being white.
QColor shownColor(const glm::vec3& color) {
  const float brightest = std::max({color.x, color.y, color.z, 1e-6F});
  const glm::vec3 c = color / brightest;
  return {displayByte(c.x), displayByte(c.y), displayByte(c.z)};
}

QString lightTypeName(LightType type) {
  if (type == LightType::Directional) return LightPanel::tr("directional");
  return type == LightType::Point ? LightPanel::tr("point") : LightPanel::tr("spot");
}

void placeByCamera(Light& light, const Camera& camera) {
  const glm::dvec3 ahead = glm::normalize(camera.target - camera.position);
  if (light.type != LightType::Point) light.direction = ahead;
  if (light.type != LightType::Directional) light.position = camera.position;
}

}  // namespace

LightPanel::LightPanel(Workspace& workspace) : workspace_(workspace), editor_(workspace.editor()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  form_ = addSection(this, tr("Sky and lights"));
  addSky(form_);
  addPlace(form_);
  addShadows(form_);
  workspace.changes().add("light panel", {&Changes::lights, &Changes::sky}, [this](const Changes&) { update(); });
  update();
}

void LightPanel::addSky(QFormLayout* form) {
  const auto& turn = fieldNamed(anySkyFields(), "rotationDegrees");
  turn_ = new ValueField(fieldFormat(turn, 5.0, 1), this);
  turn_->setObjectName("skyTurn");
  const QString tip = fieldTip(turn);
  turn_->setToolTip(tip);
  addRow(form, tr("Sky turned by"), turn_, tip);
  const auto turned = [](double value) { return [value](Scene& scene) { scene.skyRotationDegrees = value; }; };
  connect(turn_, &ValueField::previewed, this,
          [this, turned](double value) { editor_.preview({turn_}, tr("Turn the sky"), turned(value)); });
  connect(turn_, &ValueField::committed, this,
          [this, turned](double value) { editor_.commit({turn_}, tr("Turn the sky"), turned(value)); });
  const auto& view = fieldNamed(skyImageFields(), "cubeView");
  skyView_ = addProbeChoice(form, tr("Faces seen from"), choicesOf(view, {tr("Outside"), tr("Inside")}), fieldTip(view),
                            [this](int value) {
                              editor_.commit({skyView_}, tr("Set view of the sky's faces"), [value](Scene& scene) {
                                auto* image = std::get_if<SkyImage>(&scene.sky);
                                if (image != nullptr) image->cubeView = static_cast<CubeView>(value);
                              });
                            });
  skyView_->setObjectName("skyView");
  const auto& sun = fieldNamed(skyImageFields(), "sun");
  skySun_ = addProbeChoice(form, tr("Its sun"), choicesOf(sun, {tr("As a light"), tr("In the picture")}), fieldTip(sun),
                           [this](int value) {
                             editor_.commit({skySun_}, tr("Set the sky's sun"), [value](Scene& scene) {
                               auto* image = std::get_if<SkyImage>(&scene.sky);
                               if (image != nullptr) image->sun = static_cast<SkySunForm>(value);
                             });
                           });
  skySun_->setObjectName("skySun");
  const auto& lamps = fieldNamed(sceneFields(), "lamps");
  lamps_ = addProbeChoice(form, tr("Lamps"),
                          {{tr("As shapes"), static_cast<int>(LampForm::Shapes), choiceTip(lamps, LampForm::Shapes)},
                           {tr("In the map"), static_cast<int>(LampForm::InMap), choiceTip(lamps, LampForm::InMap)}},
                          fieldTip(lamps), [this](int value) {
                            editor_.commit({lamps_}, tr("Set lamps"),
                                           [value](Scene& scene) { scene.lamps = static_cast<LampForm>(value); });
                          });
  lamps_->setObjectName("lamps");
}

void LightPanel::addPlace(QFormLayout* form) {
  lights_ = new QuietCombo(this);
  lights_->setObjectName("light");
  addRow(form, tr("Light"), lights_, tr("Lights in the order of the scene file"));
  connect(lights_, QOverload<int>::of(&QComboBox::activated), this, &LightPanel::update);
  addButtons(form);
  const auto& direction = lightField("direction");
  const QString tip = tr("Directional: %1 Others: %2").arg(fieldTip(direction), fieldTip(lightField("position")));
  place_ = new VectorRow(fieldFormat(direction, 0.05, 3), tip, this);
  addRow(form, tr("Direction"), place_, tip);
  const auto moved = [](int axis, double value) {
    return [axis, value](Light& light) {
      glm::dvec3& v = light.type == LightType::Directional ? light.direction : light.position;
      v[axis] = value;
    };
  };
  connect(place_, &VectorRow::previewed, this,
          [this, moved](int axis, double value) { edit(place_, true, tr("place"), moved(axis, value)); });
  connect(place_, &VectorRow::committed, this,
          [this, moved](int axis, double value) { edit(place_, false, tr("place"), moved(axis, value)); });
  intensity_ = new ValueField(fieldFormat(lightField("intensity"), 0.25, 3), this);
  addRow(form, tr("Intensity"), intensity_, fieldTip(lightField("intensity")));
  const auto brighter = [](double value) {
    return [value](Light& light) { light.intensity = static_cast<float>(value); };
  };
  connect(intensity_, &ValueField::previewed, this,
          [this, brighter](double value) { edit(intensity_, true, tr("intensity"), brighter(value)); });
  connect(intensity_, &ValueField::committed, this,
          [this, brighter](double value) { edit(intensity_, false, tr("intensity"), brighter(value)); });
}

void LightPanel::addButtons(QFormLayout* form) {
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  auto* add = new QPushButton(tr("Add"), line);
  add->setObjectName("addLight");
  add->setToolTip(tr("Adds a light where the camera is, shining the way it looks"));
  auto* kinds = new QMenu(add);
  for (const LightType type : {LightType::Directional, LightType::Point, LightType::Spot}) {
    connect(kinds->addAction(lightTypeName(type)), &QAction::triggered, this, [this, type] { addLight(type); });
  }
  add->setMenu(kinds);
  aim_ = new QPushButton(tr("As the view"), line);
  aim_->setObjectName("aimLight");
  aim_->setToolTip(tr("Puts the light where the camera is and aims it the way the camera looks"));
  remove_ = new QPushButton(tr("Delete"), line);
  remove_->setObjectName("deleteLight");
  remove_->setToolTip(tr("Removes this light"));
  for (QPushButton* button : {add, aim_, remove_}) row->addWidget(button);
  row->addStretch(1);
  form->addRow(QString(), line);
  connect(aim_, &QPushButton::clicked, this, &LightPanel::aimByView);
  connect(remove_, &QPushButton::clicked, this, &LightPanel::removeLight);
  color_ = new QPushButton(this);
  color_->setObjectName("lightColor");
  addRow(form, tr("Color"), color_, fieldTip(lightField("color")));
  connect(color_, &QPushButton::clicked, this, [this] {
    const Light* of = light();
    if (of == nullptr) return;
    const QColor chosen = QColorDialog::getColor(shownColor(of->color), this, tr("Color of the light"));
    if (chosen.isValid()) setColor(chosen);
  });
}

void LightPanel::addLight(LightType type) {
  const Camera camera = workspace_.renderer().currentCamera();
  Light added;
  added.type = type;
  added.color = glm::vec3(1.0F);
  // Bright enough to be seen at the exposure as it is.
  constexpr double kBright = 3.0;
  added.intensity = static_cast<float>(kBright / std::max(editor_.scene().exposure, 1e-6));
  placeByCamera(added, camera);
  editor_.commit(tr("Add %1 light").arg(lightTypeName(type)), [added](Scene& scene) { scene.lights.push_back(added); });
  lights_->setCurrentIndex(lights_->count() - 1);
  update();
}

void LightPanel::removeLight() {
  const auto at = index();
  if (!at) return;
  editor_.commit(tr("Delete light %1").arg(static_cast<int>(*at) + 1), [at](Scene& scene) {
    if (*at < scene.lights.size()) scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(*at));
  });
}

void LightPanel::aimByView() {
  const Camera camera = workspace_.renderer().currentCamera();
  commit(tr("place"), [camera](Light& light) { placeByCamera(light, camera); });
}

void LightPanel::setColor(const QColor& color) {
  commit(tr("color"), [color](Light& light) {
    const float brightest = std::max({light.color.x, light.color.y, light.color.z, 1e-6F});
    light.color = brightest * linearOf(color);
  });
}

ValueField* LightPanel::addNumber(QFormLayout* form, const QString& text, const char* key, double step, int decimals,
                                  double Light::*member) {
  const auto& row = lightField(key);
  const QString toolTip = fieldTip(row);
  auto* field = new ValueField(fieldFormat(row, step, decimals), this);
  field->setToolTip(toolTip);
  addRow(form, text, field, toolTip);
  connect(field, &ValueField::previewed, this,
          [=](double value) { edit(field, true, text, [=](Light& light) { light.*member = value; }); });
  connect(field, &ValueField::committed, this,
          [=](double value) { edit(field, false, text, [=](Light& light) { light.*member = value; }); });
  return field;
}

void LightPanel::addShadows(QFormLayout* form) {
  const auto& shadows = lightField("shadows");
  const auto& level = lightField("shadowLevel");
  shadows_ = addProbeChoice(form, tr("Shadows"),
                            {{tr("None"), 0, choiceTip(shadows, 0)},
                             {tr("By coverage"), 1, choiceTip(shadows, 1)},
                             {tr("By coverage, and for moving objects"), 2, choiceTip(shadows, 2)}},
                            fieldTip(shadows), [this](int value) {
                              commit(tr("shadows"),
                                     [value](Light& light) { light.shadows = static_cast<LightShadows>(value); });
                            });
  shadows_->setObjectName("lightShadows");
  angle_ = addNumber(form, tr("Angle"), "angleDegrees", 0.25, 2, &Light::angleDegrees);
  angle_->setObjectName("lightAngle");
  radius_ = addNumber(form, tr("Radius"), "radius", 0.05, 3, &Light::radius);
  level_ = addProbeChoice(
      form, tr("Softness"), {{tr("By size"), 0, choiceTip(level, 0)}, {tr("By distance"), 1, choiceTip(level, 1)}},
      fieldTip(level), [this](int value) {
        commit(tr("softness"), [value](Light& light) { light.shadowLevel = static_cast<ShadowLevel>(value); });
      });
  perUnit_ = addNumber(form, tr("Levels per metre"), "levelsPerUnit", 0.05, 3, &Light::levelsPerUnit);
}

void LightPanel::showRow(QWidget* field, bool shown) {
  field->setVisible(shown);
  if (QWidget* label = form_->labelForField(field)) label->setVisible(shown);
}

std::optional<std::size_t> LightPanel::index() const {
  const int row = lights_->currentIndex();
  const std::size_t count = editor_.scene().lights.size();
  if (count == 0) return std::nullopt;
  return row < 0 ? 0 : std::min(static_cast<std::size_t>(row), count - 1);
}

void LightPanel::choose(std::size_t index) {
  if (index < editor_.scene().lights.size()) lights_->setCurrentIndex(static_cast<int>(index));
  update();
}

const Light* LightPanel::light() const {
  const auto at = index();
  return at ? &editor_.scene().lights[*at] : nullptr;
}

QString LightPanel::label(const QString& what) const {
  return tr("Set %1 of light %2").arg(what.toLower()).arg(static_cast<int>(index().value_or(0)) + 1);
}

void LightPanel::commit(const QString& what, const LightEdit& change) {
  edit(nullptr, false, what, change);
}

void LightPanel::edit(const void* control, bool preview, const QString& what, const LightEdit& change) {
  const auto at = index();
  if (!at) return;
  const Document::Edit whole = [at, change](Scene& scene) {
    if (*at < scene.lights.size()) change(scene.lights[*at]);
  };
  const EditToken token{control, 0, std::to_string(*at)};
  preview ? editor_.preview(token, label(what), whole) : editor_.commit(token, label(what), whole);
}

void LightPanel::update() {
  const Scene& scene = editor_.scene();
  turn_->show(scene.skyRotationDegrees);
  const auto* image = std::get_if<SkyImage>(&scene.sky);
  showRow(skyView_, image != nullptr);
  if (image != nullptr) showChoice(skyView_, static_cast<int>(image->cubeView));
  showRow(skySun_, image != nullptr);
  if (image != nullptr) showChoice(skySun_, static_cast<int>(image->sun));
  showChoice(lamps_, static_cast<int>(scene.lamps));
  if (lights_->count() != static_cast<int>(scene.lights.size())) {
    const QSignalBlocker quiet(lights_);
    const int row = std::max(lights_->currentIndex(), 0);
    lights_->clear();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      lights_->addItem(tr("%1: %2").arg(static_cast<int>(i) + 1).arg(lightTypeName(scene.lights[i].type)));
    }
    lights_->setCurrentIndex(std::min(row, lights_->count() - 1));
  }
  const Light* of = light();
  for (QWidget* field : std::initializer_list<QWidget*>{lights_, place_, aim_, remove_, color_, intensity_, shadows_,
                                                        angle_, radius_, level_, perUnit_})
    field->setEnabled(of != nullptr);
  if (of == nullptr) return;
  const bool directional = of->type == LightType::Directional, shadowed = of->shadows != LightShadows::None;
  if (auto* label = qobject_cast<QLabel*>(form_->labelForField(place_))) {
    label->setText(directional ? tr("Direction") : tr("Position"));
  }
  QPixmap swatch(32, 14);
  swatch.fill(shownColor(of->color));
  color_->setIcon(QIcon(swatch));
  color_->setIconSize(swatch.size());
  place_->show(directional ? of->direction : of->position);
  intensity_->show(static_cast<double>(of->intensity));
  showChoice(shadows_, static_cast<int>(of->shadows));
  angle_->show(of->angleDegrees);
  radius_->show(of->radius);
  showChoice(level_, static_cast<int>(of->shadowLevel));
  perUnit_->show(of->levelsPerUnit);
  showRow(angle_, shadowed && directional);
  showRow(radius_, shadowed && !directional);
  showRow(level_, shadowed);
  showRow(perUnit_, shadowed && of->shadowLevel == ShadowLevel::Distance);
}

}  // namespace boxprobe
