// See widget_lines.h.
#include "tests/gui/widget_lines.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QScrollBar>
#include <QSlider>
#include <QTabWidget>
#include <QTextEdit>
#include <QToolButton>
#include <QTreeWidget>
#include <regex>

#include "tests/support/kept_values.h"

namespace boxprobe {

namespace {

QString number(double value) {
  return QString::number(value, 'g', 6);
}

QString quoted(const QString& text) {
  return "'" + QString(text).replace('\n', "|") + "'";
}

/// Parts of Qt's own widgets.
bool isPart(const QWidget& widget) {
  if (widget.isWindow() || qobject_cast<const QScrollBar*>(&widget) != nullptr) return true;
  if (widget.inherits("QHeaderView") || widget.inherits("QComboBoxPrivateContainer")) return true;
  if (widget.objectName().startsWith("qt_scrollarea_") && widget.objectName() != "qt_scrollarea_viewport") return true;
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  if (line == nullptr) return false;
  return widget.parent()->inherits("QAbstractSpinBox") || widget.parent()->inherits("QComboBox");
}

QString sizeLine(const QWidget& widget) {
  QString text;
  const auto add = [&text](const char* name, int value, int usual) {
    if (value != usual) text += QString(" %1=%2").arg(name).arg(value);
  };
  // What scrolls is as wide as the letters in it ask for.
  const bool scrolls = widget.inherits("QScrollArea") || widget.inherits("boxprobe::Inspectors");
  if (!scrolls) add("least-width", widget.minimumWidth(), 0);
  if (!scrolls) add("most-width", widget.maximumWidth(), QWIDGETSIZE_MAX);
  const QSizePolicy policy = widget.sizePolicy();
  text += QString(" policy=%1,%2").arg(policy.horizontalPolicy()).arg(policy.verticalPolicy());
  if (policy.hasHeightForWidth()) text += " height-for-width";
  return text;
}

QString layoutLine(const QLayout& layout) {
  const QMargins m = layout.contentsMargins();
  QString text = QString(" {%1 margins=%2,%3,%4,%5 spacing=%6")
                     .arg(layout.metaObject()->className())
                     .arg(m.left())
                     .arg(m.top())
                     .arg(m.right())
                     .arg(m.bottom())
                     .arg(layout.spacing());
  const auto* box = qobject_cast<const QBoxLayout*>(&layout);
  const auto* grid = qobject_cast<const QGridLayout*>(&layout);
  const auto* form = qobject_cast<const QFormLayout*>(&layout);
  if (box != nullptr) text += QString(" direction=%1").arg(box->direction());
  if (form != nullptr) {
    text += QString(" gaps=%1,%2 growth=%3 label-alignment=%4")
                .arg(form->horizontalSpacing())
                .arg(form->verticalSpacing())
                .arg(form->fieldGrowthPolicy())
                .arg(static_cast<int>(form->labelAlignment()));
  }
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem* item = layout.itemAt(i);
    text += " ";
    if (const QWidget* widget = item->widget()) {
      text += widget->metaObject()->className();
      if (!widget->objectName().isEmpty()) text += ":" + widget->objectName();
    } else if (QLayout* inner = item->layout()) {
      text += layoutLine(*inner).trimmed();
    } else {
      const QSize space = item->sizeHint();
      text += QString("space%1x%2").arg(space.width()).arg(space.height());
    }
    if (item->alignment() != 0) text += QString("@%1").arg(static_cast<int>(item->alignment()));
    if (box != nullptr && box->stretch(i) != 0) text += QString("*%1").arg(box->stretch(i));
    if (grid != nullptr) {
      int row = 0, column = 0, rows = 0, columns = 0;
      const_cast<QGridLayout*>(grid)->getItemPosition(i, &row, &column, &rows, &columns);
      text += QString("[%1,%2 %3x%4]").arg(row).arg(column).arg(rows).arg(columns);
    }
  }
  return text + "}";
}

QString contentLine(const QWidget& widget) {
  QString text;
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    text += " " + quoted(label->text()) + QString(" alignment=%1").arg(static_cast<int>(label->alignment()));
    if (label->wordWrap()) text += " wraps";
    if (label->textFormat() != Qt::AutoText) text += QString(" format=%1").arg(label->textFormat());
    if (label->textInteractionFlags() != Qt::LinksAccessibleByMouse) {
      text += QString(" interaction=%1").arg(static_cast<int>(label->textInteractionFlags()));
    }
    if (label->buddy() != nullptr) text += " buddy=" + QString(label->buddy()->metaObject()->className());
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    text += " " + quoted(button->text());
    if (button->isCheckable()) text += button->isChecked() ? " on" : " off";
    if (!button->icon().isNull()) {
      text += QString(" icon=%1x%2").arg(button->iconSize().width()).arg(button->iconSize().height());
    }
  }
  if (const auto* tool = qobject_cast<const QToolButton*>(&widget)) {
    text += QString(" style=%1 arrow=%2").arg(tool->toolButtonStyle()).arg(tool->arrowType());
    if (tool->autoRaise()) text += " flat";
  }
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) text += " " + quoted(group->title());
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
    text += QString(" chosen=%1").arg(combo->currentIndex());
    for (int i = 0; i < combo->count(); ++i) {
      text += " " + quoted(combo->itemText(i));
      if (combo->itemData(i).isValid()) text += "=" + combo->itemData(i).toString();
      const QString tip = combo->itemData(i, Qt::ToolTipRole).toString();
      if (!tip.isEmpty()) text += "(" + tip + ")";
      if (!combo->itemIcon(i).isNull()) text += "+icon";
    }
  }
  if (const auto* spin = qobject_cast<const QDoubleSpinBox*>(&widget)) {
    text += " " + quoted(spin->text()) + " " + number(spin->minimum()) + ".." + number(spin->maximum()) + " step " +
            number(spin->singleStep()) +
            QString(" decimals=%1 buttons=%2").arg(spin->decimals()).arg(spin->buttonSymbols());
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
    text += " " + quoted(line->text()) + " or " + quoted(line->placeholderText());
    if (line->isClearButtonEnabled()) text += " clears";
  }
  if (const auto* slider = qobject_cast<const QSlider*>(&widget)) {
    text += QString(" %1 of %2..%3 step %4 page %5")
                .arg(slider->value())
                .arg(slider->minimum())
                .arg(slider->maximum())
                .arg(slider->singleStep())
                .arg(slider->pageStep());
  }
  if (const auto* progress = qobject_cast<const QProgressBar*>(&widget)) {
    text += QString(" %1..%2").arg(progress->minimum()).arg(progress->maximum());
  }
  if (const auto* tabs = qobject_cast<const QTabWidget*>(&widget)) {
    text += QString(" tab=%1").arg(tabs->currentIndex());
    for (int i = 0; i < tabs->count(); ++i) {
      text += " " + quoted(tabs->tabText(i)) + (tabs->tabToolTip(i).isEmpty() ? "" : "(" + tabs->tabToolTip(i) + ")");
    }
  }
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) {
    text += QString(" selection=%1 edit=%2 elide=%3")
                .arg(view->selectionMode())
                .arg(static_cast<int>(view->editTriggers()))
                .arg(view->textElideMode());
  }
  if (const auto* area = qobject_cast<const QAbstractScrollArea*>(&widget)) {
    text += QString(" bars=%1,%2 frame=%3")
                .arg(area->horizontalScrollBarPolicy())
                .arg(area->verticalScrollBarPolicy())
                .arg(area->frameShape());
  }
  return text;
}

void addItems(const QTreeWidgetItem& parent, int level, std::vector<std::string>& lines) {
  for (int i = 0; i < parent.childCount(); ++i) {
    const QTreeWidgetItem& item = *parent.child(i);
    QString text(2 * level, ' ');
    for (int column = 0; column < item.columnCount(); ++column) {
      text += quoted(item.text(column)) + (item.toolTip(column).isEmpty() ? " " : "(" + item.toolTip(column) + ") ");
    }
    if (item.font(0).bold()) text += "bold ";
    if (item.isSelected()) text += "selected ";
    if (item.isExpanded()) text += "open ";
    if (item.isFirstColumnSpanned()) text += "wide ";
    lines.push_back(text.trimmed().isEmpty() ? std::string() : text.toStdString());
    addItems(item, level + 1, lines);
  }
}

void addLines(const QWidget& widget, int level, std::vector<std::string>& lines) {
  const bool viewport = widget.objectName() == "qt_scrollarea_viewport";
  if (!viewport) {
    QString text = QString(2 * level, ' ') + widget.metaObject()->className();
    if (!widget.objectName().isEmpty()) text += ":" + widget.objectName();
    if (widget.isHidden()) text += " hidden";
    if (widget.testAttribute(Qt::WA_ForceDisabled)) text += " grey";
    text += contentLine(widget);
    if (!widget.toolTip().isEmpty()) text += " tip=" + quoted(widget.toolTip());
    if (!widget.accessibleName().isEmpty()) text += " name=" + quoted(widget.accessibleName());
    if (!widget.styleSheet().isEmpty()) text += " style=" + quoted(widget.styleSheet());
    if (widget.contextMenuPolicy() != Qt::DefaultContextMenu)
      text += " menu=" + QString::number(widget.contextMenuPolicy());
    if (widget.testAttribute(Qt::WA_SetCursor)) text += " cursor=" + QString::number(widget.cursor().shape());
    if (widget.testAttribute(Qt::WA_TransparentForMouseEvents)) text += " under-the-mouse";
    text += QString(" focus=%1").arg(widget.focusPolicy()) + sizeLine(widget);
    if (widget.layout() != nullptr) text += layoutLine(*widget.layout());
    lines.push_back(text.toStdString());
    if (const auto* tree = qobject_cast<const QTreeWidget*>(&widget))
      addItems(*tree->invisibleRootItem(), level + 1, lines);
  }
  for (const QObject* child : widget.children()) {
    const auto* inner = qobject_cast<const QWidget*>(child);
    if (inner != nullptr && !isPart(*inner)) addLines(*inner, level + (viewport ? 0 : 1), lines);
  }
}

}  // namespace

std::vector<std::string> widgetLines(const QWidget& root) {
  std::vector<std::string> lines;
  addLines(root, 0, lines);
  return lines;
}

void expectKeptWidgets(const std::string& file, std::vector<std::string> lines) {
  if (std::string(qVersion()) == "5.15.8") return test::expectKeptValues(file, lines, test::kExactly);
  std::vector<std::string> kept = test::keptLines(file);
  ASSERT_EQ(lines.size(), kept.size());
  const std::regex width(" least-width=[0-9]+");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(std::regex_replace(lines[i], width, ""), std::regex_replace(kept[i], width, "")) << file << ":" << i + 1;
  }
}

}  // namespace boxprobe
