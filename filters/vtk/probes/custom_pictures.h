// The pictures of custom probes, read once per file name. If one cannot be read, the previous one stays.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/io/cube/cube_file.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class CustomPictures {
 public:
  /// Reads missing pictures.
  void update(const Scene& scene);
  /// Reads it again at the next update, because the file may have changed.
  void forget(const std::string& probeName) { pictures_.erase(probeName); }

  /// Null if none has been read.
  std::shared_ptr<const CubeMap> picture(const std::string& probeName) const;
  /// Fingerprint of the picture and its filter settings; empty without a picture.
  std::string key(const Probe& probe) const;
  /// One line with the scene's key and the file; empty if every picture was read.
  const std::string& error() const { return error_; }
  /// Texels that had to be corrected, one line per affected picture.
  std::vector<std::string> remarks() const;

 private:
  struct Picture {
    std::string file;
    CubeLayout layout = CubeLayout::Automatic;
    PictureCode code;
    CubeView view = CubeView::Outside;
    double rotationDegrees = 0.0;
    std::shared_ptr<const CubeMap> cube;
    std::string error;
    PictureRepairs repairs;
    std::string key;
    FilterKind keyFilter = FilterKind::Ggx;  ///< the filter that `key` includes
    int keySamples = 0;                      ///< likewise

    bool isOf(const Probe& probe) const {
      return file == probe.image && layout == probe.imageLayout && view == probe.cubeView &&
             rotationDegrees == probe.imageRotationDegrees && code == PictureCode{probe.encoding, probe.decode};
    }
  };
  mutable std::map<std::string, Picture> pictures_;  ///< by probe
  std::string error_;
};

}  // namespace boxprobe
