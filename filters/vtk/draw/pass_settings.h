// The settings that differ between passes: values that surfaces read when they draw. Changed only by a PassScope.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec4.hpp>
#include <memory>

namespace boxprobe {

struct ProbeSight;

/// An exposure that requests linear output, without display encoding.
constexpr float kLinearOutput = -1.0f;

/// What the programs of the debug view show.
struct ShownDebugView {
  int view = 0;  ///< row of surfaceViews()
  float low = 0.0f, high = 1.0f;
  bool finish = false;  ///< capture the surfaces' finish instead of the common properties
  bool operator==(const ShownDebugView& o) const {
    return view == o.view && low == o.low && high == o.high && finish == o.finish;
  }
};

/// The opaque part of the current frame, which is seen through glass; none without a texture.
struct BehindPicture {
  unsigned int color = 0;  ///< premultiplied by coverage, with mip levels
  unsigned int depth = 0;
  int width = 0, height = 0;  ///< pixels
  bool operator==(const BehindPicture& o) const {
    return color == o.color && depth == o.depth && width == o.width && height == o.height;
  }
};

struct PassSettings {
  float exposure = 1.0f;             ///< factor of display colours; kLinearOutput
  bool dragging = false;             ///< a handle is being dragged: only uniforms change, and nothing is precomputed
  ShownDebugView debug;              ///< not in captures
  bool capture = false;              ///< for a probe: reflections take lamps from maps, which is cheap
  bool firstBounce = false;          ///< in a capture: probes reflect nothing yet, and the sky lights in their place
  bool firstBouncePrograms = false;  ///< with firstBounce: use programs without probe lookups
  /// With firstBounce: the lamps that light the captured scene, and their visibility, by the capture origin alone, so
  /// that a first capture does not depend on any box. Null: no lamps are drawn as shapes.
  std::shared_ptr<const ProbeSight> sight;
  bool movingShadowsOn = true;  ///< off in captures of static objects
  bool countDraws = true;       ///< on for the frame on the screen, off for captures
  bool sunDisc = true;          ///< a sun that is drawn as a light shows in the sky, too; not in captures
  int frame = 0;                ///< number among averaged frames
  glm::ivec2 pixelOrigin{0};    ///< position of the framebuffer's lower left in the picture
  /// The plane of the mirror whose picture is being drawn, view space; see mirrored_output.glsl.
  glm::vec4 heightPlaneView{0.0f};
  BehindPicture behind;

  bool operator==(const PassSettings& o) const {
    return exposure == o.exposure && dragging == o.dragging && debug == o.debug && capture == o.capture &&
           firstBounce == o.firstBounce && firstBouncePrograms == o.firstBouncePrograms && sight == o.sight &&
           movingShadowsOn == o.movingShadowsOn && sunDisc == o.sunDisc && countDraws == o.countDraws &&
           frame == o.frame && pixelOrigin == o.pixelOrigin && heightPlaneView == o.heightPlaneView &&
           behind == o.behind;
  }
};

}  // namespace boxprobe
