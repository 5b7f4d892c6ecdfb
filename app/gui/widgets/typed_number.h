// A number as people type it, the same in every locale: one separator, comma or point, is the decimal mark. Called by
// the fields of numbers.
#pragma once

#include <QString>
#include <optional>

namespace boxprobe {

struct TypedNumber {
  std::optional<double> value;
  bool unfinished = false;  ///< more digits would make it a number: "-", "."
  QString why;              ///< of what is no number and cannot become one: one line that says what to do
};

/// `text` without its unit. Digits are those of one script, whatever the locale; spaces around count for nothing.
TypedNumber typedNumber(const QString& text);

/// The same number in every locale: Latin digits, a point, no groups.
QString shownNumber(double value, int decimals);

}  // namespace boxprobe
