// See ray_panel.h.
#include "app/gui/explain/ray_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/table_words.h"
#include "app/gui/widgets/value_field.h"

namespace boxprobe {

namespace {

struct Choice {
  const char* label;
  const char* help;
};

// In the order of RaySource.
constexpr std::array<Choice, 5> kSources = {{
    {QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Under the pointer"),
     QT_TRANSLATE_NOOP("boxprobe::RayPanel", "The point that is explained: under the pointer, or pinned by a click")},
    {QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Clicked points"),
     QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Every point clicked with the Explain tool")},
    {QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Over an object"),
     QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Spread evenly over the surface of one object")},
    {QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Along a line"),
     QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Between the last two points clicked, dropped on to what lies below")},
    {QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Grid over the picture"),
     QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Under a grid of pixels of the picture as it is")},
}};

// In the order of RayColoring.
constexpr std::array<const char*, 5> kColorings = {
    QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Kind of line"), QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Hit distance"),
    QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Error of the hit"), QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Face hit"),
    QT_TRANSLATE_NOOP("boxprobe::RayPanel", "Probe")};

constexpr int kMostPoints = 2000;

/// Scrolling past does not change it, unless it was clicked before. Digits are Latin ones, as everywhere in the window.
class QuietSpinBox : public QSpinBox {
 public:
  using QSpinBox::QSpinBox;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (!hasFocus()) return event->ignore();
    QSpinBox::wheelEvent(event);
  }
};

}  // namespace

RayPanel::RayPanel(QWidget* parent)
    : QWidget(parent),
      shown_(new QCheckBox(tr("Show rays"), this)),
      source_(new QuietCombo(this)),
      object_(new QuietCombo(this)),
      count_(new QuietSpinBox(this)),
      length_(new ValueField({1e-3, 1e7, 1.0, 2, ""}, this)),
      coloring_(new QuietCombo(this)),
      status_(helpLabel(this)),
      clear_(new QPushButton(tr("Clear points"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Projection rays"));
  shown_->setObjectName("showRays");
  form->addRow(shown_);
  for (const Choice& choice : kSources) {
    source_->addItem(tr(choice.label));
    source_->setItemData(source_->count() - 1, tr(choice.help), Qt::ToolTipRole);
  }
  source_->setObjectName("raySource");
  addRow(form, tr("Start at"), source_, tr("Surface points that rays are drawn from"));
  object_->setObjectName("rayObject");
  addRow(form, tr("Object"), object_, tr("Object over which the points are spread"));
  count_->setRange(1, kMostPoints);
  count_->setFocusPolicy(Qt::StrongFocus);
  count_->setObjectName("rayCount");
  addRow(form, tr("Points at most"), count_, tr("Largest number of points that get rays"));
  addRow(form, tr("Longest ray"), length_, tr("Length of a ray that hits nothing, scene units"));
  buildKinds(form);
  for (const char* label : kColorings) coloring_->addItem(tr(label));
  coloring_->setObjectName("rayColoring");
  addRow(form, tr("Colour by"), coloring_, tr("Meaning of a line's colour"));
  auto* buttons = new QHBoxLayout;
  auto* save = new QPushButton(tr("Save rays..."), this);
  save->setToolTip(tr("Saves VTK poly data (.vtp) with every number in arrays, for ParaView"));
  clear_->setToolTip(tr("Removes the clicked points"));
  buttons->addWidget(clear_);
  buttons->addWidget(save);
  form->addRow(buttons);
  form->addRow(status_);

  const auto choose = [this](QuietCombo* combo) {
    combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    combo->setMinimumContentsLength(8);
    connect(combo, QOverload<int>::of(&QComboBox::activated), this, &RayPanel::apply);
  };
  choose(source_);
  choose(object_);
  choose(coloring_);
  connect(shown_, &QCheckBox::clicked, this, &RayPanel::apply);
  connect(count_, QOverload<int>::of(&QSpinBox::valueChanged), this, &RayPanel::apply);
  connect(length_, &ValueField::previewed, this, &RayPanel::apply);
  connect(length_, &ValueField::committed, this, &RayPanel::apply);
  connect(clear_, &QPushButton::clicked, this, &RayPanel::clearRequested);
  connect(save, &QPushButton::clicked, this, &RayPanel::saveRequested);

  setObjects({});
  show(settings_);
}

void RayPanel::buildKinds(QFormLayout* form) {
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  static constexpr std::array<const char*, kRayKinds> help = {
      QT_TR_NOOP("From the eye to the surface point P"),
      QT_TR_NOOP("N, the geometric normal at P"),
      QT_TR_NOOP("From P along R to the hit H on the probe's box"),
      QT_TR_NOOP("From the capture origin C to what is looked up: H - C"),
      QT_TR_NOOP("From P to what each fetch looks up, of techniques with several"),
      QT_TR_NOOP("From P along R to what the scene itself has there"),
      QT_TR_NOOP("From the hit on the box to the true hit"),
      QT_TR_NOOP("Of glass: from P through the object to where the light leaves it"),
      QT_TR_NOOP("Of glass: from there along the refracted direction to the hit on the probe's box"),
      QT_TR_NOOP("From P towards each light that throws shadows, to where it leaves the probe's box")};
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    QString label = tableWords(kRayKindNames[i]);
    label[0] = label[0].toUpper();
    kinds_[i] = new QCheckBox(label, this);
    kinds_[i]->setToolTip(tr(help[i]));
    kinds_[i]->setChecked(settings_.kinds[i]);
    kinds_[i]->setObjectName(QString("rayKind%1").arg(i));
    connect(kinds_[i], &QCheckBox::clicked, this, &RayPanel::apply);
    grid->addWidget(kinds_[i], static_cast<int>(i) / 2, static_cast<int>(i) % 2);
  }
  form->addRow(tr("Lines"), grid);
}

void RayPanel::show(const RaySettings& settings) {
  shown_->setChecked(settings.shown);
  source_->setCurrentIndex(static_cast<int>(settings.source));
  object_->setCurrentIndex(std::max(object_->findData(QString::fromStdString(settings.object)), 0));
  {
    const QSignalBlocker quiet(count_);
    count_->setValue(settings.count);
  }
  length_->show(settings.maximumLength);
  for (std::size_t i = 0; i < kinds_.size(); ++i) kinds_[i]->setChecked(settings.kinds[i]);
  coloring_->setCurrentIndex(static_cast<int>(settings.coloring));
  settings_ = settings;
  apply();
}

void RayPanel::setObjects(const std::vector<std::string>& names) {
  const QSignalBlocker quiet(object_);
  object_->clear();
  object_->addItem(tr("the last clicked point"), QString());
  for (const std::string& name : names) {
    const QString text = QString::fromStdString(name);
    object_->addItem(text, text);
  }
  const int index = object_->findData(QString::fromStdString(settings_.object));
  object_->setCurrentIndex(std::max(index, 0));
  settings_.object = object_->currentData().toString().toStdString();
}

void RayPanel::setMaximumLength(double length) {
  length_->show(length);
  apply();
}

void RayPanel::showStatus(const QString& line) {
  status_->setText(line);
}

void RayPanel::apply() {
  settings_.shown = shown_->isChecked();
  settings_.source = static_cast<RaySource>(source_->currentIndex());
  settings_.object = object_->currentData().toString().toStdString();
  settings_.count = count_->value();
  settings_.maximumLength = length_->value();
  for (std::size_t i = 0; i < kinds_.size(); ++i) settings_.kinds[i] = kinds_[i]->isChecked();
  settings_.coloring = static_cast<RayColoring>(coloring_->currentIndex());
  object_->setEnabled(settings_.source == RaySource::Object);
  emit changed(settings_);
}

}  // namespace boxprobe
