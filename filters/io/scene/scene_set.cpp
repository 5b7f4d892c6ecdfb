// Assignments of the command line. They are applied to the JSON form of the scene, so that keys, types and ranges are
// those of the scene file and there is one parser.
#include <algorithm>
#include <vector>

#include "filters/core/base/nearest_name.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/io/scene/scene_file.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

/// "a.b[1].c" as {"a", "b", "[1]", "c"}; a number between dots is an index if it meets an array.
std::vector<std::string> splitKeys(const std::string& text, std::size_t start) {
  std::vector<std::string> keys;
  std::string key;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (text[i] == '.' || text[i] == '[') {
      if (!key.empty()) keys.push_back(key);
      key.clear();
      if (text[i] == '[') key = "[";
    } else {
      key += text[i];
    }
  }
  if (!key.empty()) keys.push_back(key);
  return keys;
}

std::vector<std::string> knownNames(const Json& list) {
  std::vector<std::string> names;
  if (list.is_object()) {
    for (const auto& item : list.items()) names.push_back(item.key());
  } else {
    for (const Json& entry : list) names.push_back(entry["name"].get<std::string>());
  }
  return names;
}

/// NAME of "probes.NAME.field...".
struct NamePart {
  std::string name;
  std::size_t rest = 0;  ///< where the field begins
  bool quoted = false;
};

/// The position after the closing quote of the text that begins at `start`. A backslash escapes the next character.
std::size_t endOfQuotes(const std::string& path, std::size_t start) {
  for (std::size_t i = start + 1; i < path.size(); ++i) {
    if (path[i] == '"') return i + 1;
    if (path[i] == '\\') ++i;
  }
  return std::string::npos;
}

/// A quoted NAME is a JSON string and may contain anything. An unquoted one may have dots and brackets if it exists:
/// the longest existing name wins; otherwise it ends at the first dot.
NamePart splitName(const std::string& path, std::size_t start, const std::vector<std::string>& names) {
  if (start < path.size() && path[start] == '"') {
    const std::size_t end = endOfQuotes(path, start);
    const std::string text = end == std::string::npos ? std::string() : path.substr(start, end - start);
    if (!Json::accept(text) || (end < path.size() && path[end] != '.')) {
      throw FieldError({}, "the name in quotes does not end; write GROUP.\"NAME\".FIELD=VALUE");
    }
    return {Json::parse(text).get<std::string>(), std::min(path.size(), end + 1), true};
  }
  std::string best;
  for (const std::string& name : names) {
    const std::size_t end = start + name.size();
    const bool fits = path.compare(start, name.size(), name) == 0 && (end == path.size() || path[end] == '.');
    if (fits && name.size() > best.size()) best = name;
  }
  if (best.empty()) best = path.substr(start, path.find('.', start) - start);
  return {best, std::min(path.size(), start + best.size() + 1), false};
}

/// The "=" that ends the keys, outside quotes.
std::size_t findEquals(const std::string& assignment) {
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    if (assignment[i] == '=') return i;
    if (assignment[i] != '"') continue;
    const std::size_t end = endOfQuotes(assignment, i);
    if (end == std::string::npos) break;
    i = end - 1;
  }
  return assignment.find('=');
}

bool isIndex(const std::string& key) {
  return !key.empty() && key.size() <= 9 &&
         std::all_of(key.begin(), key.end(), [](unsigned char c) { return c >= '0' && c <= '9'; });
}

/// The value at `key`, created where the file's grammar lets a key be absent.
Json& descend(Json& value, const std::string& key, KeyPath& path) {
  const bool bracketed = key.size() > 2 && key.front() == '[' && key.back() == ']';
  const std::string digits = bracketed ? key.substr(1, key.size() - 2) : key;
  if (value.is_array() && isIndex(digits)) {
    path.push_back("[" + digits + "]");
    const std::size_t index = std::stoul(digits);
    if (index >= value.size()) {
      throw FieldError(path, "there are " + std::to_string(value.size()) + " elements, counted from 0");
    }
    return value[index];
  }
  if (value.is_null() && bracketed) return value;  // an element of a missing array: the parser reports it
  path.push_back(key);
  if (bracketed || !(value.is_object() || value.is_null())) {
    throw FieldError(path, value.is_array() ? "is not an element; use an index such as [0]"
                                            : "has nothing below it; end the key before it");
  }
  return value[key];  // the parser refuses keys that do not belong here
}

Json parseValue(const std::string& text, const std::string& name) {
  if (Json::accept(text)) return parseJsonText(text, name).root;
  const char first = text.empty() ? '\0' : text.front();
  const bool meantAsJson =
      first == '[' || first == '{' || first == '"' || first == '-' || isIndex(std::string(1, first));
  if (meantAsJson) return parseJsonText(text, name).root;  // throws with the parser's message
  return text;
}

/// The sky is one of three kinds: assigning to a key of another kind changes the kind.
void chooseSkyKind(Json& root, const std::string& key) {
  Json& sky = root["sky"];
  const auto isOf = [&key](const auto& rows) { return findField(rows, key) != nullptr; };
  if (sky.contains(key) || isOf(anySkyFields())) return;
  if (!isOf(skyImageFields()) && !isOf(skyColorFields()) && !isOf(skyGradientFields())) return;
  // A gradient starts from the default one; an image and a colour start empty.
  Json chosen = Json::object();
  if (isOf(skyGradientFields())) chosen = sceneToJson(Scene(), "", JsonForm::Complete)["sky"];
  for (const FieldRow<Scene>& row : anySkyFields()) {
    const std::string kept(row.key);
    if (sky.contains(kept)) chosen[kept] = sky[kept];
  }
  sky = std::move(chosen);
}

/// Appends a default probe or camera of that name.
void addNamed(Json& entries, const std::string& group, const std::string& name) {
  Scene scene;
  scene.probes.emplace_back().name = name;
  scene.cameras.emplace_back().name = name;
  const Json added = sceneToJson(scene, "", JsonForm::Complete)[group];
  if (group == "probes") {
    entries.push_back(added[0]);
  } else {
    entries[name] = added[name];
  }
}

/// Finds the value to replace, starting at the root. Fills `path` for messages.
Json& locate(Json& root, const std::string& keys, KeyPath& path) {
  const std::size_t dot = keys.find('.');
  const std::string group = keys.substr(0, dot);
  const bool named =
      group == "probes" || group == "cameras" || group == "materials" || group == "objects" || group == "mirrors";
  if (!named || dot == std::string::npos) {
    const std::vector<std::string> list = splitKeys(keys, 0);
    if (list.empty()) throw FieldError({}, "names no key; write KEY=VALUE");
    if (list[0] == "model") root.erase("models");
    if (list[0] == "sky" && list.size() > 1) chooseSkyKind(root, list[1]);
    Json* value = &root;
    for (const std::string& key : list) value = &descend(*value, key, path);
    return *value;
  }
  Json& entries = root[group];
  const std::vector<std::string> names = knownNames(entries);
  const auto [name, rest, quoted] = splitName(keys, dot + 1, names);
  path = {group, name};
  const auto found = std::find(names.begin(), names.end(), name);
  if ((group == "probes" || group == "cameras") && found == names.end()) {
    const std::string thing = group.substr(0, group.size() - 1);
    // A mistyped name must not create a new entry.
    if (!quoted) {
      throw FieldError(path, "there is no such " + thing + "; the scene has " + nameList(names) + "; to add one, put " +
                                 "its name in quotes: " + group + ".\"" + name + "\"");
    }
    addNamed(entries, group, name);
  }
  Json* value = entries.is_array() ? &entries[static_cast<std::size_t>(found - names.begin())] : &entries[name];
  const std::vector<std::string> fields = splitKeys(keys, rest);
  if (value->is_null()) *value = Json::object();
  if (group == "probes" && !fields.empty() && fields[0] == "influence" && !value->contains("influence")) {
    (*value)["influence"] = (*value)["box"];  // its meaning while left out
  }
  for (const std::string& key : fields) value = &descend(*value, key, path);
  return *value;
}

}  // namespace

void setSceneFields(Scene& scene, const std::vector<std::string>& assignments) {
  Scene result = scene;
  std::string name;
  try {
    for (const std::string& assignment : assignments) {
      name = "--set " + assignment;
      const std::size_t equals = findEquals(assignment);
      if (equals == std::string::npos || equals == 0)
        throw InputError(name + ": is not an assignment; write KEY=VALUE");
      Json value = parseValue(assignment.substr(equals + 1), name);
      Json root = sceneToJson(result, "", JsonForm::Complete);
      KeyPath path;
      locate(root, assignment.substr(0, equals), path) = std::move(value);
      result = sceneFromJson(root, "");
    }
    // Only at the end: a box may be invalid between the assignments to its two ends.
    if (assignments.size() > 1) name = "--set";
    validate(result);
  } catch (const FieldError& error) {
    throw InputError(name + ": " + error.what());
  }
  scene = std::move(result);
}

std::optional<double> sceneNumber(const Scene& scene, const std::string& keys) {
  Json root = sceneToJson(scene, "", JsonForm::Complete);
  try {
    KeyPath path;
    const Json& value = locate(root, keys, path);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
  } catch (const FieldError&) {
    return std::nullopt;
  }
}

}  // namespace boxprobe
