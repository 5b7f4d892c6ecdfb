// How the draws of one pass differ from those of another: plain values that surfaces read when they draw. Changed
// for a pass by a PassScope and by nothing else.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec4.hpp>
#include <memory>

namespace boxprobe {

struct ProbeSight;

/// An exposure that asks for linear output, without a display's encoding.
constexpr float kLinearOutput = -1.0f;

/// What the debug view's programs show.
struct DebugView {
  int view = 0;  ///< row of surfaceViews()
  float low = 0.0f, high = 1.0f;
  bool finish = false;  ///< the surfaces' finish is captured, not what every surface has
  bool operator==(const DebugView& o) const {
    return view == o.view && low == o.low && high == o.high && finish == o.finish;
  }
};

/// The opaque part of the frame that is being drawn, for glass to be looked through at; without a texture there is
/// none.
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
  bool dragging = false;             ///< a handle is held: uniforms change, and nothing is worked out for them
  DebugView debug;                   ///< not in captures
  bool capture = false;              ///< of a probe: reflections show lamps as maps do, which costs little
  bool firstBounce = false;          ///< of a capture: probes reflect nothing yet, and the sky lights in their place
  bool firstBouncePrograms = false;  ///< with firstBounce: by programs that look nothing up in probes
  /// With firstBounce: the lamps that light what is captured, and what is seen of them, by the capture origin alone, so
  /// that no box has a part in a first capture. Null: no lamps are drawn as shapes.
  std::shared_ptr<const ProbeSight> sight;
  bool movingShadowsOn = true;  ///< not in captures of what stands still
  bool countDraws = true;       ///< of the frame on the screen, not of captures
  int frame = 0;                ///< of those that are averaged
  glm::ivec2 pixelOrigin{0};    ///< where in the picture the framebuffer's lower left lies
  /// Of the mirror whose picture is being drawn, view space; see mirrored_output.glsl.
  glm::vec4 heightPlaneView{0.0f};
  BehindPicture behind;

  bool operator==(const PassSettings& o) const {
    return exposure == o.exposure && dragging == o.dragging && debug == o.debug && capture == o.capture &&
           firstBounce == o.firstBounce && firstBouncePrograms == o.firstBouncePrograms && sight == o.sight &&
           movingShadowsOn == o.movingShadowsOn && countDraws == o.countDraws && frame == o.frame &&
           pixelOrigin == o.pixelOrigin && heightPlaneView == o.heightPlaneView && behind == o.behind;
  }
};

}  // namespace boxprobe
