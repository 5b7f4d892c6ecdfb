// See surface_view_panel.h.
#include "app/gui/explain/surface_view_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/table_words.h"
#include "app/gui/widgets/value_field.h"
#include "filters/core/base/fixed_text.h"
#include "filters/explain/explanation_sections.h"
#include "filters/explain/surface_value.h"

namespace boxprobe {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

constexpr double kSmallestSpan = 1e-6;

}  // namespace

SurfaceViewPanel::SurfaceViewPanel(QWidget* parent)
    : QWidget(parent),
      combo_(new QuietCombo(this)),
      help_(helpLabel(this)),
      rangeRow_(new QWidget(this)),
      low_(new ValueField({}, this)),
      high_(new ValueField({}, this)),
      lock_(new QCheckBox(tr("Lock"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Surfaces"));
  for (const SurfaceViewRow& row : surfaceViews()) {
    combo_->addItem(tableWords(row.label), text(row.id));
    combo_->setItemData(combo_->count() - 1, tableWords(row.help), Qt::ToolTipRole);
  }
  combo_->setObjectName("surfaceView");
  combo_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  combo_->setMaxVisibleItems(combo_->count());
  addRow(form, tr("Coloured by"), combo_, tr("What the surfaces show instead of their own look"));
  auto* range = new QHBoxLayout(rangeRow_);
  range->setContentsMargins(0, 0, 0, 0);
  range->addWidget(low_, 1);
  range->addWidget(new QLabel(tr("to"), this));
  range->addWidget(high_, 1);
  range->addWidget(lock_);
  constexpr int kNarrowest = 60;  // the range of values alone would ask for more than the dock has
  for (ValueField* field : {low_, high_}) field->setMinimumWidth(kNarrowest);
  low_->setObjectName("rangeLow");
  high_->setObjectName("rangeHigh");
  lock_->setObjectName("rangeLock");
  lock_->setToolTip(tr("Keeps this range. Otherwise it follows the size of the scene"));
  addRow(form, tr("Range"), rangeRow_, tr("Range of the colours; typing a value locks it"));
  form->addRow(help_);
  connect(combo_, QOverload<int>::of(&QComboBox::activated), this, &SurfaceViewPanel::choose);
  connect(lock_, &QCheckBox::clicked, this, [this](bool locked) {
    if (locked) return lockRange();
    settings_.low.reset();
    settings_.high.reset();
    apply();
  });
  for (ValueField* field : {low_, high_}) {
    connect(field, &ValueField::previewed, this, &SurfaceViewPanel::lockRange);
    connect(field, &ValueField::committed, this, &SurfaceViewPanel::lockRange);
  }
  choose(0);
}

void SurfaceViewPanel::choose(int view) {
  combo_->setCurrentIndex(view);
  // Another view has another unit: a range of the last one says nothing.
  if (view != settings_.view) settings_ = SurfaceViewSettings();
  settings_.view = view;
  lock_->setChecked(settings_.low.has_value());
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(view)];
  rangeRow_->setEnabled(row.kind == ViewKind::Scalar);
  help_->setText(tableWords(row.help));
  for (ValueField* field : {low_, high_})
    field->setSuffix(row.unit == "degrees" ? QString::fromUtf8("\u00b0") : QString());
  apply();
}

void SurfaceViewPanel::show(const SurfaceViewSettings& settings) {
  choose(settings.view);
  settings_ = settings;
  lock_->setChecked(settings_.low.has_value());
  apply();
}

void SurfaceViewPanel::showRange(const std::pair<double, double>& range) {
  low_->show(range.first);
  high_->show(range.second);
}

void SurfaceViewPanel::lockRange() {
  settings_.low = low_->value();
  settings_.high = std::max(high_->value(), low_->value() + kSmallestSpan);
  lock_->setChecked(true);
  apply();
}

void SurfaceViewPanel::apply() {
  emit changed(settings_);
}

QString surfaceViewReadout(const SurfaceViewRow& row, const Explanation& explanation) {
  const auto value = surfaceValue(row, explanation);
  const QString label = tableWords(row.label) + ": ";
  if (!value)
    return label + (explanation.hit ? SurfaceViewPanel::tr("undefined here") : SurfaceViewPanel::tr("background"));
  const auto number = [](float x) { return QString::fromStdString(fixedText(x, 3)); };
  QString shown;
  switch (row.kind) {
    case ViewKind::Category:
      shown = QString::fromStdString(boxFaceName(static_cast<int>(std::lround(value->x))));
      break;
    case ViewKind::Scalar:
      shown = number(value->x);
      if (!row.unit.empty()) shown += " " + tableWords(row.unit);
      break;
    case ViewKind::Picture:
    case ViewKind::Color:
    case ViewKind::Light:
      shown = number(value->x) + "  " + number(value->y) + "  " + number(value->z);
      break;
  }
  return label + shown;
}

}  // namespace boxprobe
