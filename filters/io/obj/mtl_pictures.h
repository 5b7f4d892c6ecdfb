// The pictures that MTL materials name, decoded once, and what materials need of them: scalars from one channel, packed
// roughness and metalness, colours with a mask as alpha, normals from heights.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/obj/mtl_file.h"

namespace boxprobe {

/// One value per texel, 0 to 1.
struct ScalarPicture {
  int width = 0, height = 0;
  std::vector<float> values;
};

class MtlPictures {
 public:
  /// Decodes what these materials name, in parallel. A picture that is missing, outside the model's folder or cannot be
  /// decoded is named in `warnings`. `progress` gets the finished fraction; what it throws ends the work.
  MtlPictures(const std::vector<const MtlMaterial*>& materials, const std::string& modelPath,
              std::vector<std::string>& warnings, const std::function<void(double)>& progress);

  /// With -mm applied; null if it cannot be shown.
  std::shared_ptr<const ImageRgba8> color(const MtlMap& map);
  /// The channel of -imfchan; else the alpha of a mask that has one, else the luminance. Empty: cannot be shown.
  ScalarPicture scalar(const MtlMap& map, bool mask = false) const;
  /// The texels of three scalars as red, green and blue, 1 where a picture is empty; not all three may be. `key` tells
  /// equal ones.
  std::shared_ptr<const ImageRgba8> packed(const std::string& key, const ScalarPicture& red, const ScalarPicture& green,
                                           const ScalarPicture& blue);
  /// `color`, or white, with a mask as its alpha.
  std::shared_ptr<const ImageRgba8> masked(const std::string& key, const std::shared_ptr<const ImageRgba8>& color,
                                           const ScalarPicture& mask);
  /// A normal map of a picture that holds one or heights; `strength` is multiplied by what the map has to be scaled by.
  std::shared_ptr<const ImageRgba8> normals(const MtlMap& map, bool mayBeHeights, float& strength);

  /// Tells equal uses of pictures.
  std::string keyOf(const MtlMap& map) const;

 private:
  const ImageRgba8* find(const MtlMap& map) const;

  std::map<std::string, std::shared_ptr<const ImageRgba8>> decoded_;  ///< by keyOfFile
  std::map<std::string, std::shared_ptr<const ImageRgba8>> made_;     ///< by key
  std::map<std::string, float> strengths_;                            ///< of those of heights
};

}  // namespace boxprobe
