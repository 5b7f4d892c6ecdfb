// See face_tags.h.
#include "app/gui/handles/face_tags.h"

#include <QLabel>
#include <QToolButton>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/edit/gauge_rows.h"
#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

namespace {

/// Beside a handle, not over it: the handle is what the mouse takes hold of.
constexpr int kBeside = 16, kBelow = 8;

const char* const kPlain =
    " { color: #f4f4f4; background: rgba(16, 18, 22, 190); border: none; border-radius: 4px; "
    "padding: 1px 5px; }";

}  // namespace

FaceTags::FaceTags(ProbeGauge& gauge, const Editor& editor, Hooks hooks, QWidget* picture)
    : QObject(picture),
      gauge_(gauge),
      editor_(editor),
      hooks_(std::move(hooks)),
      picture_(picture),
      spotTag_(new QLabel(picture)) {
  for (int face = 0; face < kFaces; ++face) {
    auto* tag = new QToolButton(picture);
    tag->setObjectName(QString("faceTag%1").arg(face));
    tag->setFocusPolicy(Qt::NoFocus);  // keys stay with the picture
    tag->hide();
    faces_[static_cast<std::size_t>(face)] = tag;
    connect(tag, &QToolButton::clicked, this, [this, face] { gauge_.snap(face); });
  }
  spotTag_->setObjectName("spotTag");
  spotTag_->setAttribute(Qt::WA_TransparentForMouseEvents);
  spotTag_->setStyleSheet(QString("QLabel") + kPlain);
  spotTag_->hide();
  connect(&gauge_, &ProbeGauge::changed, this, [this] {
    spot_.reset();
    follow();
  });
}

void FaceTags::showSpot(const std::optional<WorstSpot>& spot) {
  spot_ = spot;
  follow();
}

void FaceTags::place(QWidget* tag, const glm::dvec3& positionWorld) const {
  const auto pixel = hooks_.view().pixel(positionWorld);
  const bool inside =
      pixel && pixel->x >= 0.0 && pixel->y >= 0.0 && pixel->x < picture_->width() && pixel->y < picture_->height();
  tag->setVisible(inside);
  if (!inside) return;
  tag->adjustSize();
  int x = static_cast<int>(std::lround(pixel->x)) + kBeside;
  if (x + tag->width() > picture_->width()) x -= 2 * kBeside + tag->width();
  const int y = std::min(static_cast<int>(std::lround(pixel->y)) + kBelow, picture_->height() - tag->height());
  tag->move(x, y);
}

void FaceTags::follow() {
  const Probe* probe = editor_.probe();
  const std::optional<BoxGauge>& gauge = gauge_.gauge();
  const bool shown = gauge && probe != nullptr && hooks_.shown();
  for (int face = 0; face < kFaces; ++face) {
    QToolButton* tag = faces_[static_cast<std::size_t>(face)];
    if (!shown || !(gauge->faces[static_cast<std::size_t>(face)].share > 0.0)) {
      tag->hide();
      continue;
    }
    const bool worst = gauge->worst == face;
    const QString text = degreesText(gauge->faces[static_cast<std::size_t>(face)].meanDegrees);
    if (tag->text() != text) tag->setText(text);
    if (tag->property("worst").toBool() != worst || tag->styleSheet().isEmpty()) {
      tag->setProperty("worst", worst);
      tag->setStyleSheet(worst ? worstStyle("QToolButton") : QString("QToolButton") + kPlain);
      // What is no mark is no button: the mouse goes to the picture below.
      tag->setAttribute(Qt::WA_TransparentForMouseEvents, !worst);
      tag->setCursor(worst ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
    tag->setToolTip(worst ? snapHint(*gauge, face) : QString());
    place(tag, faceCenterWorld(*probe, BoxFace{face / 2, face % 2 == 1}));
  }
  spotTag_->setVisible(spot_.has_value());
  if (!spot_) return;
  spotTag_->setText(QString::fromUtf8("\u25b2 ") + tr("worst spot: %1 off").arg(degreesText(spot_->degrees)));
  place(spotTag_, spot_->positionWorld);
}

}  // namespace boxprobe
