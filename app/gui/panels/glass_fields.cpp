// See glass_fields.h.
#include "app/gui/panels/glass_fields.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/edit/field_form.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/scene/material_override.h"

namespace boxprobe {

GlassFields::GlassFields(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Glass"));
  transmission_ = addNumber(form, tr("Transmission"), "transmission", 0.1);
  ior_ = addNumber(form, tr("Index"), "ior", 0.01);
  form_ = new QuietCombo(this);
  form_->setObjectName("glassForm");
  for (const QString& name : {tr("Automatic"), tr("One-pass"), tr("Two-pass"), tr("Two-interface")}) {
    form_->addItem(name);
    form_->setItemData(form_->count() - 1, choiceTip(materialField("glass"), form_->count() - 1), Qt::ToolTipRole);
  }
  addRow(form, tr("Form"), form_, fieldTip(materialField("glass")));
  thin_ = new QCheckBox(tr("Thin sheet"), this);
  thin_->setObjectName("thin");
  thin_->setToolTip(fieldTip(materialField("thin")));
  form->addRow(QString(), thin_);
  thickness_ = addNumber(form, tr("Thickness"), "thickness", 0.05);
  distance_ = addNumber(form, tr("Absorption"), "attenuationDistance", 0.05);
  const QString colorTip = fieldTip(materialField("attenuationColor"));
  color_ = new VectorRow(fieldFormat(materialField("attenuationColor"), 0.05, 3), colorTip, this, "RGB");
  color_->setObjectName("attenuationColor");
  addRow(form, tr("Color"), color_, colorTip);
  reset_ = new QPushButton(tr("Glass as in the model"), this);
  reset_->setToolTip(tr("Removes the scene's values above; those in the model file apply again"));
  form->addRow(QString(), reset_);

  connect(form_, QOverload<int>::of(&QComboBox::activated), this, [this](int row) {
    commit(nullptr, tr("form"), [row](MaterialOverride& m) { m.glass = static_cast<GlassForm>(row); });
  });
  connect(thin_, &QCheckBox::clicked, this,
          [this](bool thin) { commit(nullptr, tr("thinness"), [thin](MaterialOverride& m) { m.thin = thin; }); });
  const auto edited = [this](int axis, double value) {
    glm::vec3 color = shownColor();
    color[axis] = static_cast<float>(value);
    return [color](MaterialOverride& m) { m.attenuationColor = color; };
  };
  connect(color_, &VectorRow::previewed, this,
          [this, edited](int axis, double value) { preview(color_, tr("absorption color"), edited(axis, value)); });
  connect(color_, &VectorRow::committed, this,
          [this, edited](int axis, double value) { commit(color_, tr("absorption color"), edited(axis, value)); });
  connect(reset_, &QPushButton::clicked, this, [this] {
    commit(nullptr, tr("glass"), [](MaterialOverride& m) {
      m.transmission.reset();
      m.ior.reset();
      m.thickness.reset();
      m.attenuationDistance.reset();
      m.attenuationColor.reset();
      m.thin.reset();
      m.glass.reset();
    });
  });
}

ValueField* GlassFields::addNumber(QFormLayout* form, const QString& name, const char* key, double step) {
  const auto& row = materialField(key);
  auto* field = new ValueField(fieldFormat(row, step, 3), this);
  field->setObjectName(key);
  addRow(form, name, field, fieldTip(row));
  const QString what = name.toLower();
  const auto edit = [&row](MaterialOverride& m, double value) { row.set(m, static_cast<float>(value)); };
  connect(field, &ValueField::previewed, this, [this, field, what, edit](double value) {
    preview(field, what, [edit, value](MaterialOverride& m) { edit(m, value); });
  });
  connect(field, &ValueField::committed, this, [this, field, what, edit](double value) {
    commit(field, what, [edit, value](MaterialOverride& m) { edit(m, value); });
  });
  return field;
}

void GlassFields::preview(const void* control, const QString& what,
                          const std::function<void(MaterialOverride&)>& edit) {
  editor_.preview({control, 0, name_}, tr("Set %1 of %2").arg(what, QString::fromStdString(name_)),
                  [name = name_, edit](Scene& scene) { edit(scene.materials[name]); });
}

void GlassFields::commit(const void* control, const QString& what, const std::function<void(MaterialOverride&)>& edit) {
  editor_.commit({control, 0, name_}, tr("Set %1 of %2").arg(what, QString::fromStdString(name_)),
                 [name = name_, edit](Scene& scene) {
                   edit(scene.materials[name]);
                   if (scene.materials[name] == MaterialOverride{}) scene.materials.erase(name);
                 });
}

glm::vec3 GlassFields::shownColor() const {
  return glm::vec3(color_->field(0)->value(), color_->field(1)->value(), color_->field(2)->value());
}

void GlassFields::enable(bool transmits, bool thin) {
  for (QWidget* field : {static_cast<QWidget*>(form_), static_cast<QWidget*>(thin_)}) field->setEnabled(transmits);
  for (QWidget* field :
       {static_cast<QWidget*>(thickness_), static_cast<QWidget*>(distance_), static_cast<QWidget*>(color_)}) {
    field->setEnabled(transmits && !thin);
  }
}

void GlassFields::show(const std::string& name, const Material& model) {
  name_ = name;
  model_ = model;
  const Material now = overriddenMaterial(model, editor_.scene());
  transmission_->show(static_cast<double>(now.transmission));
  ior_->show(static_cast<double>(now.ior));
  thickness_->show(static_cast<double>(now.thickness));
  distance_->show(static_cast<double>(now.attenuationDistance));
  color_->show(glm::dvec3(now.attenuationColor));
  const QSignalBlocker quietForm(form_), quietThin(thin_);
  form_->setCurrentIndex(static_cast<int>(now.glass));
  thin_->setChecked(now.thin);
  enable(now.transmits(), now.thin);
  const auto own = editor_.scene().materials.find(name);
  const MaterialOverride* o = own != editor_.scene().materials.end() ? &own->second : nullptr;
  reset_->setEnabled(o != nullptr && (o->transmission || o->ior || o->thickness || o->attenuationDistance ||
                                      o->attenuationColor || o->thin || o->glass));
}

}  // namespace boxprobe
