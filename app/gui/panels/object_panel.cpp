// See object_panel.h.
#include "app/gui/panels/object_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/edit/field_form.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/base/field_error.h"
#include "filters/core/geometry/mirror_plane.h"

namespace boxprobe {

ObjectPanel::ObjectPanel(Workspace& workspace)
    : editor_(workspace.editor()),
      nodes_(new QuietCombo(this)),
      dynamic_(new QCheckBox(tr("Moving object: baked probes do not capture it"), this)),
      position_(
          new VectorRow(fieldFormat(objectField("translation"), 0.05, 3), fieldTip(objectField("translation")), this)),
      rotation_(new VectorRow(fieldFormat(objectField("rotationDegrees"), 5.0, 1),
                              fieldTip(objectField("rotationDegrees")), this)),
      mirror_(new QCheckBox(tr("Reflects objects that move"), this)),
      mirrorPart_(new QWidget(this)),
      maxRoughness_(new ValueField(fieldFormat(mirrorField("maxRoughness"), 0.05, 3), this)),
      resolution_(new ValueField(fieldFormat(mirrorField("resolution"), 0.25, 2), this)),
      problem_(helpLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Object"));
  nodes_->setObjectName("object");
  dynamic_->setObjectName("dynamic");
  position_->setObjectName("objectPosition");
  rotation_->setObjectName("objectRotation");
  addRow(form, tr("Name"), nodes_, tr("Object of the model, by its node's name in the file"));
  dynamic_->setToolTip(fieldTip(objectField("dynamic")));
  form->addRow(QString(), dynamic_);
  addRow(form, tr("Moved by"), position_, fieldTip(objectField("translation")));
  addRow(form, tr("Turned by"), rotation_, fieldTip(objectField("rotationDegrees")));

  QFormLayout* plane = addSection(this, tr("Planar mirror"));
  mirror_->setObjectName("planarMirror");
  mirror_->setToolTip(
      tr("A second, mirrored camera draws moving objects over what the probes reflect. One flat surface only"));
  plane->addRow(QString(), mirror_);
  auto* part = new QFormLayout(mirrorPart_);
  part->setContentsMargins(0, 0, 0, 0);
  maxRoughness_->setObjectName("mirrorMaxRoughness");
  resolution_->setObjectName("mirrorResolution");
  addRow(part, tr("Roughness limit"), maxRoughness_, fieldTip(mirrorField("maxRoughness")));
  addRow(part, tr("Texels per pixel"), resolution_, fieldTip(mirrorField("resolution")));
  plane->addRow(mirrorPart_);
  problem_->setObjectName("mirrorProblem");
  plane->addRow(problem_);

  connect(nodes_, QOverload<int>::of(&QComboBox::activated), this, &ObjectPanel::update);
  connect(dynamic_, &QCheckBox::clicked, this, [this](bool on) {
    editor_.commit(label(tr("Set whether %1 moves")), objectEdit([on](ObjectOverride& o) { o.dynamic = on; }));
  });
  connect(mirror_, &QCheckBox::clicked, this, &ObjectPanel::makeMirror);
  connectVector(position_, tr("Move %1"), &ObjectOverride::translation);
  connectVector(rotation_, tr("Turn %1"), &ObjectOverride::rotationDegrees);
  connectNumber(maxRoughness_, tr("Set roughness limit of mirror %1"), &PlanarMirror::maxRoughness);
  connectNumber(resolution_, tr("Set resolution of mirror %1"), &PlanarMirror::resolution);
  connect(&workspace, &Workspace::modelsReplaced, this, [this, &workspace] { setModels(workspace.models()); });
  workspace.changes().add("object panel", {&Changes::objects, &Changes::models}, [this](const Changes&) { update(); });
  update();
}

void ObjectPanel::connectVector(VectorRow* row, const QString& pattern, glm::dvec3 ObjectOverride::*field) {
  const auto edit = [this, field](int axis, double value) {
    return objectEdit([=](ObjectOverride& object) { (object.*field)[axis] = value; });
  };
  connect(row, &VectorRow::previewed, this, [=](int axis, double value) {
    editor_.preview({row, 0, node()}, label(pattern), edit(axis, value));
  });
  connect(row, &VectorRow::committed, this, [=](int axis, double value) {
    editor_.commit({row, 0, node()}, label(pattern), edit(axis, value));
  });
}

void ObjectPanel::connectNumber(ValueField* field, const QString& pattern, double PlanarMirror::*member) {
  const auto edit = [this, member](double value) {
    return mirrorEdit([=](PlanarMirror& mirror) { mirror.*member = value; });
  };
  connect(field, &ValueField::previewed, this, [=](double value) {
    editor_.preview({field, 0, node()}, label(pattern), edit(value));
  });
  connect(field, &ValueField::committed, this, [=](double value) {
    editor_.commit({field, 0, node()}, label(pattern), edit(value));
  });
}

void ObjectPanel::makeMirror(bool on) {
  editor_.commit(label(on ? tr("Make %1 a mirror") : tr("Switch mirror %1 off")),
                 mirrorEdit([on](PlanarMirror& mirror) { mirror.enabled = on; }));
}

Document::Edit ObjectPanel::objectEdit(const std::function<void(ObjectOverride&)>& change) const {
  return [name = node(), change](Scene& scene) {
    ObjectOverride& object = scene.objects[name];
    change(object);
    if (object == ObjectOverride{}) scene.objects.erase(name);
  };
}

Document::Edit ObjectPanel::mirrorEdit(const std::function<void(PlanarMirror&)>& change) const {
  return [name = node(), change](Scene& scene) { change(scene.mirrors[name]); };
}

std::string ObjectPanel::node() const {
  return nodes_->currentText().toStdString();
}

QString ObjectPanel::label(const QString& pattern) const {
  return pattern.arg(nodes_->currentText());
}

void ObjectPanel::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  models_ = models;
  checkedNode_.clear();
  std::vector<std::string> names;
  for (const auto& model : models) {
    for (const Instance& instance : model->instances) {
      if (!instance.node.empty()) names.push_back(instance.node);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  nodes_->clear();
  for (const std::string& name : names) nodes_->addItem(QString::fromStdString(name));
  fresh_ = true;
  update();
}

// Only a flat surface can be one; said before it is asked for.
void ObjectPanel::showPlane() {
  const Scene& scene = editor_.scene();
  const auto object = scene.objects.find(node());
  const ObjectOverride place = object != scene.objects.end() ? object->second : ObjectOverride{};
  if (checkedNode_ != node() || !(checkedPlace_ == place)) {
    checkedNode_ = node();
    checkedPlace_ = place;
    QString problem;
    try {
      mirrorPlane(scene, models_, node());
    } catch (const FieldError&) {
      problem = tr("It is not one flat surface, so it cannot be a planar mirror.");
    }
    problem_->setText(problem);
  }
  problem_->setVisible(!problem_->text().isEmpty());
}

void ObjectPanel::update() {
  setEnabled(nodes_->count() > 0);
  if (nodes_->count() == 0) return;
  const Scene& scene = editor_.scene();
  // One that moves is what this panel is mostly opened for; the models come before their scene.
  for (const auto& [name, object] : scene.objects) {
    if (!fresh_ || !object.dynamic || nodes_->findText(QString::fromStdString(name)) < 0) continue;
    nodes_->setCurrentText(QString::fromStdString(name));
    fresh_ = false;
  }
  const auto object = scene.objects.find(node());
  const ObjectOverride settings = object != scene.objects.end() ? object->second : ObjectOverride{};
  dynamic_->setChecked(settings.dynamic);
  position_->show(settings.translation);
  rotation_->show(settings.rotationDegrees);
  const auto mirror = scene.mirrors.find(node());
  const bool is = mirror != scene.mirrors.end() && mirror->second.enabled;
  showPlane();
  mirror_->setChecked(is);
  mirror_->setEnabled(is || problem_->text().isEmpty());
  mirrorPart_->setVisible(is);
  if (mirror == scene.mirrors.end()) return;
  maxRoughness_->show(mirror->second.maxRoughness);
  resolution_->show(mirror->second.resolution);
}

bool ObjectPanel::choose(const std::string& name) {
  const int row = nodes_->findText(QString::fromStdString(name));
  if (row < 0) return false;
  nodes_->setCurrentIndex(row);
  fresh_ = false;
  update();
  return true;
}

}  // namespace boxprobe
