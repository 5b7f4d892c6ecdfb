// Checks single fields against their rows, and the order of a box's corners; words both kinds of error.
#include <cmath>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/bounces.h"
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

namespace {

constexpr const char* kAxes[3] = {"x", "y", "z"};

bool outside(const FieldInfo& field, double value) {
  const FieldRange& r = field.range;
  if (!field.values.empty()) {
    bool known = false;
    for (const int each : field.values) known = known || value == each;
    return !known;
  }
  return value < r.lowest || value > r.highest || (r.aboveLowest && value == r.lowest) ||
         (r.belowHighest && value == r.highest);
}

std::string tooLarge() {
  return "; numbers up to " + numberText(limits::kNumber) + " are supported";
}

/// The checks of one field; the path text is built only if one fails.
class Check {
 public:
  Check(const FieldInfo& field, const KeyPath& path) : field_(field), path_(path) {}

  void operator()(std::monostate) const {}
  void operator()(bool) const {}
  void operator()(const std::vector<std::string>&) const {}
  void operator()(const std::map<std::string, ParameterValue>&) const {}
  void operator()(int value) const {
    const bool word = field_.kind == FieldKind::Integer && !field_.choices.empty() && value == kAllBounces;
    if (field_.kind != FieldKind::Choice && !word) number(value);
  }
  void operator()(float value) const { number(value); }
  void operator()(double value) const { number(value); }
  void operator()(const std::string& value) const {
    if (value.empty() && !field_.ifEmpty.empty()) fail("is empty; " + std::string(field_.ifEmpty));
  }
  void operator()(const glm::vec3& color) const {
    if (field_.range.highest < limits::kNumber) return eachNumber(color);
    finite(color);
    for (int i = 0; i < 3; ++i) {
      if (color[i] < 0.0f) fail("has a negative component, " + numberText(color[i]) + "; use 0 or more");
      if (color[i] > static_cast<float>(limits::kNumber)) {
        fail("has a component of " + numberText(color[i]) + "; use " + numberText(limits::kNumber) + " or less");
      }
    }
  }
  void operator()(const glm::dvec3& value) const {
    if (field_.range.lowest == 0.0) return eachNumber(value);
    finite(value);
    for (int i = 0; i < 3; ++i) {
      if (outside(field_, value[i])) fail(std::string(kAxes[i]) + " is " + numberText(value[i]) + tooLarge());
    }
    if (field_.kind == FieldKind::Direction && value == glm::dvec3(0.0)) {
      fail("is [0, 0, 0] and points nowhere; give it a length");
    }
  }
  void operator()(const glm::dvec2& decode) const {
    FieldInfo element;
    element.key = "[0]";
    element.range = {0.0, limits::kNumber, true, false};
    const KeyPath path = below();
    Check(element, path)(decode.x);
    element.key = "[1]";
    element.range.aboveLowest = false;
    Check(element, path)(decode.y);
  }
  void operator()(const Box& box) const {
    checkFields(boxFields(), box, below());
    for (int i = 0; i < 3; ++i) {
      if (box.min[i] > box.max[i]) {
        fail(std::string("min.") + kAxes[i] + " " + numberText(box.min[i]) + " is greater than max." + kAxes[i] + " " +
             numberText(box.max[i]) + "; swap them");
      }
    }
  }
  void operator()(const BlendDistance& blend) const { checkFields(blendDistanceFields(), blend, below()); }
  void operator()(const Bevel& bevel) const { checkFields(bevelFields(), bevel, below()); }
  void operator()(const BoxOcclusion& occlusion) const { checkFields(occlusionFields(), occlusion, below()); }
  void operator()(const ProbeLattice& lattice) const { checkFields(latticeFields(), lattice, below()); }
  void operator()(const Clear& clear) const {
    if (const auto* color = std::get_if<glm::vec3>(&clear)) (*this)(*color);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FieldError(below(), reason); }
  KeyPath below() const {
    KeyPath path = path_;
    path.emplace_back(field_.key);
    return path;
  }
  template <typename Number>
  void number(Number value) const {
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value)) fail("is not a finite number");
    }
    if (!outside(field_, static_cast<double>(value))) return;
    std::string text;
    if constexpr (std::is_floating_point_v<Number>) {
      text = numberText(value);
    } else {
      text = std::to_string(value);
    }
    const bool huge = std::fabs(static_cast<double>(value)) > limits::kNumber;
    const bool onlyHuge = huge && (value > 0 || field_.range.lowest < 0.0) && field_.range.highest >= limits::kNumber;
    fail("is " + text + (onlyHuge ? tooLarge() : " and must be " + rangeText(field_)) + wordText());
  }
  // A whole number may have a word beside it.
  std::string wordText() const {
    const bool has = field_.kind == FieldKind::Integer && !field_.choices.empty();
    return has ? ", or \"" + std::string(field_.choices.front().id) + "\"" : std::string();
  }
  template <typename Vector>
  void eachNumber(const Vector& value) const {
    for (int i = 0; i < 3; ++i) number(value[i]);
  }
  template <typename Vector>
  void finite(const Vector& value) const {
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(value[i])) fail(std::string(kAxes[i]) + " is not a finite number");
    }
  }

  const FieldInfo& field_;
  const KeyPath& path_;
};

}  // namespace

FieldRange formRange(const FieldInfo& field) {
  return field.usual.value_or(field.range);
}

std::string rangeText(const FieldInfo& field) {
  const FieldRange& r = field.range;
  const std::string lowest = numberText(r.lowest), highest = numberText(r.highest);
  if (field.powerOfTwo) return "a power of two from " + lowest + " to " + highest;
  if (!field.values.empty()) {
    std::string list;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      const bool last = i + 1 == field.values.size();
      list += (i == 0 ? "" : last ? " or " : ", ") + std::to_string(field.values[i]);
    }
    return list;
  }
  const bool low = r.lowest > -limits::kNumber, high = r.highest < limits::kNumber;
  if (low && high && !r.aboveLowest && !r.belowHighest) return "from " + lowest + " to " + highest;
  std::string text;
  if (low) text = r.aboveLowest ? "greater than " + lowest : lowest + " or more";
  if (high) text += (text.empty() ? "" : " and ") + (r.belowHighest ? "less than " + highest : highest + " or less");
  return text;
}

void checkField(const FieldInfo& field, const FieldValue& value, const KeyPath& path) {
  std::visit(Check(field, path), value);
}

}  // namespace boxprobe
