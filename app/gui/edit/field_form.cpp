// See field_form.h.
#include "app/gui/edit/field_form.h"

#include <QCoreApplication>
#include <cmath>

#include "app/gui/widgets/table_words.h"

namespace boxprobe {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

QString suffix(const FieldInfo& field) {
  const QString unit = text(field.unit);
  return unit.isEmpty() || unit == "°" ? unit : " " + unit;
}

/// "" for what has no short form.
QString defaultText(const FieldInfo& field, const FieldValue& standard) {
  if (field.kind == FieldKind::Choice && std::holds_alternative<int>(standard)) {
    return text(field.choices.at(static_cast<std::size_t>(std::get<int>(standard))).id);
  }
  if (const int* whole = std::get_if<int>(&standard)) return QString::number(*whole) + suffix(field);
  if (const float* number = std::get_if<float>(&standard)) return QString::number(*number) + suffix(field);
  if (const double* number = std::get_if<double>(&standard)) return QString::number(*number) + suffix(field);
  return {};
}

}  // namespace

ValueField::Format fieldFormat(const FieldInfo& field, double step, int decimals) {
  const FieldRange range = formRange(field);
  // An end that is excluded is left by the least number that can be shown.
  const double least = std::pow(10.0, -decimals);
  return {range.lowest + (range.aboveLowest ? least : 0.0), range.highest - (range.belowHighest ? least : 0.0), step,
          decimals, suffix(field)};
}

QString fieldTip(const FieldInfo& field, const FieldValue& standard) {
  const QString help = tableWords(field.help), value = defaultText(field, standard);
  return value.isEmpty() ? help : QCoreApplication::translate("FieldForm", "%1 Default: %2").arg(help, value);
}

QString choiceTip(const FieldInfo& field, int choice) {
  QString help = tableWords(field.choices.at(static_cast<std::size_t>(choice)).help);
  if (!help.isEmpty()) help[0] = help[0].toUpper();
  return help;
}

}  // namespace boxprobe
