// See typed_number.h.
#include "app/gui/widgets/typed_number.h"

#include <QCoreApplication>
#include <QLocale>

namespace boxprobe {

namespace {

const QChar kArabicMark(0x066B);

bool isMark(QChar c) {
  return c == '.' || c == ',' || c == kArabicMark;
}

}  // namespace

TypedNumber typedNumber(const QString& text) {
  const QString typed = text.trimmed();
  TypedNumber result;
  QString plain;
  ushort zero = 0;  // of the script whose digits are used
  int marks = 0, digits = 0;
  QChar mark;
  bool mixed = false;
  for (int i = 0; i < typed.size(); ++i) {
    const QChar c = typed[i];
    if (i == 0 && (c == '-' || c == '+' || c == QChar(0x2212))) {
      plain += c == '+' ? '+' : '-';
    } else if (c.digitValue() >= 0 && c.isDigit()) {
      const auto own = static_cast<ushort>(c.unicode() - c.digitValue());
      if (zero != 0 && own != zero) mixed = true;
      zero = own;
      ++digits;
      plain += QChar('0' + c.digitValue());
    } else if (isMark(c)) {
      if (marks > 0 && c != mark) mixed = true;
      mark = c;
      ++marks;
      plain += '.';
    } else {
      result.why = QCoreApplication::translate("TypedNumber", "\"%1\" is not a number").arg(typed);
      return result;
    }
  }
  if (marks > 1) {
    result.why =
        QCoreApplication::translate(
            "TypedNumber", "\"%1\" has more than one separator: type one decimal mark and no separator of thousands")
            .arg(typed);
  } else if (mixed) {
    result.why = QCoreApplication::translate("TypedNumber", "\"%1\" mixes digits of two scripts").arg(typed);
  } else if (digits == 0) {
    result.unfinished = true;
    result.why = typed.isEmpty() ? QCoreApplication::translate("TypedNumber", "A number is missing")
                                 : QCoreApplication::translate("TypedNumber", "\"%1\" is not a number").arg(typed);
  } else {
    result.value = QLocale::c().toDouble(plain);
  }
  return result;
}

QString shownNumber(double value, int decimals) {
  QLocale plain = QLocale::c();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  return plain.toString(value, 'f', decimals);
}

}  // namespace boxprobe
