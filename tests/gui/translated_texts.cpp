#include "tests/gui/translated_texts.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextBrowser>
#include <QTextDocumentFragment>
#include <QXmlStreamReader>

namespace boxprobe {

namespace {

/// In lower case. Names of fields and of techniques, in backticks, are nobody's words.
std::set<QString> wordsOf(QString text) {
  static const QRegularExpression kId("`[^`]*`"), kWord("\\b[A-Za-z]{3,}\\b");
  text.replace(kId, " ").remove('&');
  std::set<QString> words;
  for (auto all = kWord.globalMatch(text); all.hasNext();) words.insert(all.next().captured().toLower());
  return words;
}

void addItems(const QAbstractItemModel& model, const QModelIndex& parent, QStringList& texts) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    for (int column = 0; column < model.columnCount(parent); ++column) {
      const QModelIndex index = model.index(row, column, parent);
      texts += model.data(index, Qt::DisplayRole).toString();
      texts += model.data(index, Qt::ToolTipRole).toString();
    }
    addItems(model, model.index(row, 0, parent), texts);
  }
}

void addTexts(const QWidget& widget, QStringList& texts) {
  texts << widget.windowTitle() << widget.toolTip() << widget.statusTip() << widget.accessibleName();
  for (const QAction* action : widget.actions()) texts << action->text() << action->toolTip() << action->statusTip();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts += label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) texts += button->text();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) texts += line->placeholderText();
  if (const auto* browser = qobject_cast<const QTextBrowser*>(&widget)) texts += browser->toPlainText();
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) addItems(*combo->model(), {}, texts);
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
    for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i) << tabs->tabToolTip(i);
  }
  const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
  if (view != nullptr && view->model() != nullptr) {
    addItems(*view->model(), {}, texts);
    for (int i = 0; i < view->model()->columnCount(); ++i) {
      texts += view->model()->headerData(i, Qt::Horizontal).toString();
    }
  }
}

}  // namespace

std::vector<Message> messagesOf(const QString& language) {
  QFile file(QString(BOXPROBE_SOURCE_DIR) + "/app/gui/translations/boxprobe_" + language + ".ts");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message")) messages.push_back({context, {}, {}, false});
    if (xml.name() == QLatin1String("source")) messages.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      messages.back().finished = !xml.attributes().hasAttribute("type");
      messages.back().translation = xml.readElementText();
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

EnglishWords::EnglishWords(const QString& language, const QStringList& names) {
  const std::vector<Message> messages = messagesOf(language);
  for (const Message& each : messages) words_.merge(wordsOf(each.source));
  for (const Message& each : messages) {
    for (const QString& word : wordsOf(each.translation)) words_.erase(word);
  }
  for (const QString& name : names) words_.erase(name.toLower());
}

std::string EnglishWords::in(const QString& text) const {
  QStringList found;
  for (const QString& word : wordsOf(text)) {
    if (words_.count(word) > 0) found += word;
  }
  return found.isEmpty() ? std::string() : ("\"" + found.join("\", \"") + "\" of: " + text).toStdString();
}

QStringList shownTexts(const QWidget& widget) {
  QStringList all;
  addTexts(widget, all);
  for (const QWidget* each : widget.findChildren<QWidget*>()) addTexts(*each, all);
  QStringList texts;
  for (const QString& text : all) {
    const QString words = Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
    if (!words.isEmpty() && !texts.contains(words)) texts += words;
  }
  return texts;
}

}  // namespace boxprobe
