// See probe_panel.h.
#include "app/gui/panels/probe_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "app/gui/edit/field_form.h"
#include "app/gui/edit/probe_fields.h"
#include "app/gui/edit/selected_probes.h"
#include "app/gui/panels/blend_row.h"
#include "app/gui/panels/technique_chooser.h"
#include "app/gui/panels/technique_parameters_panel.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/differs.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

/// As its choice has it: automatic, spaced by hand, none.
int latticeChoice(const Probe& probe) {
  return !probe.lattice ? 0 : probe.lattice->used ? 1 : 2;
}

const FieldRow<Box>& boxField(const char* key) {
  return fieldNamed(boxFields(), key);
}
const FieldRow<Bevel>& bevelField(const char* key) {
  return fieldNamed(bevelFields(), key);
}
const FieldRow<BoxOcclusion>& occlusionField(const char* key) {
  return fieldNamed(occlusionFields(), key);
}

/// One corner of a box: the row's limits, and a tip of what the box is.
VectorRow* cornerRow(const char* key, const FieldInfo& box, QWidget* parent) {
  const FieldRow<Box>& corner = boxField(key);
  return new VectorRow(fieldFormat(corner, 0.1, 3), fieldTip(corner, {}) + " " + fieldTip(box, {}), parent);
}

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

ProbePanel::ProbePanel(Workspace& workspace) : editor_(workspace.editor()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  buildPlace();
  buildInfluence();
  buildLook();
  buildDiffuse();
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
                                                    {occlusionStrength_, "occlusionStrength"},
                                                    {lattice_, "lattice"},
                                                    {latticeSpacing_, "latticeSpacing"}};
  for (const auto& [widget, name] : names) widget->setObjectName(name);
  workspace.changes().add("probe panel", selectedProbeKinds(), [this](const Changes&) { update(); });
  connect(&workspace.editor(), &Editor::selectionChanged, this, &ProbePanel::update);
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
  const auto& origin = probeField("origin");
  const auto& box = probeField("box");
  const auto& rotation = probeField("rotationDegrees");
  origin_ = new VectorRow(fieldFormat(origin, 0.1, 3), fieldTip(origin), this);
  boxMin_ = cornerRow("min", box, this);
  boxMax_ = cornerRow("max", box, this);
  rotation_ = new VectorRow(fieldFormat(rotation, 5.0, 1), fieldTip(rotation), this);
  size_ = new QLabel(this);
  several_ = helpLabel(this);
  form->addRow(several_);
  addRow(form, tr("Origin"), origin_, tr("%1 It is the diamond in the picture.").arg(fieldTip(origin)));
  addRow(form, tr("Box min"), boxMin_, fieldTip(box));
  addRow(form, tr("Box max"), boxMax_, fieldTip(box));
  addRow(form, tr("Size"), size_, tr("Extent of the box along its own axes"));
  addRow(form, tr("Rotation"), rotation_, fieldTip(rotation));

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
  const auto set = [](int face, double distance) {
    return [=](Probe& probe) { probe.blendDistance = withBlend(probe.blendDistance, face, distance); };
  };
  connect(blend_, &BlendRow::previewed, this, [this, set](int face, double distance) {
    editor_.previewProbe({blend_}, label(tr("blend distance")), set(face, distance));
  });
  connect(blend_, &BlendRow::committed, this, [this, set](int face, double distance) {
    editor_.commitProbe({blend_}, label(tr("blend distance")), set(face, distance));
  });
  const auto& importance = probeField("importance");
  importance_ = addProbeNumber(editor_, form, tr("Importance"), fieldFormat(importance, 1.0, 2), fieldTip(importance),
                               [](Probe& probe, double value) { probe.importance = value; });

  ownInfluence_ = new QCheckBox(tr("Separate influence box"), this);
  ownInfluence_->setToolTip(tr("Off: the influence box is the projection box"));
  form->addRow(ownInfluence_);
  influenceFields_ = new QWidget(this);
  auto* fields = new QFormLayout(influenceFields_);
  fields->setContentsMargins(0, 0, 0, 0);
  influenceMin_ = cornerRow("min", probeField("influence"), influenceFields_);
  influenceMax_ = cornerRow("max", probeField("influence"), influenceFields_);
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
  projection_->setToolTip(fieldTip(probeField("projection")));
  form->addRow(projection_);
  const auto& intensity = probeField("intensity");
  intensity_ = addProbeNumber(editor_, form, tr("Intensity"), fieldFormat(intensity, 0.05, 2), fieldTip(intensity),
                              [](Probe& probe, double value) { probe.intensity = value; });
  buildEdges(form);
  // Of several, each keeps its own other half.
  connect(technique_, &TechniqueChooser::projectionChosen, this, [this](int projection) {
    editor_.commitProbe(label(tr("technique")),
                        [projection](Probe& probe) { probe.technique = withProjection(probe.technique, projection); });
  });
  connect(technique_, &TechniqueChooser::evaluationChosen, this, [this](int evaluation) {
    editor_.commitProbe(label(tr("technique")),
                        [evaluation](Probe& probe) { probe.technique = withEvaluation(probe.technique, evaluation); });
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
  const auto& radius = bevelField("radius");
  const auto& fromRoughness = bevelField("fromRoughness");
  bevelRadius_ =
      addProbeNumber(editor_, form, tr("Bevel"), fieldFormat(radius, 0.05, 3), fieldTip(radius), edit(&Bevel::radius));
  bevelFromRoughness_ = addProbeNumber(editor_, form, tr("Bevel by roughness"), fieldFormat(fromRoughness, 0.05, 3),
                                       fieldTip(fromRoughness), edit(&Bevel::fromRoughness));
  occluded_ = new QCheckBox(tr("Box occlusion"), this);
  occluded_->setToolTip(fieldTip(probeField("occlusion")));
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
  const auto number = [&](const QString& name, const char* key, double step, double BoxOcclusion::*member) {
    const auto& row = occlusionField(key);
    return addProbeNumber(editor_, fields, name, fieldFormat(row, step, 2), fieldTip(row), set(member));
  };
  occlusionMultiplier_ = number(tr("Multiplier"), "multiplier", 0.05, &BoxOcclusion::multiplier);
  occlusionPower_ = number(tr("Distance power"), "power", 0.1, &BoxOcclusion::power);
  occlusionStrength_ = number(tr("Strength"), "strength", 0.05, &BoxOcclusion::strength);
}

void ProbePanel::buildDiffuse() {
  diffuse_ = addSection(this, tr("Diffuse light"));
  lattice_ = addProbeChoice(
      diffuse_, tr("Lattice"),
      {{tr("Automatic"), 0, tr("About 1 m apart, closer where light falls steeply")},
       {tr("Spaced by hand"), 1},
       {tr("None"), 2, tr("The whole map lights every place alike")}},
      fieldTip(probeField("lattice")), [this](int choice) {
        editor_.commitProbe(label(tr("lattice")), [choice](Probe& probe) {
          const double spacing = probe.lattice ? probe.lattice->spacing : metreOf(probe.box.size());
          probe.lattice = choice == 0 ? std::nullopt : std::optional<ProbeLattice>({choice == 1, spacing});
        });
      });
  const auto& spacing = latticeFields().front();
  latticeSpacing_ = addProbeNumber(editor_, diffuse_, tr("Spacing"), fieldFormat(spacing, 0.1, 2), fieldTip(spacing),
                                   [](Probe& probe, double value) {
                                     if (probe.lattice) probe.lattice->spacing = value;
                                   });
}

void ProbePanel::updateBoxBounds(VectorRow* min, VectorRow* max, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    min->field(axis)->setBounds(formRange(boxField("min")).lowest, box.max[axis] - kMinimumThickness);
    max->field(axis)->setBounds(box.min[axis] + kMinimumThickness, formRange(boxField("max")).highest);
  }
}

void ProbePanel::update() {
  const Probe* probe = editor_.probe();
  setEnabled(probe != nullptr);
  if (const bool nothing = probe == nullptr; nothing != empty_) showNothing(this, empty_ = nothing);
  if (!probe) {
    for (QLabel* label : {size_, techniqueHelp_}) label->clear();
    several_->hide();
    return;
  }
  origin_->show(probe->origin);
  // Bounds narrow only after the new values are in, which the old bounds must not cut off.
  const FieldRange corner = formRange(boxField("min"));
  for (VectorRow* row : {boxMin_, boxMax_, influenceMin_, influenceMax_}) {
    for (int axis = 0; axis < 3; ++axis) row->field(axis)->setBounds(corner.lowest, corner.highest);
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
  const bool spaced = latticeChoice(*probe) == 1;
  showChoice(lattice_, latticeChoice(*probe));
  latticeSpacing_->show(probe->lattice.value_or(ProbeLattice()).spacing);
  latticeSpacing_->setVisible(spaced);
  diffuse_->labelForField(latticeSpacing_)->setVisible(spaced);
  markDifferences();
}

void ProbePanel::markDifferences() {
  const SelectedProbes all(editor_);
  several_->setVisible(all.count() > 1);
  several_->setText(tr("%1 probes are selected. What is set here is set for all; %2 stands where they differ.")
                        .arg(all.count())
                        .arg(differsText()));
  const auto markRow = [&all](VectorRow* row, const std::function<glm::dvec3(const Probe&)>& get) {
    for (int axis = 0; axis < 3; ++axis) {
      row->field(axis)->setDiffers(all.differ([&](const Probe& probe) { return get(probe)[axis]; }));
    }
  };
  markRow(origin_, [](const Probe& probe) { return probe.origin; });
  markRow(boxMin_, [](const Probe& probe) { return probe.box.min; });
  markRow(boxMax_, [](const Probe& probe) { return probe.box.max; });
  markRow(rotation_, [](const Probe& probe) { return probe.rotationDegrees; });
  markRow(influenceMin_, [](const Probe& probe) { return probe.influenceBox().min; });
  markRow(influenceMax_, [](const Probe& probe) { return probe.influenceBox().max; });
  if (all.differ([](const Probe& probe) { return probe.box; })) size_->setText(differsText());
  std::array<bool, 6> faces{};
  for (const BoxFace& face : kBoxFaces) {
    faces[static_cast<std::size_t>(face.index())] = all.differ([&face](const Probe& probe) {
      return (face.positive ? probe.blendDistance.max : probe.blendDistance.min)[face.axis];
    });
  }
  blend_->showDiffers(faces);
  const auto techniqueOf = [](const Probe& probe) { return parseTechnique(probe.technique).value_or(Technique()); };
  technique_->showDiffers(all.differ([&](const Probe& probe) { return techniqueOf(probe).projection; }),
                          all.differ([&](const Probe& probe) { return techniqueOf(probe).evaluation; }));
  if (all.differ([](const Probe& probe) { return probe.technique; })) {
    techniqueHelp_->setText(tr("The selected probes have different techniques."));
  }
  const auto mark = [&all](QWidget* field, const auto& get) { showDiffers(field, all.differ(get)); };
  mark(importance_, [](const Probe& probe) { return probe.importance; });
  mark(intensity_, [](const Probe& probe) { return probe.intensity; });
  mark(ownInfluence_, [](const Probe& probe) { return probe.influence.has_value(); });
  mark(projection_, [](const Probe& probe) { return probe.projection; });
  mark(bevelRadius_, [](const Probe& probe) { return probe.bevel.value_or(Bevel()).radius; });
  mark(bevelFromRoughness_, [](const Probe& probe) { return probe.bevel.value_or(Bevel()).fromRoughness; });
  mark(occluded_, [](const Probe& probe) { return probe.occlusion.has_value(); });
  const auto occlusionOf = [](const Probe& probe) { return probe.occlusion.value_or(BoxOcclusion()); };
  mark(occlusionMultiplier_, [&](const Probe& probe) { return occlusionOf(probe).multiplier; });
  mark(occlusionPower_, [&](const Probe& probe) { return occlusionOf(probe).power; });
  mark(occlusionStrength_, [&](const Probe& probe) { return occlusionOf(probe).strength; });
  mark(lattice_, latticeChoice);
  mark(latticeSpacing_, [](const Probe& probe) { return probe.lattice.value_or(ProbeLattice()).spacing; });
}

}  // namespace boxprobe
