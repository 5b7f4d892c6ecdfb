// Every field of the scene file: one table per part, in the order in which keys are written. To add a field, see "Add a
// field" in data/scenes/README.md.
#pragma once

#include <stdexcept>

#include "filters/core/base/field_error.h"
#include "filters/core/scene/field_row.h"

namespace boxprobe {

const std::vector<FieldRow<Scene>>& sceneFields();
const std::vector<FieldRow<ModelFile>>& modelFields();
const std::vector<FieldRow<SkyImage>>& skyImageFields();
const std::vector<FieldRow<SkyColor>>& skyColorFields();
const std::vector<FieldRow<SkyGradient>>& skyGradientFields();
/// The fields of "sky" that all its kinds have.
const std::vector<FieldRow<Scene>>& anySkyFields();
const std::vector<FieldRow<Camera>>& cameraFields();  ///< without its name, which is its key
const std::vector<FieldRow<Light>>& lightFields();
const std::vector<FieldRow<MaterialOverride>>& materialFields();
const std::vector<FieldRow<ObjectOverride>>& objectFields();
const std::vector<FieldRow<PlanarMirror>>& mirrorFields();
const std::vector<FieldRow<Probe>>& probeFields();
const std::vector<FieldRow<Box>>& boxFields();
const std::vector<FieldRow<BlendDistance>>& blendDistanceFields();
const std::vector<FieldRow<Bevel>>& bevelFields();
const std::vector<FieldRow<ProbeLattice>>& latticeFields();
const std::vector<FieldRow<BoxOcclusion>>& occlusionFields();

/// Null if there is none of that key.
template <typename Part>
const FieldRow<Part>* findField(const std::vector<FieldRow<Part>>& rows, std::string_view key) {
  for (const FieldRow<Part>& row : rows) {
    if (row.key == key) return &row;
  }
  return nullptr;
}

/// The row of a key that must exist: throws std::logic_error otherwise.
template <typename Part>
const FieldRow<Part>& fieldNamed(const std::vector<FieldRow<Part>>& rows, std::string_view key) {
  if (const FieldRow<Part>* row = findField(rows, key)) return *row;
  throw std::logic_error("no field " + std::string(key));
}
const FieldRow<Probe>& probeField(std::string_view key);
const FieldRow<Light>& lightField(std::string_view key);
const FieldRow<MaterialOverride>& materialField(std::string_view key);
const FieldRow<ObjectOverride>& objectField(std::string_view key);
const FieldRow<PlanarMirror>& mirrorField(std::string_view key);

/// A table with the type of its struct erased, for lists of all tables.
struct FieldPart {
  std::string_view path;  ///< the part's place: "probes[].box"; "" for the file itself
  std::string_view help;  ///< one sentence
  struct Entry {
    const FieldInfo* field;
    FieldValue standard;  ///< the default
  };
  std::vector<Entry> fields;
  /// For every field that names no kinds of change itself.
  std::vector<bool Changes::*> changes;
};
/// In the order of the file.
std::vector<FieldPart> fieldParts();

/// Throws FieldError at `path` + key if the value is out of the row's range. Does not check relations between fields.
void checkField(const FieldInfo& field, const FieldValue& value, const KeyPath& path);

/// The same for every field of a part.
template <typename Part>
void checkFields(const std::vector<FieldRow<Part>>& rows, const Part& part, const KeyPath& path) {
  for (const FieldRow<Part>& row : rows) {
    if (row.get != nullptr) checkField(row, row.get(part), path);
  }
}

}  // namespace boxprobe
