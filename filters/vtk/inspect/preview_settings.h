// The contents of the preview sphere, without OpenGL's headers.
#pragma once

#include <string>

namespace boxprobe {

enum class SphereKind {
  Off,
  Chrome,   ///< level 0: the capture itself
  Rough,    ///< a metal with PreviewSphereSettings::roughness
  Diffuse,  ///< a white diffuse surface: the irradiance
};

struct PreviewSphereSettings {
  SphereKind kind = SphereKind::Off;
  std::string probe;
  float roughness = 0.5f;  ///< perceptual
  bool operator==(const PreviewSphereSettings& o) const {
    return kind == o.kind && probe == o.probe && roughness == o.roughness;
  }
};

}  // namespace boxprobe
