// See blend_row.h.
#include "app/gui/panels/blend_row.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

#include "app/gui/edit/field_form.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

namespace {

ValueField::Format format(const FieldInfo& field) {
  return fieldFormat(field, 0.1, 3);
}

BlendDistance everyFace(double distance) {
  return {glm::dvec3(distance), glm::dvec3(distance)};
}

double largest(const BlendDistance& b) {
  return std::max({b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z});
}

}  // namespace

BlendRow::BlendRow(QWidget* parent)
    : QWidget(parent), all_(new ValueField(format(probeField("blendDistance")), this)), faces_(new QWidget(this)) {
  auto* form = new QFormLayout(faces_);
  form->setContentsMargins(0, 0, 0, 0);
  const auto& min = fieldNamed(blendDistanceFields(), "min");
  const auto& max = fieldNamed(blendDistanceFields(), "max");
  min_ = new VectorRow(format(min), fieldTip(min), faces_);
  max_ = new VectorRow(format(max), fieldTip(max), faces_);
  min_->setObjectName("blendMinusFaces");
  max_->setObjectName("blendPlusFaces");
  form->addRow(tr("- faces"), min_);
  form->addRow(tr("+ faces"), max_);

  all_->setToolTip(
      tr("%1 The weight is 1 inside the dashed box. Sets all six faces.").arg(fieldTip(probeField("blendDistance"))));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(all_, 1);
  layout->addWidget(unfoldButton(faces_, tr("One distance for each of the six faces"), this));

  connect(all_, &ValueField::previewed, this, [this](double value) { emit previewed(-1, value); });
  connect(all_, &ValueField::committed, this, [this](double value) { emit committed(-1, value); });
  const auto connectFaces = [this](VectorRow* row, bool positive) {
    const auto face = [positive](int axis) { return BoxFace{axis, positive}.index(); };
    connect(row, &VectorRow::previewed, this,
            [this, face](int axis, double value) { emit previewed(face(axis), value); });
    connect(row, &VectorRow::committed, this,
            [this, face](int axis, double value) { emit committed(face(axis), value); });
  };
  connectFaces(min_, false);
  connectFaces(max_, true);
}

BlendDistance withBlend(BlendDistance blend, int face, double distance) {
  if (face < 0) return everyFace(distance);
  for (const BoxFace& each : kBoxFaces) {
    if (each.index() == face) (each.positive ? blend.max : blend.min)[each.axis] = distance;
  }
  return blend;
}

void BlendRow::showDiffers(const std::array<bool, 6>& faces) {
  bool any = false;
  for (const BoxFace& face : kBoxFaces) {
    const bool differs = faces[static_cast<std::size_t>(face.index())];
    (face.positive ? max_ : min_)->field(face.axis)->setDiffers(differs);
    any |= differs;
  }
  if (any) all_->setPrefix({});
  all_->setDiffers(any);
}

void BlendRow::show(const BlendDistance& blend) {
  const double most = largest(blend);
  all_->setPrefix(blend == everyFace(most) ? QString() : tr("up to "));
  all_->show(most);
  min_->show(blend.min);
  max_->show(blend.max);
}

}  // namespace boxprobe
