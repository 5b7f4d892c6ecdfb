// See placed_list.h.
#include "app/gui/panels/placed_list.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/widgets/panel_layout.h"

namespace boxprobe {

namespace {

constexpr int kThumbnailWidth = 50, kThumbnailHeight = 28;
constexpr int kLargeWidth = 432;

/// Of each of PlacedPictures: what stands below the thumbnail, and below the large picture.
struct PictureText {
  const char *caption, *description;
};
constexpr PictureText kPictureTexts[PlacedPictures::kCount] = {
    {QT_TRANSLATE_NOOP("boxprobe::PlacedList", "before"),
     QT_TRANSLATE_NOOP("boxprobe::PlacedList", "Drawn with the current probes")},
    {QT_TRANSLATE_NOOP("boxprobe::PlacedList", "after"),
     QT_TRANSLATE_NOOP("boxprobe::PlacedList", "Drawn with the proposed probes")},
    {QT_TRANSLATE_NOOP("boxprobe::PlacedList", "traced"),
     QT_TRANSLATE_NOOP("boxprobe::PlacedList", "Path traced: all light, the truth")},
    {QT_TRANSLATE_NOOP("boxprobe::PlacedList", "error before"),
     QT_TRANSLATE_NOOP("boxprobe::PlacedList", "Error before, up to 25 % of white")},
    {QT_TRANSLATE_NOOP("boxprobe::PlacedList", "error after"),
     QT_TRANSLATE_NOOP("boxprobe::PlacedList", "Error after, in the same colours")},
};

QWidget* thumbnails(const PlacedEntry& entry, QWidget* parent) {
  auto* strip = new QWidget(parent);
  auto* layout = new QHBoxLayout(strip);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  for (int kind = 0; kind < PlacedPictures::kCount; ++kind) {
    const QImage& image = entry.pictures.images[static_cast<std::size_t>(kind)];
    auto* button = new QToolButton(strip);
    button->setObjectName(QString("placedPicture%1").arg(kind));
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({kThumbnailWidth, kThumbnailHeight});
    button->setIcon(QPixmap::fromImage(
        image.scaled(kThumbnailWidth, kThumbnailHeight, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    button->setText(PlacedList::tr(kPictureTexts[kind].caption));
    button->setToolTip(PlacedList::tr("%1; click to enlarge").arg(PlacedList::tr(kPictureTexts[kind].description)));
    layout->addWidget(button);
    QObject::connect(button, &QToolButton::clicked, parent, [entry, parent] {
      auto* dialog = new PlacedPicturesDialog(entry, parent->window());
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      dialog->show();  // beside the window: what is proposed can be tried meanwhile
    });
  }
  layout->addStretch();
  return strip;
}

}  // namespace

PlacedList::PlacedList(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
}

void PlacedList::show(const std::vector<PlacedEntry>& entries) {
  delete rows_;
  ticks_.clear();
  rows_ = new QWidget(this);
  auto* column = new QVBoxLayout(rows_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const PlacedEntry& entry = entries[i];
    auto* tick = new QCheckBox(entry.name, rows_);
    tick->setObjectName(QString("placedProbe%1").arg(i));
    tick->setChecked(true);
    tick->setToolTip(tr("Untick what shall not be placed") + "\n" + entry.details);
    tick->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // the column is no wider for it
    connect(tick, &QCheckBox::toggled, this, &PlacedList::changed);
    ticks_.push_back(tick);
    column->addWidget(tick);
    QLabel* words = helpLabel(rows_);
    words->setObjectName(QString("placedReason%1").arg(i));
    words->setText(entry.gain.isEmpty() ? entry.reason : entry.reason + "\n" + entry.gain);
    words->setToolTip(entry.details);
    column->addWidget(words);
    if (!entry.pictures.images.front().isNull()) column->addWidget(thumbnails(entry, rows_));
  }
  layout()->addWidget(rows_);
}

bool PlacedList::ticked(std::size_t entry) const {
  return entry < ticks_.size() && ticks_[entry]->isChecked();
}

PlacedPicturesDialog::PlacedPicturesDialog(const PlacedEntry& entry, QWidget* parent) : QDialog(parent) {
  setObjectName("placedPictures");
  setWindowTitle(entry.name);
  auto* grid = new QGridLayout(this);
  const auto add = [&](int kind, int row, int column) {
    auto* cell = new QVBoxLayout;
    auto* picture = new QLabel(this);
    const QImage& image = entry.pictures.images[static_cast<std::size_t>(kind)];
    picture->setPixmap(QPixmap::fromImage(image.scaledToWidth(kLargeWidth, Qt::SmoothTransformation)));
    cell->addWidget(picture);
    cell->addWidget(new QLabel(PlacedList::tr(kPictureTexts[kind].description), this));
    grid->addLayout(cell, row, column);
  };
  add(PlacedPictures::Before, 0, 0);
  add(PlacedPictures::After, 0, 1);
  add(PlacedPictures::Traced, 0, 2);
  add(PlacedPictures::ErrorBefore, 1, 0);
  add(PlacedPictures::ErrorAfter, 1, 1);
  auto* words = new QLabel(entry.reason + "\n" + entry.gain + "\n\n" + entry.details, this);
  words->setWordWrap(true);
  words->setAlignment(Qt::AlignTop);
  words->setFixedWidth(kLargeWidth);
  grid->addWidget(words, 1, 2);
}

}  // namespace boxprobe
