#include "app/session/environment_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

/// A variable takes one of the words, or a number from `least` to `most`.
struct Variable {
  const char* name;
  std::vector<std::string> words;
  double least = 0.0, most = 0.0;
  bool whole = true;
  const char* meant;
};

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all = {
      {"BOXPROBE_RENDERER_TUNING", {"auto", "cpu", "gpu"}, 0.0, 0.0, true, "auto, cpu or gpu"},
      {"BOXPROBE_ANISOTROPY", {}, 1.0, 16.0, true, "a whole number from 1 to 16"},
      {"BOXPROBE_TEXTURE_UNITS", {}, 1.0, 1e6, true, "a whole number, 1 or more"},
      {"BOXPROBE_TEXTURE_MEMORY", {}, 1e-6, 1e12, false, "a number of megabytes"},
      {"BOXPROBE_PROGRESS", {"lines"}, 0.0, 0.0, true, "lines"}};
  return all;
}

bool meant(const Variable& variable, const std::string& value) {
  if (!variable.words.empty()) {
    return std::find(variable.words.begin(), variable.words.end(), value) != variable.words.end();
  }
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  const bool all = end != value.c_str() && *end == '\0';
  return all && number >= variable.least && number <= variable.most &&
         !(variable.whole && number != std::floor(number));
}

}  // namespace

void requireMeantEnvironment() {
  for (const Variable& variable : variables()) {
    const char* value = std::getenv(variable.name);
    if (value == nullptr || meant(variable, value)) continue;
    throw InputError(std::string("the environment's ") + variable.name + " is \"" + value + "\"; set it to " +
                     variable.meant + ", or unset it");
  }
}

}  // namespace boxprobe
