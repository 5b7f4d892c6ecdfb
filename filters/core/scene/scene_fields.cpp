// Finds rows by key, and lists all parts.
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

namespace {

template <typename Part>
void addTo(FieldPart& part, const std::vector<FieldRow<Part>>& rows) {
  const Part standard;
  for (const FieldRow<Part>& row : rows) {
    part.fields.push_back({&row, row.get != nullptr ? row.get(standard) : FieldValue()});
  }
}

template <typename... Rows>
FieldPart part(std::string_view path, std::string_view help, const FieldInfo& standsIn, const Rows&... rows) {
  FieldPart made;
  made.path = path;
  made.help = help;
  made.changes = standsIn.changes;
  (addTo(made, rows), ...);
  return made;
}

}  // namespace

const FieldRow<Probe>& probeField(std::string_view key) {
  return fieldNamed(probeFields(), key);
}
const FieldRow<Light>& lightField(std::string_view key) {
  return fieldNamed(lightFields(), key);
}
const FieldRow<MaterialOverride>& materialField(std::string_view key) {
  return fieldNamed(materialFields(), key);
}
const FieldRow<ObjectOverride>& objectField(std::string_view key) {
  return fieldNamed(objectFields(), key);
}
const FieldRow<PlanarMirror>& mirrorField(std::string_view key) {
  return fieldNamed(mirrorFields(), key);
}

std::vector<FieldPart> fieldParts() {
  const auto top = [](std::string_view key) -> const FieldInfo& { return fieldNamed(sceneFields(), key); };
  return {
      part("", "The top of the file.", FieldInfo(), sceneFields()),
      part("models[]",
           "Each model, and `model` where it is an object. A file name alone stands for an object with "
           "nothing but `file`.",
           top("models"), modelFields()),
      part("sky", "Either `image`, or `color`, or any of `top`, `horizon` and `ground`.", top("sky"), skyImageFields(),
           skyColorFields(), skyGradientFields(), anySkyFields()),
      part("cameras.NAME", "Each camera.", top("cameras"), cameraFields()),
      part("lights[]", "Each light.", top("lights"), lightFields()),
      part("materials.NAME", "Each material that the scene changes.", top("materials"), materialFields()),
      part("objects.NAME", "Each object that the scene changes.", top("objects"), objectFields()),
      part("mirrors.NAME", "Each planar mirror: a flat surface of the models.", top("mirrors"), mirrorFields()),
      part("probes[]", "Each probe.", top("probes"), probeFields()),
      part("probes[].box",
           "Also of `influence`. Corners in world units along the box's own axes, as if it were not "
           "rotated.",
           probeField("box"), boxFields()),
      part("probes[].blendDistance", "One number stands for all six faces.", probeField("blendDistance"),
           blendDistanceFields()),
      part("probes[].bevel", "A number alone is the radius.", probeField("bevel"), bevelFields()),
      part("probes[].lattice", "`false` in its place: no nodes.", probeField("lattice"), latticeFields()),
      part("probes[].occlusion", "`{}` switches it on with the defaults.", probeField("occlusion"), occlusionFields()),
  };
}

}  // namespace boxprobe
