// See capture_panel.h.
#include "app/gui/panels/capture_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <optional>
#include <utility>

#include "app/gui/edit/field_form.h"
#include "app/gui/edit/probe_fields.h"
#include "app/gui/edit/selected_probes.h"
#include "app/gui/panels/hides_list.h"
#include "app/gui/panels/image_fields.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/scene/bounces.h"

namespace boxprobe {

namespace {

const ValueField::Format kRadiance{0.0, 1e5, 0.05, 3, ""};
constexpr double kLeastRange = 1e-3;  ///< metres between near and far

Clear clearOf(int index) {
  if (index == 0) return ClearToSky{};
  if (index == 1) return ClearToNone{};
  if (index == 3) return ClearToOpen{};
  return glm::vec3(0.0f);
}

}  // namespace

CapturePanel::CapturePanel(Workspace& workspace) : editor_(workspace.editor()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  form_ = addSection(this, tr("Capture"));
  buildMode(form_);
  buildSampling(form_);
  buildView(form_);
  // What a field is called from outside: by style sheets and tests.
  const std::pair<QWidget*, const char*> names[] = {{mode_, "mode"},
                                                    {faceSize_, "faceSize"},
                                                    {samples_, "samplesPerPixel"},
                                                    {bounces_, "bounces"},
                                                    {near_, "near"},
                                                    {far_, "far"},
                                                    {clearColor_, "clearColor"},
                                                    {filter_, "filter"},
                                                    {filterSamples_, "filterSamples"},
                                                    {clear_, "clear"},
                                                    {hides_, "hides"}};
  for (const auto& [widget, name] : names) widget->setObjectName(name);
  connect(&workspace, &Workspace::modelsReplaced, this, [this, &workspace] {
    std::vector<std::string> nodes;
    for (const auto& model : workspace.models()) {
      for (const Instance& instance : model->instances) nodes.push_back(instance.node);
    }
    hides_->setNodes(nodes);
  });
  using C = Changes;
  workspace.changes().add("capture panel", {&C::probeCapture, &C::probeList, &C::selection},
                          [this](const C&) { update(); });
  connect(&workspace.editor(), &Editor::selectionChanged, this, &CapturePanel::update);
  update();
}

void CapturePanel::buildMode(QFormLayout* form) {
  mode_ =
      addProbeChoice(form, tr("Mode"), choicesOf(probeField("mode"), {tr("Baked"), tr("Realtime"), tr("Custom image")}),
                     fieldTip(probeField("mode")), [this](int mode) { chooseMode(mode); });

  image_ = new ImageFields(editor_, form);
  connect(image_, &ImageFields::answered, this, &CapturePanel::update);
}

void CapturePanel::buildSampling(QFormLayout* form) {
  const auto set = [this](const QString& what, int Probe::*member) {
    return [this, what, member](int value) {
      editor_.commitProbe(probeEditLabel(editor_, what), [=](Probe& probe) { probe.*member = value; });
    };
  };
  const auto addWhole = [&](const QString& label, const char* key, const std::vector<int>& values,
                            const QString& pattern, int Probe::*member) {
    QVector<ProbeChoice> choices;
    for (const int value : values) choices.push_back({pattern.arg(value), value});
    return addProbeChoice(form, label, choices, fieldTip(probeField(key)), set(label.toLower(), member));
  };
  faceSize_ =
      addWhole(tr("Face size"), "faceSize", probeField("faceSize").values, tr("%1 × %1 texels"), &Probe::faceSize);
  samples_ = addWhole(tr("Samples"), "samplesPerPixel", probeField("samplesPerPixel").values, tr("%1 per texel"),
                      &Probe::samplesPerPixel);
  std::vector<int> bounces;
  const FieldRange bounceRange = formRange(probeField("bounces"));
  for (int count = static_cast<int>(bounceRange.lowest); count <= bounceRange.highest; ++count)
    bounces.push_back(count);
  bounces_ = addWhole(tr("Bounces"), "bounces", bounces, "%1", &Probe::bounces);
  bounces_->addItem(tr("All"), kAllBounces);
  black_ = helpLabel(this);
  black_->setObjectName("blackMirrors");
  black_->setText(tr("Mirrors and metals are black where this probe sees them. With 2 bounces they reflect, too."));
  form->addRow(black_);
  filter_ = addProbeChoice(form, tr("Filter"), choicesOf(probeField("filter"), {tr("GGX"), tr("Gaussian (frosty)")}),
                           fieldTip(probeField("filter")), [this](int kind) {
                             editor_.commitProbe(probeEditLabel(editor_, tr("filter")), [kind](Probe& probe) {
                               probe.filter = static_cast<FilterKind>(kind);
                             });
                           });
  filterSamples_ =
      addWhole(tr("Filter quality"), "filterSamples", {64, 160, 400}, tr("%1 directions"), &Probe::filterSamples);
}

void CapturePanel::buildView(QFormLayout* form) {
  near_ = addProbeNumber(editor_, form, tr("Near"), fieldFormat(probeField("near"), 0.01, 4),
                         fieldTip(probeField("near")), [](Probe& probe, double value) { probe.nearDistance = value; });
  far_ = addProbeNumber(editor_, form, tr("Far"), fieldFormat(probeField("far"), 10.0, 2), fieldTip(probeField("far")),
                        [](Probe& probe, double value) { probe.farDistance = value; });
  const auto& clear = probeField("clear");
  clear_ = addProbeChoice(form, tr("Clear to"),
                          {{tr("Sky"), 0, choiceTip(clear, 0)},
                           {tr("Nothing"), 1, choiceTip(clear, 1)},
                           {tr("Colour"), 2, tr("The same light from all directions")},
                           {tr("Open"), 3, choiceTip(clear, 2)}},
                          fieldTip(clear), [this](int index) {
                            editor_.commitProbe(probeEditLabel(editor_, tr("clear")), [index](Probe& probe) {
                              if (static_cast<int>(probe.clear.index()) != index) probe.clear = clearOf(index);
                            });
                          });
  clearColor_ = new VectorRow(kRadiance, tr("linear radiance, scene units"), this, "RGB");
  addRow(form, tr("Colour"), clearColor_, tr("Linear radiance where the probe sees nothing"));
  const auto edit = [](int channel, double value) {
    return [=](Probe& probe) {
      if (auto* color = std::get_if<glm::vec3>(&probe.clear)) (*color)[channel] = static_cast<float>(value);
    };
  };
  connect(clearColor_, &VectorRow::previewed, this, [this, edit](int channel, double value) {
    editor_.previewProbe({clearColor_}, probeEditLabel(editor_, tr("clear colour")), edit(channel, value));
  });
  connect(clearColor_, &VectorRow::committed, this, [this, edit](int channel, double value) {
    editor_.commitProbe({clearColor_}, probeEditLabel(editor_, tr("clear colour")), edit(channel, value));
  });
  hides_ = new HidesList(this);
  addRow(form, tr("Hides"), hides_, fieldTip(probeField("hides")));
  connect(hides_, &HidesList::changed, this, [this](const std::vector<std::string>& nodes) {
    editor_.commitProbe(probeEditLabel(editor_, tr("hidden objects")), [nodes](Probe& probe) { probe.hides = nodes; });
  });
}

void CapturePanel::chooseMode(int mode) {
  const Probe* probe = editor_.probe();
  if (!probe) return;
  // A custom probe needs its image from the start.
  if (static_cast<ProbeMode>(mode) == ProbeMode::Custom && probe->image.empty()) return image_->choose();
  editor_.commitProbe(probeEditLabel(editor_, tr("mode")),
                      [mode](Probe& edited) { edited.mode = static_cast<ProbeMode>(mode); });
}

void CapturePanel::showRow(QWidget* field, bool shown) {
  field->setVisible(shown);
  form_->labelForField(field)->setVisible(shown);
}

void CapturePanel::update() {
  const Probe* probe = editor_.probe();
  setEnabled(probe != nullptr);
  if (const bool nothing = probe == nullptr; nothing != empty_) showNothing(this, empty_ = nothing);
  if (!probe) return;
  showChoice(mode_, static_cast<int>(probe->mode));
  const bool custom = probe->mode == ProbeMode::Custom;
  image_->update(*probe);
  showChoice(faceSize_, probe->faceSize, tr("%1 × %1 texels"));
  showChoice(samples_, probe->samplesPerPixel, tr("%1 per texel"));
  showChoice(bounces_, probe->bounces);
  showChoice(filter_, static_cast<int>(probe->filter));
  showChoice(filterSamples_, probe->filterSamples, tr("%1 directions"));

  // Bounds narrow only after the new values are in, which the old bounds must not cut off.
  const FieldRange nearRange = formRange(probeField("near")), farRange = formRange(probeField("far"));
  near_->setBounds(nearRange.lowest, nearRange.highest);
  far_->setBounds(farRange.lowest, farRange.highest);
  near_->show(probe->nearDistance);
  far_->show(probe->farDistance);
  near_->setBounds(nearRange.lowest, probe->farDistance - kLeastRange);
  far_->setBounds(probe->nearDistance + kLeastRange, farRange.highest);

  showChoice(clear_, static_cast<int>(probe->clear.index()));
  const auto* color = std::get_if<glm::vec3>(&probe->clear);
  if (color) clearColor_->show(*color);
  hides_->show(probe->hides);
  // An image is not captured: nothing of how a capture is taken has a meaning then.
  for (QWidget* field : std::initializer_list<QWidget*>{samples_, bounces_, near_, far_, clear_, hides_}) {
    showRow(field, !custom);
  }
  showRow(clearColor_, !custom && color != nullptr);
  black_->setVisible(!custom && probe->bounces == 1);
  markDifferences();
}

void CapturePanel::markDifferences() {
  const SelectedProbes all(editor_);
  const auto mark = [&all](QWidget* field, const auto& get) { showDiffers(field, all.differ(get)); };
  mark(mode_, [](const Probe& probe) { return probe.mode; });
  mark(faceSize_, [](const Probe& probe) { return probe.faceSize; });
  mark(samples_, [](const Probe& probe) { return probe.samplesPerPixel; });
  mark(bounces_, [](const Probe& probe) { return probe.bounces; });
  mark(filter_, [](const Probe& probe) { return probe.filter; });
  mark(filterSamples_, [](const Probe& probe) { return probe.filterSamples; });
  mark(near_, [](const Probe& probe) { return probe.nearDistance; });
  mark(far_, [](const Probe& probe) { return probe.farDistance; });
  mark(clear_, [](const Probe& probe) { return probe.clear.index(); });
  for (int channel = 0; channel < 3; ++channel) {
    clearColor_->field(channel)->setDiffers(all.differ([channel](const Probe& probe) {
      const auto* color = std::get_if<glm::vec3>(&probe.clear);
      return color ? std::optional<float>((*color)[channel]) : std::nullopt;
    }));
  }
}

}  // namespace boxprobe
