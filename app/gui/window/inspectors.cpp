// See inspectors.h.
#include "app/gui/window/inspectors.h"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/panel_section.h"

namespace boxprobe {

namespace {

constexpr int kMargin = 8;

/// Names of any length: what does not fit is cut, the panels do not grow.
QLabel* nameLabel() {
  auto* label = new QLabel;
  QFont font = label->font();
  constexpr double kLarger = 1.2;
  font.setPointSizeF(kLarger * font.pointSizeF());
  font.setBold(true);
  label->setFont(font);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

Inspectors::Inspectors(QWidget* parent) : QWidget(parent), tabs_(new QTabWidget(this)) {
  tabs_->setObjectName("inspectors");
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setDrawBase(false);
  tabs_->setAccessibleName(tr("Inspectors"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tabs_);
  const QString titles[] = {tr("Probe"), tr("Object"), tr("Scene")};
  const char* const names[] = {"probeName", "objectName", "sceneName"};
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, kMargin, 0, 0);
    rows->setSpacing(2);
    auto* head = new QVBoxLayout;
    head->setContentsMargins(kMargin, 0, kMargin, 0);
    head->setSpacing(2);
    Sheet& sheet = sheets_[i];
    head->addWidget(sheet.name = nameLabel());
    sheet.name->setObjectName(names[i]);
    head->addWidget(sheet.about = helpLabel(page));
    sheet.about->setTextFormat(Qt::PlainText);  // it names what files name
    rows->addLayout(head);
    sheet.scroll = new QScrollArea;
    sheet.scroll->setWidgetResizable(true);
    sheet.scroll->setFrameShape(QFrame::NoFrame);
    sheet.scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rows->addWidget(sheet.scroll, 1);
    rows->addStretch(0);
    tabs_->addTab(page, titles[i]);
  }
}

void Inspectors::setPanels(Page page, const QList<QWidget*>& panels) {
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  layout->setSpacing(6);
  for (QWidget* panel : panels) layout->addWidget(panel);
  layout->addStretch(1);
  QScrollArea* scroll = sheets_[static_cast<std::size_t>(page)].scroll;
  scroll->setWidget(content);
  // What is cut off at the right edge cannot be scrolled to.
  scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
}

void Inspectors::setHeading(Page page, const QString& name, const QString& about) {
  const Sheet& sheet = sheets_[static_cast<std::size_t>(page)];
  sheet.name->setText(name);
  sheet.name->setToolTip(plainToolTip(name));
  sheet.about->setText(about);
}

void Inspectors::setEmpty(bool empty) {
  for (const Sheet& sheet : sheets_) sheet.scroll->setVisible(!empty);
}

void Inspectors::turnTo(Page page) {
  tabs_->setCurrentIndex(static_cast<int>(page));
}

void Inspectors::reveal(QWidget* panel) {
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    if (!sheets_[i].scroll->isAncestorOf(panel)) continue;
    tabs_->setCurrentIndex(static_cast<int>(i));
    sheets_[i].scroll->ensureWidgetVisible(panel);
  }
}

bool Inspectors::anythingLeft(const Sheet& sheet) const {
  const auto sections = sheet.scroll->findChildren<PanelSection*>();
  return std::any_of(sections.begin(), sections.end(),
                     [&sheet](const PanelSection* section) { return section->isVisibleTo(sheet.scroll->widget()); });
}

void Inspectors::turnToFound() {
  const auto current = static_cast<std::size_t>(std::max(tabs_->currentIndex(), 0));
  if (anythingLeft(sheets_[current])) return;
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    if (anythingLeft(sheets_[i])) return tabs_->setCurrentIndex(static_cast<int>(i));
  }
}

}  // namespace boxprobe
