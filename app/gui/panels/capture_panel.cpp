// See capture_panel.h.
#include "app/gui/panels/capture_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/panels/hides_list.h"
#include "app/gui/panels/image_fields.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"

namespace boxprobe {

namespace {

const ValueField::Format kNear{1e-4, 1e6, 0.01, 4, " m"};
const ValueField::Format kFar{1e-3, 1e7, 10.0, 2, " m"};
const ValueField::Format kRadiance{0.0, 1e5, 0.05, 3, ""};
constexpr double kLeastRange = 1e-3;  ///< metres between near and far

Clear clearOf(int index) {
  if (index == 0) return ClearToSky{};
  if (index == 1) return ClearToNone{};
  if (index == 3) return ClearToOpen{};
  return glm::vec3(0.0f);
}

}  // namespace

CapturePanel::CapturePanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
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
  update();
}

void CapturePanel::buildMode(QFormLayout* form) {
  mode_ =
      addProbeChoice(form, tr("Mode"),
                     {{tr("Baked"), static_cast<int>(ProbeMode::Baked), tr("Captured when an input changes, and kept")},
                      {tr("Realtime"), static_cast<int>(ProbeMode::Realtime),
                       tr("Captured over and over, one face a picture, so that moving objects are seen")},
                      {tr("Custom image"), static_cast<int>(ProbeMode::Custom),
                       tr("Not captured: an environment picture takes the capture's place")}},
                     tr("Where the probe's light comes from. Default: baked"), [this](int mode) { chooseMode(mode); });

  image_ = new ImageFields(editor_, form);
  connect(image_, &ImageFields::answered, this, &CapturePanel::update);
}

void CapturePanel::buildSampling(QFormLayout* form) {
  const auto set = [this](const QString& what, int Probe::*member) {
    return [this, what, member](int value) {
      editor_.commitProbe(probeEditLabel(editor_, what), [=](Probe& probe) { probe.*member = value; });
    };
  };
  QVector<ProbeChoice> sizes;
  for (const int size : {16, 32, 64, 128, 256, 512, 1024, 2048})
    sizes.push_back({tr("%1 × %1 texels").arg(size), size});
  faceSize_ =
      addProbeChoice(form, tr("Face size"), sizes,
                     tr("Texels along an edge of each cubemap face: sharper mirrors, more memory. Default: 256"),
                     set(tr("face size"), &Probe::faceSize));
  samples_ = addProbeChoice(form, tr("Samples"), {{tr("1 a texel"), 1}, {tr("4 a texel"), 4}, {tr("16 a texel"), 16}},
                            tr("How often each texel is sampled: smoother edges, longer capture. Default: 4"),
                            set(tr("samples"), &Probe::samplesPerPixel));
  bounces_ = addProbeChoice(
      form, tr("Bounces"), {{"1", 1}, {"2", 2}, {"3", 3}, {"4", 4}, {"5", 5}},
      tr("How often the probe is captured in turn: with 1, mirrors are black in their own probe. Default: 1"),
      set(tr("bounces"), &Probe::bounces));
  filter_ = addProbeChoice(
      form, tr("Filter"),
      {{tr("GGX"), static_cast<int>(FilterKind::Ggx), tr("Levels as rough surfaces of the renderer reflect")},
       {tr("Gaussian (frosty)"), static_cast<int>(FilterKind::Gaussian),
        tr("An angular Gaussian of CubeMapGen's widths: a soft, frosted look")}},
      tr("How the levels for rough surfaces are made from the capture. Default: GGX"), [this](int kind) {
        editor_.commitProbe(probeEditLabel(editor_, tr("filter")),
                            [kind](Probe& probe) { probe.filter = static_cast<FilterKind>(kind); });
      });
  filterSamples_ = addProbeChoice(
      form, tr("Filter quality"), {{tr("64 directions"), 64}, {tr("160 directions"), 160}, {tr("400 directions"), 400}},
      tr("Directions a texel of level 1 is filtered by, twice as many a level further: smoother around lamps, longer "
         "filtering. Default: 64"),
      set(tr("filter quality"), &Probe::filterSamples));
}

void CapturePanel::buildView(QFormLayout* form) {
  near_ = addProbeNumber(editor_, form, tr("Near"), kNear,
                         tr("Metres from the origin below which nothing is captured. Default: 0.01 m"),
                         [](Probe& probe, double value) { probe.nearDistance = value; });
  far_ = addProbeNumber(editor_, form, tr("Far"), kFar,
                        tr("Metres from the origin beyond which nothing is captured. Default: 1000 m"),
                        [](Probe& probe, double value) { probe.farDistance = value; });
  clear_ = addProbeChoice(
      form, tr("Clear to"),
      {{tr("Sky"), 0, tr("The scene's sky, as the camera sees it")},
       {tr("Nothing"), 1, tr("Empty: another probe, or the sky, fills what this one did not see")},
       {tr("Colour"), 2, tr("The same light from everywhere")},
       {tr("Open"), 3, tr("The sky as it is by then, uncorrected: it may change without another capture")}},
      tr("What the probe holds where it sees no object. Default: sky"), [this](int index) {
        editor_.commitProbe(probeEditLabel(editor_, tr("clear")), [index](Probe& probe) {
          if (static_cast<int>(probe.clear.index()) != index) probe.clear = clearOf(index);
        });
      });
  clearColor_ = new VectorRow(kRadiance, tr("linear radiance, scene units"), this, "RGB");
  addRow(form, tr("Colour"), clearColor_, tr("Linear radiance of what the probe does not see"));
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
  addRow(form, tr("Hides"), hides_, tr("Objects this probe does not see, such as one that stands at its origin"));
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

void CapturePanel::setModels(const std::vector<std::shared_ptr<const Model>>& models) {
  std::vector<std::string> nodes;
  for (const auto& model : models) {
    for (const Instance& instance : model->instances) nodes.push_back(instance.node);
  }
  hides_->setNodes(nodes);
}

void CapturePanel::update() {
  const Probe* probe = editor_.probe();
  setEnabled(probe != nullptr);
  if (!probe) return;
  showChoice(mode_, static_cast<int>(probe->mode));
  const bool custom = probe->mode == ProbeMode::Custom;
  image_->update(*probe);
  showChoice(faceSize_, probe->faceSize, tr("%1 × %1 texels"));
  showChoice(samples_, probe->samplesPerPixel, tr("%1 a texel"));
  showChoice(bounces_, probe->bounces);
  showChoice(filter_, static_cast<int>(probe->filter));
  showChoice(filterSamples_, probe->filterSamples, tr("%1 directions"));

  // Bounds narrow only after the new values are in, which the old bounds must not cut off.
  near_->setBounds(kNear.minimum, kNear.maximum);
  far_->setBounds(kFar.minimum, kFar.maximum);
  near_->show(probe->nearDistance);
  far_->show(probe->farDistance);
  near_->setBounds(kNear.minimum, probe->farDistance - kLeastRange);
  far_->setBounds(probe->nearDistance + kLeastRange, kFar.maximum);

  showChoice(clear_, static_cast<int>(probe->clear.index()));
  const auto* color = std::get_if<glm::vec3>(&probe->clear);
  if (color) clearColor_->show(*color);
  hides_->show(probe->hides);
  // An image is not captured: nothing of how a capture is taken has a meaning then.
  for (QWidget* field : std::initializer_list<QWidget*>{samples_, bounces_, near_, far_, clear_, hides_}) {
    showRow(field, !custom);
  }
  showRow(clearColor_, !custom && color != nullptr);
}

}  // namespace boxprobe
