// Models of formats that have no materials of their own: one mesh, a light grey, colours of vertices, a picture.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/mesh/polygon_mesh.h"

namespace boxprobe {

class MeshModel {
 public:
  explicit MeshModel(const std::string& path) : path_(path) {}

  Model& model() { return model_; }
  /// Reads the picture of the next part, beside the file. One that is missing or cannot be read is named; its part is
  /// grey.
  void addPicture(const std::string& name);
  /// Adds `parts` meshes, the first of them with the pictures added before. With colours of vertices the base colour is
  /// white, because colours multiply it; `transparent`: their alpha is coverage. Throws InputError if there are no
  /// triangles.
  void add(const Polygons& polygons, std::size_t parts, bool transparent);
  Model take() { return std::move(model_); }

 private:
  const std::string& path_;
  Model model_;
  std::vector<std::shared_ptr<const ImageRgba8>> pictures_;
};

/// One line, however long the list.
std::string leftOutWarning(const std::string& what, const std::string& list);

}  // namespace boxprobe
