#include "filters/vtk/draw/resting_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace boxprobe {

namespace {

bool foldable(const RestingValue& value) {
  return !value.values.empty() &&
         std::all_of(value.values.begin(), value.values.end(), [](float v) { return std::isfinite(v); });
}

// The shortest text that is read back as the same float, and that GLSL takes for one.
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

std::string constant(const std::string& type, const RestingValue& value, bool array) {
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
bool foldOne(std::string& text, const RestingValue& value) {
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

}  // namespace

// What is no number stays a uniform, and so no part of any plan.
void RestingValues::add(std::string name, int components, const float* values, std::size_t count) {
  RestingValue value{std::move(name), components, {values, values + count * static_cast<std::size_t>(components)}};
  if (foldable(value)) all_.push_back(std::move(value));
}

const RestingValue* RestingValues::find(const std::string& name) const {
  const auto at = std::find_if(all_.begin(), all_.end(), [&](const RestingValue& v) { return v.name == name; });
  return at == all_.end() ? nullptr : &*at;
}

bool RestingValues::hold(const RestingValues& others) const {
  return std::all_of(others.all_.begin(), others.all_.end(), [this](const RestingValue& other) {
    const RestingValue* own = find(other.name);
    return own != nullptr && *own == other;
  });
}

RestingValues RestingValues::sharedWith(const RestingValues& other) const {
  RestingValues both;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(both.all_), [&](const RestingValue& own) {
    const RestingValue* theirs = other.find(own.name);
    return theirs != nullptr && *theirs == own;
  });
  return both;
}

std::string RestingValues::key() const {
  std::string text;
  for (const RestingValue& value : all_) {
    text += value.name;
    text.append(reinterpret_cast<const char*>(value.values.data()), value.values.size() * sizeof(float));
  }
  return text;
}

int RestingValues::worth() const {
  int sum = 0;
  for (const RestingValue& value : all_) {
    const bool much = value.name == "bpSh" || value.name == "bpSkySh" || value.name == "roughnessUniform";
    sum += much ? 4 : 1;
  }
  return sum;
}

int foldConstants(std::string& text, const RestingValues& values) {
  return static_cast<int>(std::count_if(values.all().begin(), values.all().end(), [&text](const RestingValue& value) {
    return foldable(value) && foldOne(text, value);
  }));
}

}  // namespace boxprobe
