// See probe_panel.h.
#include "app/gui/panels/probe_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/handles/probe_frame.h"
#include "app/gui/panels/blend_row.h"
#include "app/gui/panels/technique_chooser.h"
#include "app/gui/panels/technique_parameters_panel.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/vector_row.h"

namespace boxprobe {

namespace {

const ValueField::Format kMetres{-1e7, 1e7, 0.1, 3, " m"};
const ValueField::Format kLength{0.0, 1e7, 0.05, 3, " m"};
const ValueField::Format kDegrees{-360.0, 360.0, 5.0, 1, "°"};
const ValueField::Format kFactor{0.0, 1000.0, 0.05, 2, ""};
const ValueField::Format kLevel{0.0, 1000.0, 1.0, 2, ""};

QString boxSizeText(const Box& box) {
  const glm::dvec3 s = box.size();
  return QString("%1 × %2 × %3 m").arg(s.x, 0, 'f', 3).arg(s.y, 0, 'f', 3).arg(s.z, 0, 'f', 3);
}

/// The box with one number replaced, the two sides kept apart.
Box withSide(Box box, bool maximum, int axis, double value) {
  if (maximum) {
    box.max[axis] = std::max(value, box.min[axis]);
  } else {
    box.min[axis] = std::min(value, box.max[axis]);
  }
  return box;
}

}  // namespace

ProbePanel::ProbePanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  buildPlace();
  buildInfluence();
  buildLook();
  // What a field is called from outside: by style sheets and tests.
  const std::pair<QWidget*, const char*> names[] = {{origin_, "origin"},
                                                    {boxMin_, "boxMin"},
                                                    {boxMax_, "boxMax"},
                                                    {rotation_, "rotation"},
                                                    {blend_, "blendDistance"},
                                                    {importance_, "importance"},
                                                    {intensity_, "intensity"},
                                                    {technique_, "technique"},
                                                    {techniqueHelp_, "techniqueHelp"},
                                                    {projection_, "projection"},
                                                    {ownInfluence_, "influence"},
                                                    {bevelRadius_, "bevel"},
                                                    {bevelFromRoughness_, "bevelFromRoughness"},
                                                    {occluded_, "occlusion"},
                                                    {occlusionMultiplier_, "occlusionMultiplier"},
                                                    {occlusionPower_, "occlusionPower"},
                                                    {occlusionStrength_, "occlusionStrength"}};
  for (const auto& [widget, name] : names) widget->setObjectName(name);
  update();
}

QString ProbePanel::label(const QString& what) const {
  return probeEditLabel(editor_, what);
}

void ProbePanel::connectVector(VectorRow* row, const QString& what, const VectorEdit& edit) {
  const auto labelFor = [this, what](int axis) { return label(what + " " + QString("XYZ"[axis])); };
  connect(row, &VectorRow::previewed, this, [this, row, labelFor, edit](int axis, double value) {
    editor_.previewProbe({row, axis}, labelFor(axis), [=](Probe& probe) { edit(probe, axis, value); });
  });
  connect(row, &VectorRow::committed, this, [this, row, labelFor, edit](int axis, double value) {
    editor_.commitProbe({row, axis}, labelFor(axis), [=](Probe& probe) { edit(probe, axis, value); });
  });
}

void ProbePanel::buildPlace() {
  QFormLayout* form = addSection(this, tr("Probe"));
  origin_ = new VectorRow(kMetres, tr("capture origin in the world, metres: where the cubemap is taken from"), this);
  boxMin_ = new VectorRow(kMetres, tr("least corner of the projection box, metres"), this);
  boxMax_ = new VectorRow(kMetres, tr("greatest corner of the projection box, metres"), this);
  rotation_ = new VectorRow(kDegrees, tr("turns the box about its centre, in degrees, X first, then Y, then Z"), this);
  size_ = new QLabel(this);
  addRow(form, tr("Origin"), origin_, tr("Where the cubemap is captured (the diamond in the picture)"));
  addRow(form, tr("Box min"), boxMin_, tr("The box reflections are projected onto: put its faces on the walls"));
  addRow(form, tr("Box max"), boxMax_, tr("The box reflections are projected onto: put its faces on the walls"));
  addRow(form, tr("Size"), size_, tr("Extent of the box along its own axes"));
  addRow(form, tr("Rotation"), rotation_, tr("Turns the box about its centre"));

  connectVector(origin_, tr("origin"), [](Probe& probe, int axis, double value) { probe.origin[axis] = value; });
  connectVector(rotation_, tr("rotation"),
                [](Probe& probe, int axis, double value) { probe.rotationDegrees[axis] = value; });
  connectVector(boxMin_, tr("box min"),
                [](Probe& probe, int axis, double value) { setBox(probe, withSide(probe.box, false, axis, value)); });
  connectVector(boxMax_, tr("box max"),
                [](Probe& probe, int axis, double value) { setBox(probe, withSide(probe.box, true, axis, value)); });
}

void ProbePanel::buildInfluence() {
  QFormLayout* form = addSection(this, tr("Influence"));
  blend_ = new BlendRow(this);
  addRow(form, tr("Blend distance"), blend_);
  form->addRow(blend_->faces());
  connect(blend_, &BlendRow::previewed, this, [this](const BlendDistance& blend) {
    editor_.previewProbe({blend_}, label(tr("blend distance")), [=](Probe& probe) { probe.blendDistance = blend; });
  });
  connect(blend_, &BlendRow::committed, this, [this](const BlendDistance& blend) {
    editor_.commitProbe({blend_}, label(tr("blend distance")), [=](Probe& probe) { probe.blendDistance = blend; });
  });
  importance_ = addProbeNumber(editor_, form, tr("Importance"), kLevel,
                               tr("Where probes overlap, the higher importance takes its share first"),
                               [](Probe& probe, double value) { probe.importance = value; });

  ownInfluence_ = new QCheckBox(tr("Influence box of its own"), this);
  ownInfluence_->setToolTip(tr("Off: the probe reaches as far as its projection box"));
  form->addRow(ownInfluence_);
  influenceFields_ = new QWidget(this);
  auto* fields = new QFormLayout(influenceFields_);
  fields->setContentsMargins(0, 0, 0, 0);
  influenceMin_ = new VectorRow(kMetres, tr("least corner of the influence box, metres"), influenceFields_);
  influenceMax_ = new VectorRow(kMetres, tr("greatest corner of the influence box, metres"), influenceFields_);
  fields->addRow(tr("Min"), influenceMin_);
  fields->addRow(tr("Max"), influenceMax_);
  form->addRow(influenceFields_);
  connect(ownInfluence_, &QCheckBox::clicked, this, [this](bool own) {
    editor_.commitProbe(label(tr("influence box")),
                        [own](Probe& probe) { probe.influence = own ? std::optional<Box>(probe.box) : std::nullopt; });
  });
  const auto side = [](bool maximum) {
    return [maximum](Probe& probe, int axis, double value) {
      if (probe.influence) probe.influence = withSide(*probe.influence, maximum, axis, value);
    };
  };
  connectVector(influenceMin_, tr("influence min"), side(false));
  connectVector(influenceMax_, tr("influence max"), side(true));
}

void ProbePanel::buildLook() {
  QFormLayout* form = addSection(this, tr("Reflection"));
  technique_ = new TechniqueChooser(this);
  techniqueHelp_ = helpLabel(this);
  addRow(form, tr("Technique"), technique_);
  form->addRow(techniqueHelp_);
  parameters_ = new TechniqueParametersPanel(editor_, this);
  form->addRow(parameters_);
  projection_ = new QCheckBox(tr("Project onto the box"), this);
  projection_->setToolTip(
      tr("Off: the cubemap is looked up with the bare reflection vector, as if infinitely far away"));
  form->addRow(projection_);
  intensity_ = addProbeNumber(editor_, form, tr("Intensity"), kFactor, tr("Factor on the probe's light, 1 as captured"),
                              [](Probe& probe, double value) { probe.intensity = value; });
  buildEdges(form);
  connect(technique_, &TechniqueChooser::chosen, this, [this](const std::string& id) {
    editor_.commitProbe(label(tr("technique")), [id](Probe& probe) { probe.technique = id; });
  });
  connect(projection_, &QCheckBox::clicked, this, [this](bool on) {
    editor_.commitProbe(label(tr("projection")), [on](Probe& probe) { probe.projection = on; });
  });
}

void ProbePanel::buildEdges(QFormLayout* form) {
  const auto edit = [](double Bevel::*member) {
    return [member](Probe& probe, double value) {
      Bevel bevel = probe.bevel.value_or(Bevel());
      bevel.*member = value;
      probe.bevel = bevel == Bevel() ? std::nullopt : std::optional<Bevel>(bevel);
    };
  };
  bevelRadius_ = addProbeNumber(editor_, form, tr("Bevel"), kLength,
                                tr("Radius of the projection box's edges, metres: reflections turn a corner instead of "
                                   "breaking at it. 0: sharp"),
                                edit(&Bevel::radius));
  bevelFromRoughness_ =
      addProbeNumber(editor_, form, tr("Bevel by roughness"), kLength,
                     tr("Metres of radius added at roughness 1, in proportion to the roughness: rough "
                        "surfaces, which show no edge, have none"),
                     edit(&Bevel::fromRoughness));
  occluded_ = new QCheckBox(tr("Box occlusion"), this);
  occluded_->setToolTip(
      tr("Darkens what lies near in the reflection: by mix(1, o, strength) with o = multiplier x d^power, d in metres "
         "along the reflected ray. A look; it makes no picture truer"));
  form->addRow(occluded_);
  connect(occluded_, &QCheckBox::clicked, this, [this](bool on) {
    editor_.commitProbe(label(tr("box occlusion")), [on](Probe& probe) {
      probe.occlusion = on ? std::optional<BoxOcclusion>(BoxOcclusion()) : std::nullopt;
    });
  });
  const auto set = [](double BoxOcclusion::*member) {
    return [member](Probe& probe, double value) {
      if (probe.occlusion) (*probe.occlusion).*member = value;
    };
  };
  occlusionFields_ = new QWidget(this);
  auto* fields = new QFormLayout(occlusionFields_);
  fields->setContentsMargins(0, 0, 0, 0);
  form->addRow(occlusionFields_);
  occlusionMultiplier_ = addProbeNumber(editor_, fields, tr("Multiplier"), kFactor,
                                        tr("Openness at a distance of 1 m: 1 is fully open there, 0.2 a fifth"),
                                        set(&BoxOcclusion::multiplier));
  occlusionPower_ =
      addProbeNumber(editor_, fields, tr("Distance power"), {0.0, 16.0, 0.1, 2, ""},
                     tr("How fast it opens with distance: 1 in proportion, 0 not at all"), set(&BoxOcclusion::power));
  occlusionStrength_ = addProbeNumber(editor_, fields, tr("Strength"), {0.0, 1.0, 0.05, 2, ""},
                                      tr("Share of the darkening that is applied"), set(&BoxOcclusion::strength));
}

void ProbePanel::updateBoxBounds(VectorRow* min, VectorRow* max, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    min->field(axis)->setBounds(kMetres.minimum, box.max[axis] - kMinimumThickness);
    max->field(axis)->setBounds(box.min[axis] + kMinimumThickness, kMetres.maximum);
  }
}

void ProbePanel::update() {
  const Probe* probe = editor_.probe();
  setEnabled(probe != nullptr);
  if (!probe) return;
  origin_->show(probe->origin);
  // Bounds narrow only after the new values are in, which the old bounds must not cut off.
  for (VectorRow* row : {boxMin_, boxMax_, influenceMin_, influenceMax_}) {
    for (int axis = 0; axis < 3; ++axis) row->field(axis)->setBounds(kMetres.minimum, kMetres.maximum);
  }
  boxMin_->show(probe->box.min);
  boxMax_->show(probe->box.max);
  updateBoxBounds(boxMin_, boxMax_, probe->box);
  size_->setText(boxSizeText(probe->box));
  rotation_->show(probe->rotationDegrees);

  blend_->show(probe->blendDistance);
  importance_->show(probe->importance);
  ownInfluence_->setChecked(probe->influence.has_value());
  influenceFields_->setVisible(probe->influence.has_value());
  influenceMin_->show(probe->influenceBox().min);
  influenceMax_->show(probe->influenceBox().max);
  updateBoxBounds(influenceMin_, influenceMax_, probe->influenceBox());

  technique_->show(probe->technique);
  techniqueHelp_->setText(technique_->help());
  parameters_->show(*probe);
  projection_->setChecked(probe->projection);
  intensity_->show(probe->intensity);
  const Bevel bevel = probe->bevel.value_or(Bevel());
  bevelRadius_->show(bevel.radius);
  bevelFromRoughness_->show(bevel.fromRoughness);
  occluded_->setChecked(probe->occlusion.has_value());
  occlusionFields_->setVisible(probe->occlusion.has_value());
  const BoxOcclusion occlusion = probe->occlusion.value_or(BoxOcclusion());
  occlusionMultiplier_->show(occlusion.multiplier);
  occlusionPower_->show(occlusion.power);
  occlusionStrength_->show(occlusion.strength);
}

}  // namespace boxprobe
