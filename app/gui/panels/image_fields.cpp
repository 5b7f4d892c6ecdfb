// See image_fields.h.
#include "app/gui/panels/image_fields.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <exception>

#include "app/gui/edit/field_form.h"
#include "app/gui/edit/probe_fields.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/value_field.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/io/cube/cube_file.h"

namespace boxprobe {

namespace {

const ValueField::Format kMultiplier{1e-3, 65504.0, 0.5, 4, ""};  // up to the largest half float, the brightest texel
const ValueField::Format kExponent{0.0, 10.0, 0.1, 3, ""};

glm::dvec2 decodeOf(const Probe& probe) {
  return probe.decode.value_or(usualDecode(probe.encoding));
}

/// The probe's own where the file can have it, else what a file of this kind most likely is.
ImageEncoding encodingFor(const std::string& path, ImageEncoding current) {
  const std::string extension = lowerExtension(path);
  if (extension == ".exr" || extension == ".hdr") return ImageEncoding::Linear;
  if (current != ImageEncoding::Linear) return current;
  return extension == ".png" ? ImageEncoding::Rgbm : ImageEncoding::Dldr;
}

}  // namespace

ImageFields::ImageFields(Editor& editor, QFormLayout* form)
    : QObject(form->parentWidget()), editor_(editor), form_(form) {
  addFile();
  addLayout();
  addCubeView();
  addEncoding();
}

void ImageFields::addFile() {
  row_ = new QWidget(form_->parentWidget());
  auto* row = new QHBoxLayout(row_);
  row->setContentsMargins(0, 0, 0, 0);
  name_ = new QLabel(row_);
  name_->setTextFormat(Qt::PlainText);
  name_->setObjectName("image");
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* choose = new QToolButton(row_);
  choose->setObjectName("chooseImage");
  choose->setText(tr("Choose..."));
  row->addWidget(name_, 1);
  row->addWidget(choose);
  addRow(form_, tr("Image"), row_,
         tr("OpenEXR or Radiance HDR, or PNG or JPEG with an encoding: a latitude-longitude map, a cross, a strip, or "
            "one of six face files"));
  connect(choose, &QToolButton::clicked, this, &ImageFields::choose);
}

void ImageFields::addLayout() {
  const auto& row = probeField("imageLayout");
  layout_ = addProbeChoice(
      form_, tr("Layout"),
      choicesOf(row, {tr("Detected"), tr("Latitude-longitude"), tr("Strip of faces"), tr("Cross"), tr("Six files")}),
      fieldTip(row), [this](int layout) {
        editor_.commitProbe(probeEditLabel(editor_, tr("image layout")),
                            [layout](Probe& probe) { probe.imageLayout = static_cast<CubeLayout>(layout); });
      });
  layout_->setObjectName("imageLayout");
}

void ImageFields::addCubeView() {
  const auto& row = probeField("cubeView");
  view_ = addProbeChoice(form_, tr("Faces seen from"), choicesOf(row, {tr("Outside"), tr("Inside")}), fieldTip(row),
                         [this](int view) {
                           editor_.commitProbe(probeEditLabel(editor_, tr("view of faces")),
                                               [view](Probe& probe) { probe.cubeView = static_cast<CubeView>(view); });
                         });
  view_->setObjectName("facesSeenFrom");
  const auto& turn = probeField("imageRotationDegrees");
  turn_ = addProbeNumber(editor_, form_, tr("Image turned by"), fieldFormat(turn, 5.0, 1), fieldTip(turn),
                         [](Probe& probe, double value) { probe.imageRotationDegrees = value; });
  turn_->setObjectName("imageTurn");
}

void ImageFields::addEncoding() {
  const auto& row = probeField("encoding");
  encoding_ = addProbeChoice(form_, tr("Encoding"),
                             choicesOf(row, {tr("Linear"), tr("RGBM"), tr("dLDR"), tr("RGBM, linear bytes")}),
                             fieldTip(row), [this](int encoding) {
                               editor_.commitProbe(probeEditLabel(editor_, tr("encoding")), [encoding](Probe& probe) {
                                 probe.encoding = static_cast<ImageEncoding>(encoding);
                                 probe.decode.reset();  // another encoding's says nothing of this one
                               });
                             });
  encoding_->setObjectName("encoding");
  const auto part = [](double glm::dvec2::*member) {
    return [member](Probe& probe, double value) {
      glm::dvec2 decode = decodeOf(probe);
      decode.*member = value;
      probe.decode = decode;
    };
  };
  multiplier_ =
      addProbeNumber(editor_, form_, tr("Multiplier"), kMultiplier,
                     tr("The brightest radiance that the encoding holds. Default: 34.4932 for RGBM, 4.5948 for "
                        "dLDR, 5 for RGBM of linear bytes"),
                     part(&glm::dvec2::x));
  multiplier_->setObjectName("decodeMultiplier");
  exponent_ =
      addProbeNumber(editor_, form_, tr("Exponent"), kExponent,
                     tr("The power of M. Default: 2.2 for RGBM, 1 for RGBM of linear bytes"), part(&glm::dvec2::y));
  exponent_->setObjectName("decodeExponent");
}

void ImageFields::choose() {
  const Probe* probe = editor_.probe();
  const QString folder = probe ? QFileInfo(QString::fromStdString(probe->image)).absolutePath() : QString();
  const QString path = QFileDialog::getOpenFileName(form_->parentWidget()->window(), tr("Environment image"), folder,
                                                    tr("Environment images (*.exr *.hdr *.png *.jpg *.jpeg)"));
  if (!path.isEmpty()) {
    try {
      const std::string file = path.toStdString();
      const Probe before = probe ? *probe : Probe();
      const ImageEncoding encoding = encodingFor(file, before.encoding);
      PictureCode code{encoding, before.decode};
      if (encoding != before.encoding) code.decode.reset();
      // Found out now, while the probe can stay as it was.
      loadCube(file, before.imageLayout, 0, code, before.cubeView);
      editor_.commitProbe(probeEditLabel(editor_, tr("image")), [&](Probe& edited) {
        edited.mode = ProbeMode::Custom;
        edited.image = file;
        edited.encoding = code.encoding;
        edited.decode = code.decode;
      });
    } catch (const std::exception& error) {
      warnUser(form_->parentWidget()->window(), tr("Cannot use this image"), QString::fromStdString(messageOf(error)));
    }
  }
  emit answered();
}

void ImageFields::showRow(QWidget* field, bool shown) {
  field->setVisible(shown);
  form_->labelForField(field)->setVisible(shown);
}

void ImageFields::update(const Probe& probe) {
  const bool custom = probe.mode == ProbeMode::Custom;
  for (QWidget* field : std::initializer_list<QWidget*>{row_, layout_, view_, turn_, encoding_}) showRow(field, custom);
  const bool encoded = custom && probe.encoding != ImageEncoding::Linear;
  showRow(multiplier_, encoded);
  showRow(exponent_, encoded && probe.encoding != ImageEncoding::Dldr);
  const QString path = QString::fromStdString(probe.image);
  name_->setText(QFileInfo(path).fileName());
  name_->setToolTip(plainToolTip(path));
  showChoice(layout_, static_cast<int>(probe.imageLayout));
  showChoice(view_, static_cast<int>(probe.cubeView));
  turn_->show(probe.imageRotationDegrees);
  showChoice(encoding_, static_cast<int>(probe.encoding));
  const glm::dvec2 decode = decodeOf(probe);
  multiplier_->show(decode.x);
  exponent_->show(decode.y);
}

}  // namespace boxprobe
