#include "filters/explain/explanation_rows.h"

#include <array>
#include <utility>

namespace boxprobe {

std::string boxFaceName(int face) {
  static constexpr std::array<const char*, 6> names = {"-x", "+x", "-y", "+y", "-z", "+z"};
  return face >= 0 && face < 6 ? names[static_cast<std::size_t>(face)] : "none";
}

std::string cubeFaceName(int face) {
  static constexpr std::array<const char*, 6> names = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return face >= 0 && face < 6 ? names[static_cast<std::size_t>(face)] : "none";
}

Phrase numberPhrase(const std::string& number) {
  if (number == "undefined") return Phrase::tr("undefined");
  if (number == "infinite") return Phrase::tr("infinite");
  if (number == "-infinite") return Phrase::tr("-infinite");
  return Phrase::plain(number);
}

namespace explained {

std::string percent(double share) {
  constexpr double kSmallestShown = 5e-4;
  return share > 0.0 && share < kSmallestShown ? "<0.1 %" : fixedText(100.0 * share, 1) + " %";
}

ExplanationRow row(Symbol symbol, std::vector<std::string> values, std::string unit, Phrase meaning) {
  ExplanationRow made;
  made.symbol = std::move(symbol);
  made.numbers = std::move(values);
  made.unit = std::move(unit);
  made.meaning = std::move(meaning);
  return made;
}

ExplanationRow scalar(Symbol symbol, double value, std::string unit, Phrase meaning) {
  return row(std::move(symbol), {fixedText(value)}, std::move(unit), std::move(meaning));
}

ExplanationRow light(Symbol symbol, const glm::vec3& value, Phrase meaning) {
  ExplanationRow made = vector(std::move(symbol), value, "", std::move(meaning));
  made.color = value;
  return made;
}

}  // namespace explained

}  // namespace boxprobe
