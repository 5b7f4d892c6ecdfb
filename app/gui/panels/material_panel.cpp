// See material_panel.h.
#include "app/gui/panels/material_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/field_form.h"
#include "app/gui/panels/glass_fields.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/quiet_slider.h"
#include "app/gui/widgets/value_field.h"

namespace boxprobe {

namespace {

constexpr int kSliderSteps = 200;

Document::Edit roughnessEdit(const std::string& name, double roughness) {
  return [name, roughness](Scene& scene) { scene.materials[name].roughness = static_cast<float>(roughness); };
}

}  // namespace

MaterialPanel::MaterialPanel(Workspace& workspace)
    : editor_(workspace.editor()),
      materials_(new QuietCombo(this)),
      slider_(new QuietSlider(Qt::Horizontal, this)),
      field_(new ValueField(fieldFormat(materialField("roughness"), 0.01, 3), this)),
      reset_(new QPushButton(tr("Reset to the model's own"), this)),
      glass_(new GlassFields(workspace.editor(), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Material"));
  addRow(form, tr("Name"), materials_, tr("Material of the model, by its name in the file"));
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(field_);
  const QString tip = fieldTip(materialField("roughness"));
  materials_->setObjectName("material");
  slider_->setObjectName("roughness");
  slider_->setRange(0, kSliderSteps);
  slider_->setToolTip(tip);
  field_->setToolTip(tip);
  addRow(form, tr("Roughness"), line, tip);
  reset_->setToolTip(tr("Removes the scene's value; the value in the model file applies again"));
  form->addRow(QString(), reset_);
  layout->addWidget(glass_);

  connect(materials_, QOverload<int>::of(&QComboBox::activated), this, &MaterialPanel::update);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const double roughness = static_cast<double>(value) / kSliderSteps;
    slider_->isSliderDown() ? preview(roughness) : commit(roughness);
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] { editor_.finish(); });
  connect(field_, &ValueField::previewed, this, &MaterialPanel::preview);
  connect(field_, &ValueField::committed, this, &MaterialPanel::commit);
  connect(reset_, &QPushButton::clicked, this, [this] {
    const std::string name = material();
    editor_.commit(tr("Reset roughness of %1").arg(QString::fromStdString(name)), [name](Scene& scene) {
      MaterialOverride& changed = scene.materials[name];
      changed.roughness.reset();
      if (changed == MaterialOverride{}) scene.materials.erase(name);
    });
  });
  connect(&workspace, &Workspace::modelsReplaced, this, [this, &workspace] { setModels(workspace.models()); });
  workspace.changes().add("material panel", {&Changes::materials, &Changes::models},
                          [this](const Changes&) { update(); });
  update();
}

void MaterialPanel::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  known_.clear();
  materials_->clear();
  for (const auto& model : models) {
    for (const Material& material : model->materials) {
      const auto same = [&](const Material& known) { return known.name == material.name; };
      if (material.name.empty() || std::any_of(known_.begin(), known_.end(), same)) continue;
      known_.push_back(material);
      for (TextureUse* use : known_.back().textures()) *use = {};
      materials_->addItem(QString::fromStdString(material.name));
    }
  }
  update();
}

std::string MaterialPanel::material() const {
  return materials_->currentText().toStdString();
}

float MaterialPanel::modelRoughness() const {
  const auto row = static_cast<std::size_t>(std::max(materials_->currentIndex(), 0));
  return row < known_.size() ? known_[row].roughness : 1.0f;
}

QString MaterialPanel::label() const {
  return tr("Set roughness of %1").arg(materials_->currentText());
}

void MaterialPanel::preview(double roughness) {
  editor_.preview({this, 0, material()}, label(), roughnessEdit(material(), roughness));
}

void MaterialPanel::commit(double roughness) {
  editor_.commit({this, 0, material()}, label(), roughnessEdit(material(), roughness));
}

void MaterialPanel::update() {
  setEnabled(!known_.empty());
  const auto& overrides = editor_.scene().materials;
  const auto own = overrides.find(material());
  const bool overridden = own != overrides.end() && own->second.roughness;
  const double roughness = overridden ? *own->second.roughness : modelRoughness();
  field_->show(roughness);
  const QSignalBlocker quiet(slider_);
  if (!slider_->isSliderDown()) slider_->setValue(static_cast<int>(std::lround(roughness * kSliderSteps)));
  reset_->setEnabled(overridden);
  const auto row = static_cast<std::size_t>(std::max(materials_->currentIndex(), 0));
  if (row < known_.size()) glass_->show(known_[row].name, known_[row]);
}

bool MaterialPanel::choose(const std::string& name) {
  const int row = materials_->findText(QString::fromStdString(name));
  if (row < 0) return false;
  materials_->setCurrentIndex(row);
  update();
  return true;
}

}  // namespace boxprobe
