// See compare_views.h.
#include "app/gui/view/compare_views.h"

#include <QEvent>
#include <QPainter>

#include "app/gui/widgets/quiet_combo.h"

namespace boxprobe {

namespace {

constexpr int kLine = 36;     ///< logical pixels under each picture: two lines of numbers
constexpr int kNarrow = 360;  ///< in views below, the numbers stand under the choice
constexpr int kGap = 4;
constexpr int kMostCombo = 200;
const QColor kGround(16, 18, 22), kText(244, 244, 244);

}  // namespace

CompareViews::CompareViews(QWidget* picture, const std::vector<Choice>& choices) : QWidget(picture) {
  setObjectName("compareViews");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  for (int view = 0; view < kViews; ++view) {
    // Beside this widget and not in it: it takes the mouse.
    auto* combo = new QuietCombo(picture);
    combo->setObjectName(QString("compareView%1").arg(view));
    combo->setToolTip(tr(
        "This view shows what you choose here. The error beside it tells how far its display colours are from those of "
        "the ray-traced view, or of the scene as it is: the mean in percent of white, and the PSNR. Once the traced "
        "view is as fine: its mean light over the traced one's, and the relative RMSE, as the benchmark of whole "
        "pictures measures them"));
    combo->setMaxVisibleItems(24);
    for (const Choice& choice : choices) {
      combo->addItem(choice.text, choice.id);
      combo->setItemData(combo->count() - 1, choice.toolTip, Qt::ToolTipRole);
    }
    connect(combo, QOverload<int>::of(&QComboBox::activated), this, [this, view] { emit chosenAnew(view); });
    cells_[static_cast<std::size_t>(view)].choice = combo;
  }
  picture->installEventFilter(this);
  setShown(false);
}

void CompareViews::choose(int view, const QString& id) {
  QComboBox* combo = cells_[static_cast<std::size_t>(view)].choice;
  combo->setCurrentIndex(combo->findData(id));
}

QString CompareViews::chosen(int view) const {
  return cells_[static_cast<std::size_t>(view)].choice->currentData().toString();
}

void CompareViews::show(int view, const QImage& picture, const QString& note) {
  Cell& cell = cells_[static_cast<std::size_t>(view)];
  cell.picture = picture;
  cell.note = note;
  update();
}

void CompareViews::showNumbers(int view, const QString& text) {
  cells_[static_cast<std::size_t>(view)].numbers = text;
  update();
}

void CompareViews::setShown(bool shown) {
  setVisible(shown);
  for (const Cell& cell : cells_) cell.choice->setVisible(shown);
  if (!shown) return;
  arrange();
  raise();
  for (const Cell& cell : cells_) cell.choice->raise();
}

QFont CompareViews::fontFor(const QString& text, int width) const {
  constexpr double kLeast = 0.7;  // smaller, nobody reads it
  QFont smaller = font();
  const int needed = QFontMetrics(smaller).horizontalAdvance(text);
  if (needed <= width) return smaller;
  smaller.setPointSizeF(smaller.pointSizeF() * std::max(kLeast, static_cast<double>(width) / needed));
  return smaller;
}

bool CompareViews::narrow() const {
  return place(0).width() < kNarrow;
}

int CompareViews::strip() const {
  return narrow() ? 2 * kLine : kLine;
}

QRect CompareViews::place(int view) const {
  const int width = (this->width() - kGap) / 2, height = (this->height() - kGap) / 2;
  return {(view % 2) * (width + kGap), (view / 2) * (height + kGap), width, height};
}

void CompareViews::arrange() {
  setGeometry(QRect(QPoint(0, 0), parentWidget()->size()));
  for (int view = 0; view < kViews; ++view) {
    const QRect room = place(view);
    QComboBox* combo = cells_[static_cast<std::size_t>(view)].choice;
    const int width = narrow() ? room.width() - 4 : std::min(kMostCombo, room.width() * 2 / 5);
    combo->setGeometry(room.left() + 2, room.bottom() - strip() + 4, width, kLine - 7);
  }
  update();
}

void CompareViews::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), QColor(70, 74, 82));
  for (int view = 0; view < kViews; ++view) {
    const Cell& cell = cells_[static_cast<std::size_t>(view)];
    const QRect all = place(view), room = all.adjusted(0, 0, 0, -strip());
    painter.fillRect(all, kGround);
    if (!cell.picture.isNull()) {
      const QSize size = cell.picture.size().scaled(room.size(), Qt::KeepAspectRatio);
      const QPoint corner = room.topLeft() + QPoint((room.width() - size.width()) / 2, 0);
      painter.drawImage(QRect(corner, size), cell.picture);
    }
    painter.setPen(kText);
    if (!cell.note.isEmpty()) {
      const QRect note = painter.boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, cell.note);
      painter.fillRect(note.adjusted(-8, -5, 8, 5), QColor(16, 18, 22, 210));
      painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, cell.note);
    }
    const int left = narrow() ? all.left() + 4 : cell.choice->geometry().right() + 8;
    const QRect line(left, all.bottom() - kLine + 1, all.right() - left - 4, kLine);
    const QStringList texts = cell.numbers.split('\n');
    for (int i = 0; i < texts.size(); ++i) {
      const QRect own(line.left(), line.top() + i * kLine / texts.size(), line.width(), kLine / texts.size());
      painter.setFont(fontFor(texts[i], own.width()));
      painter.drawText(own, Qt::AlignVCenter | Qt::AlignLeft,
                       painter.fontMetrics().elidedText(texts[i], Qt::ElideRight, own.width()));
    }
    painter.setFont(font());
  }
}

bool CompareViews::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisibleTo(parentWidget())) arrange();
  return QWidget::eventFilter(watched, event);
}

}  // namespace boxprobe
