// See panel_section.h.
#include "app/gui/widgets/panel_section.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QVBoxLayout>

#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/search_field.h"

namespace boxprobe {

namespace {

QString plainText(QString text) {
  return text.remove('&');
}

}  // namespace

PanelSection::PanelSection(const QString& title, QWidget* parent)
    : QGroupBox(parent), title_(title), folded_(sectionIsFolded(title)) {
  setToolTip(QString());
  setAccessibleName(title);  // without the mark that shows whether it is folded
  // What the keyboard comes to is seen.
  connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
    if (folded_ && now != nullptr && now != this && isAncestorOf(now)) setFolded(false);
  });
  follow();
}

void PanelSection::setFolded(bool folded) {
  if (folded == folded_) return;
  folded_ = folded;
  keepSectionFolded(title_, folded);
  follow();
}

bool PanelSection::has(const QString& words) const {
  const auto matches = [&words](const QString& text) { return plainText(text).contains(words, Qt::CaseInsensitive); };
  if (matches(title_)) return true;
  for (const QLabel* label : findChildren<QLabel*>()) {
    if (matches(label->text()) || matches(label->toolTip())) return true;
  }
  for (const QAbstractButton* button : findChildren<QAbstractButton*>()) {
    if (matches(button->text()) || matches(button->toolTip())) return true;
  }
  for (const QComboBox* combo : findChildren<QComboBox*>()) {
    if (matches(combo->toolTip())) return true;
  }
  return false;
}

bool PanelSection::showIfFound(const QString& words) {
  const bool before = found_;
  searching_ = !words.isEmpty();
  found_ = !searching_ || has(words);
  follow();
  if (before != found_) QGroupBox::setVisible(wanted_ && found_);
  return found_;
}

void PanelSection::setVisible(bool visible) {
  wanted_ = visible;
  QGroupBox::setVisible(wanted_ && found_);
}

void PanelSection::follow() {
  const bool folded = folded_ && !searching_;
  setTitle((folded ? QString::fromUtf8("\u25b8 ") : QString::fromUtf8("\u25be ")) + title_);
  // The title alone: the rest is cut off, and comes back as it was.
  constexpr int kMargin = 14;
  setMaximumHeight(folded ? fontMetrics().height() + kMargin : QWIDGETSIZE_MAX);
}

void PanelSection::mousePressEvent(QMouseEvent* event) {
  const bool onTitle = event->pos().y() <= fontMetrics().height() + 8;
  if (!onTitle || event->button() != Qt::LeftButton || searching_) return QGroupBox::mousePressEvent(event);
  setFolded(!folded_);
}

QWidget* withSearch(QWidget* content, const QString& hint) {
  auto* whole = new QWidget;
  auto* layout = new QVBoxLayout(whole);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* words = new SearchField(whole);
  words->setObjectName("search");
  words->setPlaceholderText(hint);
  words->setClearButtonEnabled(true);
  auto* row = new QVBoxLayout;
  row->setContentsMargins(8, 4, 8, 0);
  row->addWidget(words);
  layout->addLayout(row);
  layout->addWidget(content, 1);
  QObject::connect(words, &QLineEdit::textChanged, content, [content](const QString& text) {
    for (PanelSection* section : content->findChildren<PanelSection*>()) section->showIfFound(text.trimmed());
  });
  return whole;
}

}  // namespace boxprobe
