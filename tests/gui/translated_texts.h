// What the files of translations hold, what a widget shows, and which words of that are English.
#pragma once

#include <QString>
#include <QStringList>
#include <set>
#include <string>
#include <vector>

class QWidget;

namespace boxprobe {

struct Message {
  QString context, source, translation;
  bool finished = false;
};

std::vector<Message> messagesOf(const QString& language);

/// Words by which a text is known as untranslated: those of English texts that no translation has.
class EnglishWords {
 public:
  /// `names`: words of scenes and files, which stay.
  EnglishWords(const QString& language, const QStringList& names);
  /// Of a text, in quotes, with the text; empty: none.
  std::string in(const QString& text) const;

 private:
  std::set<QString> words_;
};

/// Texts, tool tips and items of a widget and of all within it, with its menus; rich text without its tags.
QStringList shownTexts(const QWidget& widget);

}  // namespace boxprobe
