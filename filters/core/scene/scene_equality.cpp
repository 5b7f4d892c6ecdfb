// Equality of scenes, field by field, for undo, "modified" and round trips of files. The fields are those of the
// tables; a camera's name is its key, and is in no table.
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

bool ModelFile::operator==(const ModelFile& o) const {
  return sameFields(modelFields(), *this, o);
}

bool SkyColor::operator==(const SkyColor& o) const {
  return sameFields(skyColorFields(), *this, o);
}

bool SkyGradient::operator==(const SkyGradient& o) const {
  return sameFields(skyGradientFields(), *this, o);
}

bool SkyImage::operator==(const SkyImage& o) const {
  return sameFields(skyImageFields(), *this, o);
}

bool Camera::operator==(const Camera& o) const {
  return name == o.name && sameFields(cameraFields(), *this, o);
}

bool Light::operator==(const Light& o) const {
  return sameFields(lightFields(), *this, o);
}

bool MaterialOverride::operator==(const MaterialOverride& o) const {
  return sameFields(materialFields(), *this, o);
}

bool ObjectOverride::operator==(const ObjectOverride& o) const {
  return sameFields(objectFields(), *this, o);
}

bool PlanarMirror::operator==(const PlanarMirror& o) const {
  return sameFields(mirrorFields(), *this, o);
}

bool Box::operator==(const Box& o) const {
  return sameFields(boxFields(), *this, o);
}

bool BlendDistance::operator==(const BlendDistance& o) const {
  return sameFields(blendDistanceFields(), *this, o);
}

bool ProbeLattice::operator==(const ProbeLattice& o) const {
  return used == o.used && (!used || sameFields(latticeFields(), *this, o));
}

bool Bevel::operator==(const Bevel& o) const {
  return sameFields(bevelFields(), *this, o);
}

bool BoxOcclusion::operator==(const BoxOcclusion& o) const {
  return sameFields(occlusionFields(), *this, o);
}

bool Probe::operator==(const Probe& o) const {
  return sameFields(probeFields(), *this, o);
}

bool Scene::operator==(const Scene& o) const {
  return sameFields(sceneFields(), *this, o) && sameFields(anySkyFields(), *this, o);
}

}  // namespace boxprobe
