// What any reader of glTF can be shown of a scene, written into its model: placement, changed materials, cameras and
// lights. Internal to this folder.
#pragma once

#include <set>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/gltf/glb_document.h"

namespace boxprobe {

template <typename Vector>
Json glbNumbers(const Vector& v) {
  Json array = Json::array();
  for (int i = 0; i < v.length(); ++i) array.push_back(static_cast<double>(v[i]));
  return array;
}

inline Json glbMatrix(const glm::dmat4& m) {
  Json array = Json::array();
  for (int i = 0; i < 16; ++i) array.push_back(m[i / 4][i % 4]);
  return array;
}

/// `document`: of the scene's one model file, `model` as it was read. `countedLights`: of the scene's lights, those
/// which a lamp stands for and which therefore are left out. Axes and lengths become glTF's: +Y up, metres. Returns
/// the materials that were changed as they had been, by their numbers in the file.
Json writeSceneInto(GlbDocument& document, const Scene& scene, const Model& model,
                    const std::set<std::size_t>& countedLights);

}  // namespace boxprobe
