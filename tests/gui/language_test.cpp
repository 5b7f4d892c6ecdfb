// The window in other languages: which one is chosen, that no text is missing or loses a number's place, that nothing
// is cut in German on a small screen. A program of its own: a window's language is fixed when it is made.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <map>
#include <set>

#include "app/gui/view/viewport.h"
#include "app/gui/widgets/table_words.h"
#include "app/gui/widgets/window_language.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/core/scene/surface_view.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/rays/ray_arrays.h"
#include "tests/gui/translated_texts.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

std::multiset<QString> placesIn(const QString& text) {
  static const QRegularExpression kPlace("%(L?\\d+|n)");
  std::multiset<QString> places;
  for (auto all = kPlace.globalMatch(text); all.hasNext();) places.insert(all.next().captured());
  return places;
}

/// Letters to press with Alt.
int keysIn(QString text) {
  return static_cast<int>(text.remove("&&").count('&'));
}

class TranslationTest : public ::testing::TestWithParam<const char*> {};

TEST_P(TranslationTest, NothingIsMissingAndPlacesOfValuesStay) {
  const std::vector<Message> messages = messagesOf(GetParam());
  EXPECT_GT(messages.size(), 1000u);
  for (const Message& each : messages) {
    const std::string what = each.context.toStdString() + ": " + each.source.toStdString();
    EXPECT_TRUE(each.finished && !each.translation.isEmpty()) << what << " has no translation";
    EXPECT_EQ(placesIn(each.source), placesIn(each.translation)) << what << ": " << each.translation.toStdString();
    EXPECT_EQ(keysIn(each.source) > 0, keysIn(each.translation) > 0) << what << ": " << each.translation.toStdString();
    EXPECT_LE(keysIn(each.translation), 1) << each.translation.toStdString();
    EXPECT_EQ(each.source.count('\n'), each.translation.count('\n')) << what;
  }
}

TEST_P(TranslationTest, WordsOfTheTablesHaveTranslations) {
  const QStringList listed = tableTexts();
  const std::set<QString> known(listed.begin(), listed.end());
  const auto expect = [&known](std::string_view text) {
    const QString words = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
    EXPECT_TRUE(words.isEmpty() || known.count(words) == 1) << words.toStdString() << " is not in table_words.cpp";
  };
  for (const SurfaceViewRow& row : surfaceViews()) {
    expect(row.label);
    expect(row.help);
  }
  for (const auto& row : projectionRows()) {
    expect(row.label);
    expect(row.help);
  }
  for (const auto& row : evaluationRows()) {
    expect(row.label);
    expect(row.help);
  }
  for (const auto& row : parameterRows()) {
    expect(row.label);
    expect(row.help);
  }
  for (const std::string_view name : kRayKindNames) expect(name);
  const auto fields = [&expect](const auto& rows, const std::set<std::string_view>& ofFilesAlone) {
    for (const FieldInfo& field : rows) {
      if (ofFilesAlone.count(field.key) == 0) expect(field.help);
    }
  };
  fields(probeFields(), {"technique", "parameters", "image"});
  fields(lightFields(), {});
  fields(materialFields(), {"metallic"});
  fields(objectFields(), {});
  fields(mirrorFields(), {});
  for (const char* key : {"origin", "blendDistance", "faceSize"}) {
    ASSERT_EQ(loadLanguage(GetParam()), GetParam());
    const std::string_view help = probeField(key).help;
    EXPECT_NE(tableWords(help).toStdString(), std::string(help));
    loadLanguage("en");
    EXPECT_EQ(tableWords(help).toStdString(), std::string(help));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TranslationTest, ::testing::Values("de", "zh_CN"));

TEST(LanguageTest, TheSystemsFirstThatThereIsIsTaken) {
  EXPECT_EQ(languageFor({"de-AT"}), "de");
  EXPECT_EQ(languageFor({"de_DE", "en"}), "de");
  EXPECT_EQ(languageFor({"zh-Hans-CN"}), "zh_CN");
  EXPECT_EQ(languageFor({"zh-CN"}), "zh_CN");
  EXPECT_EQ(languageFor({"zh"}), "zh_CN");
  EXPECT_EQ(languageFor({"zh-Hant-TW", "de"}), "de") << "Traditional Chinese is another script";
  EXPECT_EQ(languageFor({"zh-TW"}), "en");
  EXPECT_EQ(languageFor({"fr-FR", "de-DE"}), "de");
  EXPECT_EQ(languageFor({"C"}), "en");
  EXPECT_EQ(languageFor({}), "en");
  EXPECT_EQ(languageFor({""}), "en");
}

TEST(LanguageTest, WhatTheSettingsHaveButNobodyTranslatedIsTheSystems) {
  keepLanguage("de");
  EXPECT_EQ(chosenLanguage(), "de");
  keepLanguage("../../etc/passwd");
  EXPECT_EQ(chosenLanguage(), "");
  keepLanguage("");
}

/// A window made in German.
class GermanWindowTest : public WindowTest {
 protected:
  static void SetUpTestSuite() { ASSERT_EQ(loadLanguage("de"), "de"); }
  static void TearDownTestSuite() {
    sharedWindow().reset();
    loadLanguage("en");
  }
};

std::string pathOf(const QWidget* widget) {
  QString path;
  for (const QWidget* each = widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    path = "/" + QString(each->metaObject()->className()) + ":" + each->objectName() + path;
  }
  return path.toStdString();
}

int widthOf(const QWidget* widget, QString text) {
  return widget->fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

/// Pixels that the text of a control lacks; what no text is read from lacks none.
int lacking(const QWidget* widget, QString& text) {
  if (const auto* label = qobject_cast<const QLabel*>(widget)) {
    text = label->text();
    if (label->wordWrap() || text.isEmpty()) return 0;
    return label->sizeHint().width() - label->width();
  }
  if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
    text = combo->currentText();
    QStyleOptionComboBox option;
    option.initFrom(combo);
    option.editable = combo->isEditable();
    const QRect field =
        combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
    return widthOf(combo, text) - field.width();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
    text = button->text();
    if (const auto* tool = qobject_cast<const QToolButton*>(button)) {
      if (tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return 0;
    }
    if (text.isEmpty()) return 0;
    const int icon = button->icon().isNull() ? 0 : button->iconSize().width();
    const int mark = qobject_cast<const QCheckBox*>(button) != nullptr
                         ? button->style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, button)
                         : 0;
    return widthOf(button, text) + icon + mark - button->width();
  }
  return 0;
}

std::vector<std::string> cutTexts(const QWidget& window) {
  std::vector<std::string> cut;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
      for (int i = 0; i < tabs->count(); ++i) {
        const int lacks = widthOf(tabs, tabs->tabText(i)) - tabs->tabRect(i).width();
        if (lacks > 0)
          cut.push_back(pathOf(tabs) + " " + tabs->tabText(i).toStdString() + ": " + std::to_string(lacks));
      }
      continue;
    }
    QString text;
    int lacks = lacking(widget, text);
    // What sticks out of the area that scrolls it from top to bottom alone.
    for (const QWidget* above = widget->parentWidget(); above != nullptr && !text.isEmpty();
         above = above->parentWidget()) {
      const auto* area = qobject_cast<const QScrollArea*>(above);
      if (area == nullptr) continue;
      const int left = widget->mapTo(area->viewport(), QPoint()).x();
      lacks = std::max({lacks, -left, left + widget->width() - area->viewport()->width()});
    }
    if (lacks > 0) cut.push_back(pathOf(widget) + " \"" + text.toStdString() + "\": " + std::to_string(lacks));
  }
  return cut;
}

/// What keeps a window from being narrower.
std::string widest(const QWidget& window) {
  constexpr int kWide = 380;
  std::string text;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    const int least = widget->minimumSizeHint().width();
    if (least < kWide || !widget->findChildren<QWidget*>().isEmpty()) continue;
    QString words;
    lacking(widget, words);
    text += "\n  " + std::to_string(least) + " " + pathOf(widget) + " " + words.toStdString();
  }
  return text;
}

/// Two commands of a menu with the same letter.
std::vector<std::string> sharedLetters(const QMenu& menu) {
  static const QRegularExpression kLetter("&([^&])");
  std::map<QString, QString> letters;
  std::vector<std::string> shared;
  for (const QAction* action : menu.actions()) {
    const QString letter = kLetter.match(QString(action->text()).remove("&&")).captured(1).toLower();
    if (letter.isEmpty()) continue;
    if (letters.count(letter) > 0) {
      shared.push_back((menu.title() + ": " + letters[letter] + ", " + action->text()).toStdString());
    }
    letters[letter] = action->text();
  }
  return shared;
}

TEST_F(GermanWindowTest, NothingIsCutOnASmallScreen) {
  EXPECT_EQ(window_->menuBar()->actions().front()->text(), "&Datei");
  const auto tabs = window_->findChild<QTabWidget*>("inspectors");
  for (const auto& [width, height] : {std::pair(1024, 700), std::pair(1440, 900)}) {
    window_->resize(width, height);
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      waitUntilIdle();
      EXPECT_TRUE(window_->size() == QSize(width, height)) << window_->width() << " wide:" << widest(*window_);
      for (const std::string& each : cutTexts(*window_)) {
        ADD_FAILURE() << width << " x " << height << ", " << tabs->tabText(i).toStdString() << ": " << each;
      }
      if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) {
        window_->grab().save(QString(out) + QString("/de-%1-%2.png").arg(width).arg(i));
      }
    }
  }
  tabs->setCurrentIndex(0);
  window_->resize(1024, 700);
  for (const char* name : {"cubemap", "debug", "explain", "cost", "frame", "probes"}) {
    auto* dock = window_->findChild<QDockWidget*>(name);
    ASSERT_NE(dock, nullptr) << name;
    dock->raise();
    waitUntilIdle();
    for (const std::string& each : cutTexts(*window_)) ADD_FAILURE() << name << ": " << each;
    if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString(out) + QString("/de-dock-%1.png").arg(name));
    }
  }
}

/// What is called so in files: names of a scene, and ids of techniques.
QStringList namesIn(const Scene& scene, const Model& model) {
  QStringList names;
  for (const auto& object : model.instances) names += QString::fromStdString(object.node);
  for (const auto& material : model.materials) names += QString::fromStdString(material.name);
  for (const Probe& probe : scene.probes) names += QString::fromStdString(probe.name);
  for (const Camera& camera : scene.cameras) names += QString::fromStdString(camera.name);
  for (const auto& row : projectionRows()) names += QString::fromUtf8(row.id.data(), static_cast<int>(row.id.size()));
  for (const auto& row : evaluationRows()) names += QString::fromUtf8(row.id.data(), static_cast<int>(row.id.size()));
  return names.join(' ').split(' ');
}

TEST_F(GermanWindowTest, NoEnglishWordIsLeft) {
  QStringList names = namesIn(document().scene(), *window_->models().front());
  // Qt's own, where its translations are not installed; and a parameter of techniques.
  names << "scroll"
        << "left"
        << "right"
        << "float"
        << "close"
        << "filtered";
  const EnglishWords english("de", names);
  // Paths of files; the default of a field, as scene files have it.
  static const QRegularExpression kPath("\\S*(/\\S+|\\.json\\S*)"), kDefault("Standard: .*$");
  std::set<QString> seen;
  window_->resize(1024, 700);
  window_->findChild<QPushButton*>("explainTool")->click();
  for (const char* name : {"cubemap", "debug", "cost", "frame", "explain"}) {
    window_->findChild<QDockWidget*>(name)->raise();
    move(QPointF(0.5 * window_->viewport().width(), 0.5 * window_->viewport().height()));
    waitUntilIdle();
    for (const QString& text : shownTexts(*window_)) {
      for (QString line : text.split('\n')) {
        if (!seen.insert(line).second) continue;
        const std::string words = english.in(line.remove(kPath).remove(kDefault));
        EXPECT_TRUE(words.empty()) << name << ": " << words;
      }
    }
  }
  EXPECT_GT(seen.size(), 500u);
  if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) window_->grab().save(QString(out) + "/de-explained.png");
  window_->findChild<QPushButton*>("explainTool")->click();
  window_->findChild<QDockWidget*>("probes")->raise();
}

TEST_F(GermanWindowTest, NoTwoCommandsOfAMenuShareALetter) {
  for (const QMenu* menu : window_->findChildren<QMenu*>()) {
    for (const std::string& each : sharedLetters(*menu)) ADD_FAILURE() << each;
  }
}

TEST_F(GermanWindowTest, TheLanguageIsChosenInAMenuForTheNextStart) {
  auto* menu = window_->findChild<QMenu*>("languages");
  ASSERT_NE(menu, nullptr);
  auto* chinese = window_->findChild<QAction*>("language_zh_CN");
  ASSERT_NE(chinese, nullptr);
  EXPECT_TRUE(menu->toolTipsVisible());
  EXPECT_NE(chinese->toolTip(), chinese->text()) << "says that nobody has reviewed it";
  EXPECT_TRUE(window_->findChild<QAction*>("language_")->isChecked());
  chinese->trigger();
  EXPECT_EQ(chosenLanguage(), "zh_CN");
  EXPECT_TRUE(window_->statusBar()->currentMessage().contains(chinese->text()));
  EXPECT_EQ(window_->menuBar()->actions().front()->text(), "&Datei") << "until then it stays";
  window_->findChild<QAction*>("language_")->trigger();
  EXPECT_EQ(chosenLanguage(), "");
}

/// A window laid out from right to left.
class MirroredWindowTest : public WindowTest {
 protected:
  static void SetUpTestSuite() { QApplication::setLayoutDirection(Qt::RightToLeft); }
  static void TearDownTestSuite() {
    sharedWindow().reset();
    QApplication::setLayoutDirection(Qt::LeftToRight);
  }
};

TEST_F(MirroredWindowTest, PanelsSwapSidesAndNothingIsCut) {
  const auto tabs = window_->findChild<QTabWidget*>("inspectors");
  const auto place = [this](const QWidget* widget) {
    return widget->mapTo(window_, QPoint(widget->width() / 2, 0)).x();
  };
  EXPECT_LT(place(tabs), place(window_->findChild<QDockWidget*>("outliner")));
  for (int i = 0; i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    window_->resize(1024, 700);
    waitUntilIdle();
    for (const std::string& each : cutTexts(*window_)) ADD_FAILURE() << tabs->tabText(i).toStdString() << ": " << each;
    if (const char* out = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString(out) + QString("/rtl-%1.png").arg(i));
    }
  }
  tabs->setCurrentIndex(0);
}

/// Made last: in Chinese, for whoever looks at the pictures. Fonts of this machine may have none of its letters.
class ChineseWindowTest : public WindowTest {
 protected:
  static void SetUpTestSuite() { ASSERT_EQ(loadLanguage("zh_CN"), "zh_CN"); }
  static void TearDownTestSuite() {
    sharedWindow().reset();
    loadLanguage("en");
  }
};

TEST_F(ChineseWindowTest, CommandsHaveTheirLettersInBrackets) {
  EXPECT_EQ(window_->menuBar()->actions().front()->text(), QString::fromUtf8("文件(&F)"));
  const auto tabs = window_->findChild<QTabWidget*>("inspectors");
  const char* out = std::getenv("BOXPROBE_TEST_OUTPUT");
  for (int i = 0; out != nullptr && i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    window_->resize(1024, 700);
    waitUntilIdle();
    window_->grab().save(QString(out) + QString("/zh-%1.png").arg(i));
  }
  tabs->setCurrentIndex(0);
}

}  // namespace
}  // namespace boxprobe
