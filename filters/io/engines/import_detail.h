// Shared by the readers of engines' scene files. Internal to this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/core/base/read_number.h"
#include "filters/core/scene/scene.h"
#include "filters/io/engines/probe_import.h"

namespace boxprobe {

/// The placement of a node, and of its children in it.
struct NodePlacement {
  glm::dmat3 axes{1.0};  ///< columns, with their scale
  glm::dvec3 position{0.0};
  NodePlacement within(const NodePlacement& parent) const {
    return {parent.axes * axes, parent.axes * position + parent.position};
  }
};

/// The number at the beginning of a text, spaces skipped; nothing if there is none or it is infinite.
inline std::optional<double> leadingNumber(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t");
  if (at == std::string_view::npos) return {};
  double value = 0.0;
  const auto result = readNumber(text.data() + at, text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value)) return {};
  return value;
}

/// What a probe may have and is not carried over, with the value that means nothing is lost, and why.
struct LeftOutField {
  const char *key, *standard, *why;
};

/// What `written`, a field as the file has it, loses by being left out; nothing if its value is the standard one.
template <std::size_t N>
std::optional<std::string> leftOut(const LeftOutField (&fields)[N], const std::string& place, const std::string& key,
                                   const std::string& value, const std::string& written) {
  const auto* row = std::find_if(std::begin(fields), std::end(fields),
                                 [&key](const LeftOutField& known) { return key == known.key; });
  const bool known = row != std::end(fields);
  if (known && value == row->standard) return std::nullopt;
  return printable(oneLine(place + written + " is left out: " + (known ? row->why : "this program does not know it")));
}

/// An unused name made of characters that a scene file allows: probe names are unique here, but not in engines.
inline std::string uniqueName(ProbeNames& names, const std::string& wanted) {
  return names.take(wanted.empty() ? "probe" : printable(oneLine(wanted)));
}

/// A scene has no more.
inline void checkProbeCount(const std::string& file, std::size_t probes) {
  if (probes <= limits::kEntries) return;
  throw InputError(file + ": has more than " + std::to_string(limits::kEntries) +
                   " reflection probes, the most that are read; leave some out");
}

}  // namespace boxprobe
