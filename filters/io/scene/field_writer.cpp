// Writes one field's value as JSON by its type.
#include <cmath>
#include <filesystem>

#include "filters/core/base/number_text.h"
#include "filters/core/base/read_number.h"
#include "filters/core/scene/bounces.h"
#include "filters/io/scene/field_json.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// Relative to the scene's folder, so that both can be moved together; absolute if they share only the root.
std::string writtenPath(const std::string& file, const std::string& folder) {
  if (folder.empty() || file.empty()) return file;
  fs::path path(file), base(folder);
  std::error_code error;
  if (path.is_absolute() != base.is_absolute()) {
    path = fs::absolute(path, error);
    base = fs::absolute(base, error);
  }
  path = path.lexically_normal();
  base = base.lexically_normal();
  if (path.is_absolute()) {
    const auto first = [](const fs::path& p) {
      return p.relative_path().empty() ? fs::path() : *p.relative_path().begin();
    };
    if (first(path) != first(base)) return path.string();
  }
  const fs::path relative = path.lexically_relative(base);
  return relative.empty() ? path.string() : relative.generic_string();
}

/// The double with the float's shortest text: 0.3f is written 0.3, not 0.30000001192092896.
double widened(float value) {
  const std::string text = numberText(value);
  double shortest = value;
  readNumber(text.data(), text.data() + text.size(), shortest);
  return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}
double widened(double value) {
  return value;
}

Json toJson(double value) {
  // Integral values without ".0", as people write them; -0 and values beyond 64-bit integers stay unchanged.
  constexpr double kLargestWhole = 1e15;
  if (std::fabs(value) < kLargestWhole && !(value == 0.0 && std::signbit(value))) {
    const auto whole = static_cast<long long>(value);
    if (static_cast<double>(whole) == value) return whole;
  }
  return value;
}
Json toJson(float value) {
  return toJson(widened(value));
}

template <typename Vector>
Json vector(const Vector& v) {
  return Json::array({toJson(widened(v.x)), toJson(widened(v.y)), toJson(widened(v.z))});
}

Json toJson(bool value) {
  return value;
}
Json toJson(const std::string& value) {
  return value;
}
Json toJson(const glm::dvec2& value) {
  return Json::array({toJson(value.x), toJson(value.y)});
}
Json toJson(const glm::dvec3& value) {
  return vector(value);
}
Json toJson(const glm::vec3& value) {
  return vector(value);
}
Json toJson(const std::vector<std::string>& list) {
  Json json = Json::array();
  for (const std::string& text : list) json.push_back(text);
  return json;
}
Json toJson(const std::map<std::string, ParameterValue>& parameters) {
  Json json = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&json, &key = name](const auto& v) { json[key] = toJson(v); }, value);
  }
  return json;
}

Json clearJson(const Clear& clear) {
  if (std::holds_alternative<ClearToSky>(clear)) return "sky";
  if (std::holds_alternative<ClearToNone>(clear)) return "none";
  if (std::holds_alternative<ClearToOpen>(clear)) return "open";
  return vector(std::get<glm::vec3>(clear));
}

/// The shorter forms of fields with several numbers.
struct ToJson {
  const FieldInfo& field;
  const Writing& how;

  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(int value) const {
    const bool word = field.kind == FieldKind::Integer && !field.choices.empty() && value == kAllBounces;
    if (word) return std::string(field.choices.front().id);
    if (field.kind != FieldKind::Choice) return value;
    return std::string(field.choices.at(static_cast<std::size_t>(value)).id);
  }
  Json operator()(const std::string& text) const {
    return field.kind == FieldKind::File ? writtenPath(text, how.folder) : text;
  }
  Json operator()(const BlendDistance& blend) const {
    const bool one = blend.min == blend.max && blend.min.x == blend.min.y && blend.min.x == blend.min.z;
    if (one && how.form == JsonForm::Minimal) return toJson(blend.min.x);
    return writtenPart(blendDistanceFields(), blend, how);
  }
  Json operator()(const Bevel& bevel) const {
    if (bevel.fromRoughness == 0.0 && how.form == JsonForm::Minimal) return toJson(bevel.radius);
    return writtenPart(bevelFields(), bevel, how);
  }
  Json operator()(const ProbeLattice& lattice) const {
    return lattice.used ? writtenPart(latticeFields(), lattice, how) : Json(false);
  }
  Json operator()(const BoxOcclusion& occlusion) const { return writtenPart(occlusionFields(), occlusion, how); }
  Json operator()(const Box& box) const { return writtenPart(boxFields(), box, how); }
  Json operator()(const Clear& clear) const { return clearJson(clear); }
  template <typename Value>
  Json operator()(const Value& value) const {
    return toJson(value);
  }
};

}  // namespace

Json valueJson(const FieldValue& value, const FieldInfo& field, const Writing& how) {
  return std::visit(ToJson{field, how}, value);
}

}  // namespace boxprobe
