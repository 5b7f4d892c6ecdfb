// What screen readers are told: every control has a name, sections are read without the mark of their fold. Keys that
// the layout has elsewhere, sizes of small screens, panels without a selection.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTest>
#include <map>

#include "app/gui/panels/capture_panel.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/panels/probe_panel.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/differs.h"
#include "app/gui/widgets/panel_section.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "app/gui/window/about_dialog.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class AccessibleTest : public WindowTest {};

/// Where it stands, for messages.
std::string pathOf(const QWidget* widget) {
  QString path;
  for (const QWidget* each = widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    path = "/" + QString(each->metaObject()->className()) + ":" + each->objectName() + path;
  }
  return path.toStdString();
}

TEST_F(AccessibleTest, EveryControlHasAName) {
  std::map<QAccessible::Role, int> seen;
  const auto widgets = window_->findChildren<QWidget*>();
  for (QWidget* widget : widgets) {
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    if (told == nullptr) continue;
    const QAccessible::Role role = told->role();
    const bool inside = qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) != nullptr ||
                        qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr;
    switch (role) {
      case QAccessible::EditableText:
        if (inside) continue;
        [[fallthrough]];
      case QAccessible::SpinBox:
      case QAccessible::PushButton:
      case QAccessible::ButtonMenu:
      case QAccessible::ButtonDropDown:
      case QAccessible::CheckBox:
      case QAccessible::RadioButton:
      case QAccessible::ComboBox:
      case QAccessible::Slider:
        ++seen[role];
        EXPECT_FALSE(told->text(QAccessible::Name).trimmed().isEmpty()) << pathOf(widget);
        // On Unix Qt tells of a combo box what is chosen, whatever its name.
        EXPECT_FALSE(role == QAccessible::ComboBox && widget->accessibleName().isEmpty()) << pathOf(widget);
        break;
      default:
        break;
    }
  }
  EXPECT_GT(seen[QAccessible::SpinBox], 60);
  EXPECT_GT(seen[QAccessible::ComboBox], 15);
  EXPECT_GT(seen[QAccessible::Slider], 1);
  const auto name = [](QWidget* widget) {
    return QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name);
  };
  EXPECT_EQ(name(window_->findChild<VectorRow*>("origin")->field(0)), "Origin X");
  EXPECT_EQ(name(window_->findChild<VectorRow*>("boxMax")->field(2)), "Box max Z");
  const auto* technique = window_->findChild<QWidget*>("technique")->findChildren<QComboBox*>().front();
  EXPECT_TRUE(technique->accessibleName().startsWith("Technique")) << technique->accessibleName().toStdString();
}

TEST_F(AccessibleTest, SectionsAreReadWithoutTheMarkOfTheirFold) {
  const auto sections = window_->findChildren<PanelSection*>();
  EXPECT_GT(sections.size(), 8);
  for (PanelSection* section : sections) {
    const QString name = QAccessible::queryAccessibleInterface(section)->text(QAccessible::Name);
    EXPECT_FALSE(name.isEmpty());
    EXPECT_FALSE(name.contains(QChar(0x25b8)) || name.contains(QChar(0x25be))) << name.toStdString();
  }
}

TEST_F(AccessibleTest, WithoutASelectionNoOldValuesStay) {
  ASSERT_TRUE(document().selectedProbe().has_value());
  document().selectProbe(std::nullopt);
  int ticks = 0;
  for (QWidget* panel : {static_cast<QWidget*>(window_->findChild<ProbePanel*>()),
                         static_cast<QWidget*>(window_->findChild<CapturePanel*>())}) {
    const auto fields = panel->findChildren<ValueField*>();
    for (const ValueField* field : fields) {
      EXPECT_TRUE(field->differs()) << pathOf(field) << " shows " << field->text().toStdString();
    }
    const auto labels = panel->findChildren<QLabel*>();
    for (const QLabel* label : labels)
      EXPECT_FALSE(label->text().contains(QRegularExpression("[0-9] m"))) << label->text().toStdString();
    const auto boxes = panel->findChildren<QCheckBox*>();
    for (const QCheckBox* box : boxes) EXPECT_EQ(box->checkState(), Qt::Unchecked) << pathOf(box);
    ticks += static_cast<int>(boxes.size());
  }
  EXPECT_GT(ticks, 0);
  document().selectProbe(0);
  auto* origin = window_->findChild<VectorRow*>("origin");
  EXPECT_FALSE(origin->field(1)->differs());
  EXPECT_NEAR(origin->field(1)->text().split(' ').front().toDouble(), probe().origin.y, 0.001);
}

/// A key as X11 sends it: its code, and what the layout has there.
void sendKey(QWidget* over, quint32 code, int key, const QString& text, Qt::KeyboardModifiers modifiers = {}) {
  for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
    QKeyEvent event(type, key, modifiers, code, 0, 0, text);
    QCoreApplication::sendEvent(over, &event);
  }
}

TEST_F(AccessibleTest, ShortcutsAreFoundByThePlaceOfTheirKey) {
  const auto mode = [this](const char* name) { return window_->findChild<QAction*>(name)->isChecked(); };
  QWidget* picture = &window_->viewport();
  picture->setFocus();
  sendKey(picture, 12, Qt::Key_QuoteDbl, "\"");  // AZERTY, the third of the upper row
  EXPECT_TRUE(mode("handles3"));
  sendKey(picture, 10, Qt::Key_Ampersand, "&");
  EXPECT_TRUE(mode("handles1"));
  auto* walk = window_->findChild<QAction*>("walk");
  sendKey(picture, 42, 0x41f, QString(QChar(0x43f)));  // Cyrillic Pe, where QWERTY has G
  EXPECT_TRUE(walk->isChecked());
  sendKey(picture, 42, 0x41f, QString(QChar(0x43f)));
  EXPECT_FALSE(walk->isChecked());
  // A layout with Latin letters goes by them, wherever they are.
  sendKey(picture, 42, Qt::Key_I, "i");
  EXPECT_FALSE(walk->isChecked());
  // What is typed into a field is text.
  auto* search = window_->findChild<QLineEdit*>("search");
  search->setFocus();
  sendKey(search, 42, 0x41f, QString(QChar(0x43f)));
  EXPECT_FALSE(walk->isChecked());
  search->clear();
  waitUntilIdle();
}

TEST_F(AccessibleTest, AboutFitsASmallScreen) {
  QDialog* about = aboutDialog(window_);
  about->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(about, 60000));
  EXPECT_LE(about->width(), 1024);
  EXPECT_LE(about->height(), 640) << "of 700, for panels and a frame";
  auto* ok = about->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  EXPECT_TRUE(about->rect().contains(QRect(ok->mapTo(about, QPoint()), ok->size())));
  QTest::mouseClick(ok, Qt::LeftButton);
  EXPECT_FALSE(about->isVisible());
  delete about;
}

TEST_F(AccessibleTest, F1TogglesTheLessonsWithoutGrowingASmallWindow) {
  const QSize before = window_->size();
  window_->resize(1024, 700);
  QCoreApplication::processEvents();
  const QSize small = window_->size();
  EXPECT_EQ(small, QSize(1024, 700));
  auto* lessons = window_->findChild<QDockWidget*>("lessons");
  window_->viewport().setFocus();
  key(Qt::Key_F1);
  EXPECT_TRUE(waitFor([&] { return lessons->isVisible(); }));
  QTest::qWait(50);
  EXPECT_EQ(window_->size(), small);
  key(Qt::Key_F1);
  EXPECT_FALSE(lessons->isVisible());
  EXPECT_EQ(window_->size(), small);
  window_->addDockWidget(Qt::LeftDockWidgetArea, lessons);
  lessons->hide();
  window_->resize(before);
  waitUntilIdle();
}

}  // namespace
}  // namespace boxprobe
