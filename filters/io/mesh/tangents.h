// Tangents of meshes whose materials need them.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// The set of texture coordinates for tangents, which normal maps and anisotropy need; -1: none needed, or the mesh has
/// no coordinates.
int tangentSet(const Mesh& mesh, const Material& material);

/// Computes tangents, for which the mesh needs normals and the coordinates of that set. Splits vertices where the
/// texture's handedness changes.
void addTangents(Mesh& mesh, int uvSet);

}  // namespace boxprobe
