// See import_bar.h.
#include "app/gui/view/import_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace boxprobe {

QString unitName(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Metre:
      return ImportBar::tr("metres");
    case LengthUnit::Centimetre:
      return ImportBar::tr("centimetres");
    case LengthUnit::Millimetre:
      return ImportBar::tr("millimetres");
    case LengthUnit::Inch:
      return ImportBar::tr("inches");
    case LengthUnit::Foot:
      break;
  }
  return ImportBar::tr("feet");
}

QString upAxisName(UpAxis up) {
  return up == UpAxis::X ? ImportBar::tr("X up") : up == UpAxis::Y ? ImportBar::tr("Y up") : ImportBar::tr("Z up");
}

ImportBar::ImportBar(QWidget* picture)
    : QFrame(picture), text_(new QLabel(this)), unit_(new QComboBox(this)), up_(new QComboBox(this)) {
  setObjectName("importBar");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  setCursor(Qt::ArrowCursor);
  text_->setWordWrap(true);
  for (const LengthUnit unit :
       {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre, LengthUnit::Inch, LengthUnit::Foot}) {
    unit_->addItem(unitName(unit), static_cast<int>(unit));
  }
  for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::X}) up_->addItem(upAxisName(up), static_cast<int>(up));
  unit_->setObjectName("importUnit");
  unit_->setToolTip(tr("Length of one unit in the model file"));
  up_->setObjectName("importUp");
  up_->setToolTip(tr("Axis that points up in the model file"));
  auto* apply = new QPushButton(tr("Apply"), this);
  apply->setObjectName("importApply");
  apply->setToolTip(
      tr("Reads the model that way, and finds probe, camera and light for it again. Undo takes all of it back"));
  auto* keep = new QPushButton(tr("Keep as it is"), this);
  keep->setObjectName("importKeep");
  keep->setToolTip(tr("Model > Unit and up axis asks again"));

  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("The file is in"), this));
  row->addWidget(unit_);
  row->addWidget(new QLabel(tr("with"), this));
  row->addWidget(up_);
  row->addStretch(1);
  row->addWidget(apply);
  row->addWidget(keep);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 8);
  layout->addWidget(text_);
  layout->addLayout(row);
  connect(apply, &QPushButton::clicked, this, [this] {
    hide();
    emit chosen(static_cast<LengthUnit>(unit_->currentData().toInt()), static_cast<UpAxis>(up_->currentData().toInt()));
  });
  connect(keep, &QPushButton::clicked, this, &QWidget::hide);
  picture->installEventFilter(this);
  hide();
}

void ImportBar::ask(const QString& why, LengthUnit unit, UpAxis up) {
  text_->setText(why.isEmpty() ? tr("How is the model file meant?")
                               : tr("%1. Is the file in %2, %3?").arg(why, unitName(unit), upAxisName(up)));
  unit_->setCurrentIndex(unit_->findData(static_cast<int>(unit)));
  up_->setCurrentIndex(up_->findData(static_cast<int>(up)));
  show();
  place();
  raise();
}

bool ImportBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && !isHidden()) place();
  return QFrame::eventFilter(watched, event);
}

void ImportBar::place() {
  constexpr int kMargin = 8, kWidest = 620;
  const int room = std::min(kWidest, parentWidget()->width() - 2 * kMargin);
  const int width = std::max(room, layout()->minimumSize().width());
  const int height = layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height();
  setGeometry(std::max((parentWidget()->width() - width) / 2, 0), kMargin, width, height);
}

}  // namespace boxprobe
