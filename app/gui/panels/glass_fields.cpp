// See glass_fields.h.
#include "app/gui/panels/glass_fields.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/scene/material_override.h"

namespace boxprobe {

namespace {

// The greatest index of a common clear solid is diamond's, 2.42; some minerals reach 3.
constexpr double kMostIor = 4.0, kLeastIor = 0.25;

}  // namespace

GlassFields::GlassFields(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Glass"));
  transmission_ = addNumber(form, tr("Transmission"), "transmission", 0.0, 1.0, 0.1, {},
                            tr("Share of light that passes the surface in place of being scattered: 1 is glass"),
                            [](MaterialOverride& m, double value) { m.transmission = static_cast<float>(value); });
  ior_ = addNumber(form, tr("Index"), "ior", kLeastIor, kMostIor, 0.01, {},
                   tr("Index of refraction, n2 over n1: 1 bends nothing, water 1.33, glass 1.5, diamond 2.42; below 1 "
                      "what is around it is the denser"),
                   [](MaterialOverride& m, double value) { m.ior = static_cast<float>(value); });
  form_ = new QuietCombo(this);
  form_->setObjectName("glassForm");
  const std::pair<QString, QString> forms[] = {
      {tr("Automatic"),
       tr("Two-interface where the object's shell describes it; as thin walls where it is hollow; else two-pass")},
      {tr("One-pass"), tr("Bent once, at the front, then looked up: the published form")},
      {tr("Two-pass"), tr("The same of the back faces first, and the front faces blended over them: published, too")},
      {tr("Two-interface"), tr("Followed through the object by its shell: bent at the front and where it leaves")}};
  for (const auto& [name, tip] : forms) {
    form_->addItem(name);
    form_->setItemData(form_->count() - 1, tip, Qt::ToolTipRole);
  }
  addRow(form, tr("Form"), form_, tr("How the light's way through is found. Default: automatic"));
  thin_ = new QCheckBox(tr("Thin sheet"), this);
  thin_->setObjectName("thin");
  thin_->setToolTip(tr("A pane: reflects with both faces, bends nothing, absorbs nothing"));
  form->addRow(QString(), thin_);
  thickness_ = addNumber(form, tr("Thickness"), "thickness", 0.0, 1e4, 0.05, " m",
                         tr("The way within, for the forms that do not find it; two-interface finds the true one"),
                         [](MaterialOverride& m, double value) { m.thickness = static_cast<float>(value); });
  distance_ = addNumber(form, tr("Absorption"), "attenuationDistance", 0.0, 1e6, 0.05, " m",
                        tr("White light has the colour below left after so far; 0: nothing is absorbed"),
                        [](MaterialOverride& m, double value) { m.attenuationDistance = static_cast<float>(value); });
  const QString colorTip = tr("left of white light after the absorption distance (Beer's law)");
  color_ = new VectorRow({0.0, 1.0, 0.05, 3, ""}, colorTip, this, "RGB");
  color_->setObjectName("attenuationColor");
  addRow(form, tr("Color"), color_, colorTip);
  reset_ = new QPushButton(tr("Glass as in the model"), this);
  reset_->setToolTip(tr("Removes the scene's own values above; those in the model file count again"));
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

ValueField* GlassFields::addNumber(QFormLayout* form, const QString& name, const char* id, double minimum,
                                   double maximum, double step, const QString& suffix, const QString& tip, Edit edit) {
  auto* field = new ValueField({minimum, maximum, step, 3, suffix}, this);
  field->setObjectName(id);
  addRow(form, name, field, tip);
  const QString what = name.toLower();
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
