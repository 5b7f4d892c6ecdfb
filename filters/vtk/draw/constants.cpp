#include "filters/vtk/draw/constants.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace boxprobe {

namespace {

bool finite(const float* values, std::size_t count) {
  return count > 0 && std::all_of(values, values + count, [](float v) { return std::isfinite(v); });
}

// The shortest text that parses back to the same float and is a float literal in GLSL.
std::string literal(float value) {
  char digits[48];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  std::string text(digits, end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

std::string element(const std::string& type, const float* values, int components) {
  std::string text = components == 1 ? "" : type + "(";
  for (int i = 0; i < components; ++i) text += (i == 0 ? "" : ", ") + literal(values[i]);
  return components == 1 ? text : text + ")";
}

std::string constant(const std::string& type, const Constant& value, bool array) {
  if (!array) return "const " + type + " " + value.name + " = " + element(type, value.values.data(), value.components);
  const std::size_t size = static_cast<std::size_t>(value.components), count = value.values.size() / size;
  const std::string of = type + "[" + std::to_string(count) + "]";
  std::string text = "const " + of + " " + value.name + " = " + of + "(";
  for (std::size_t i = 0; i < count; ++i) {
    text += (i == 0 ? "" : ", ") + element(type, value.values.data() + i * size, value.components);
  }
  return text + ")";
}

// Replaces "uniform TYPE NAME;" or "uniform TYPE NAME[...];".
bool writeOne(std::string& text, const Constant& value) {
  static constexpr const char* kTypes[] = {"", "float", "vec2", "vec3", "", "", "", "", "", "mat3"};
  const std::string type = kTypes[value.components];
  const std::string declared = "uniform " + type + " " + value.name;
  for (std::size_t at = text.find(declared); at != std::string::npos; at = text.find(declared, at + 1)) {
    const std::size_t after = at + declared.size();
    const std::size_t end = text.find(';', after);
    if (end == std::string::npos || (text[after] != ';' && text[after] != '[')) continue;
    text.replace(at, end - at, constant(type, value, text[after] == '['));
    return true;
  }
  return false;
}

/// Indices of the uses of one program with identical numbers.
using Alike = std::vector<std::size_t>;
using AlikeGroups = std::vector<Alike>;

Constants sharedValues(const AlikeGroups& kinds, const std::vector<ConstantUse>& uses) {
  std::optional<Constants> values;
  for (const Alike& kind : kinds) {
    const Constants& own = uses[kind.front()].values;
    values = values ? values->sharedWith(own) : own;
  }
  return values.value_or(Constants());
}

struct OwnProgram {
  std::size_t program, kind;
  long gain;
};

}  // namespace

void Constants::read(const char* name, int components, const float* values, std::size_t count) {
  const std::size_t floats = count * static_cast<std::size_t>(components);
  if (finite(values, floats)) all_.push_back({name, components, {values, values + floats}});
}

const Constant* Constants::find(const char* name) const {
  const auto at = std::find_if(all_.begin(), all_.end(), [&](const Constant& v) { return v.name == name; });
  return at == all_.end() ? nullptr : &*at;
}

void ConstantsCheck::read(const char* name, int components, const float* values, std::size_t count) {
  const Constant* constant = constants_.find(name);
  if (constant == nullptr || constant->components != components) return;
  const std::size_t floats = count * static_cast<std::size_t>(components);
  same_ += std::equal(constant->values.begin(), constant->values.end(), values, values + floats) ? 1 : 0;
}

Constants Constants::sharedWith(const Constants& other) const {
  Constants both;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(both.all_), [&](const Constant& own) {
    const Constant* theirs = other.find(own.name.c_str());
    return theirs != nullptr && *theirs == own;
  });
  return both;
}

std::string Constants::key() const {
  std::string text;
  for (const Constant& value : all_) {
    text += value.name;
    text.append(reinterpret_cast<const char*>(value.values.data()), value.values.size() * sizeof(float));
  }
  return text;
}

int Constants::worth() const {
  int sum = 0;
  for (const Constant& value : all_) {
    const bool much = value.name == "bpSh" || value.name == "bpSkySh" || value.name == "roughnessUniform";
    sum += much ? 4 : 1;
  }
  return sum;
}

int writeConstants(std::string& text, const Constants& constants) {
  const auto& all = constants.all();
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&text](const Constant& one) { return writeOne(text, one); }));
}

std::vector<std::shared_ptr<const Constants>> planConstants(const std::vector<ConstantUse>& uses, std::size_t more) {
  std::map<std::string, std::map<std::string, Alike>> found;
  for (std::size_t i = 0; i < uses.size(); ++i) found[uses[i].program][uses[i].values.key()].push_back(i);
  std::vector<AlikeGroups> programs;
  std::vector<OwnProgram> candidates;
  for (const auto& program : found) {
    AlikeGroups kinds;
    for (const auto& kind : program.second) kinds.push_back(kind.second);
    const int worth = sharedValues(kinds, uses).worth();
    for (std::size_t k = 0; k < kinds.size() && kinds.size() > 1; ++k) {
      const auto gain = static_cast<long>(kinds[k].size()) * (uses[kinds[k].front()].values.worth() - worth);
      candidates.push_back({programs.size(), k, gain});
    }
    programs.push_back(std::move(kinds));
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const OwnProgram& a, const OwnProgram& b) { return a.gain > b.gain; });
  std::vector<std::shared_ptr<const Constants>> plans(uses.size());
  const auto give = [&plans](const Alike& kind, const std::shared_ptr<const Constants>& values) {
    for (const std::size_t i : kind) plans[i] = values;
  };
  // The last group of a program is what remains, and needs no program of its own.
  std::vector<std::size_t> left(programs.size());
  for (std::size_t p = 0; p < programs.size(); ++p) left[p] = programs[p].size();
  for (const OwnProgram& candidate : candidates) {
    if (more == 0 || candidate.gain <= 0) break;
    if (left[candidate.program] < 2) continue;
    Alike& kind = programs[candidate.program][candidate.kind];
    give(kind, std::make_shared<Constants>(uses[kind.front()].values));
    kind.clear();
    --left[candidate.program];
    --more;
  }
  for (AlikeGroups& kinds : programs) {
    kinds.erase(std::remove_if(kinds.begin(), kinds.end(), [](const Alike& kind) { return kind.empty(); }),
                kinds.end());
    const auto values = std::make_shared<Constants>(sharedValues(kinds, uses));
    if (values->empty()) continue;
    for (const Alike& kind : kinds) give(kind, values);
  }
  return plans;
}

}  // namespace boxprobe
