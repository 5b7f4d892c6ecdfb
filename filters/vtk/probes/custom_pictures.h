// The pictures of custom probes, read once and again when another is named. One that cannot be read leaves the one
// before in its place. Called by the probe set; needs no GL.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/io/cube/picture_code.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class CustomPictures {
 public:
  /// Reads what is not there yet.
  void update(const Scene& scene);
  /// Reads it again at the next update: the file may have changed.
  void forget(const std::string& probeName) { pictures_.erase(probeName); }

  /// Null: none could be read so far.
  std::shared_ptr<const CubeMap> picture(const std::string& probeName) const;
  /// Fingerprint of the picture with how it is filtered; empty without one.
  std::string key(const Probe& probe) const;
  /// One line that names the scene's key and the file; empty while every picture is there.
  const std::string& error() const { return error_; }
  /// What was wrong with texels that were put right, one line for each picture that had some.
  std::vector<std::string> remarks() const;

 private:
  struct Picture {
    std::string file;
    CubeLayout layout = CubeLayout::Automatic;
    PictureCode code;
    std::shared_ptr<const CubeMap> cube;
    std::string error;
    std::size_t notFinite = 0, clamped = 0;  ///< texels
    std::string key;
    FilterKind keyFilter = FilterKind::Ggx;  ///< that `key` is of
    int keySamples = 0;                      ///< likewise

    bool isOf(const Probe& probe) const {
      return file == probe.image && layout == probe.imageLayout && code == PictureCode{probe.encoding, probe.decode};
    }
  };
  mutable std::map<std::string, Picture> pictures_;  ///< by probe
  std::string error_;
};

}  // namespace boxprobe
