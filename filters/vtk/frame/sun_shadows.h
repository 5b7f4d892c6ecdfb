// Shadow maps of suns: of each directional light that asks for no shadows of its own, a depth map of all that stands
// still, drawn again when something is moved or the light turns; where a wide ground lies below what stands, a second
// one for that. An object reads one of them. On by themselves where lamps are drawn as shapes; none for a light whose
// shadow shows nowhere. They need no probe, so that a first capture has patches of sun, too, and follow from none: a
// probe's edit leaves its capture as it is.
#pragma once

#include <deque>
#include <optional>

#include "filters/vtk/frame/shadow_map.h"

namespace boxprobe {

/// Objects as a directional light sees them: across, up, and away from it.
struct SunView {
  glm::dmat3 sunFromWorld{1.0};  ///< rotation
  Box bounds;                    ///< of all that throws shadows
  glm::dmat4 mapFromWorld{1.0};  ///< to [0, 1]³
};
/// `casters`: world bounds of what throws shadows. Nothing: nothing does.
std::optional<SunView> sunView(const glm::dvec3& direction, const std::vector<Box>& casters);

/// Of each of `receivers`, world bounds: may one of `casters` throw a shadow on it, from between it and the light?
/// Flat ones throw none on themselves; they are those that have no extent along an axis of the world. `onGround`: what
/// stands on a flat one counts as well.
std::vector<bool> sunReceivers(const SunView& view, const std::vector<Box>& receivers, const std::vector<Box>& casters,
                               bool onGround = true);

/// A view around some of the objects alone, as deep as `all`, so that what stands between them and the light throws
/// its shadows there. `some`: their world bounds. Nothing: its texels would not be half as wide as those of `all`.
std::optional<SunView> sunViewAround(const SunView& all, const std::vector<Box>& some);

class SunShadows {
 public:
  static constexpr int kMapSize = 2048;        ///< texels a side
  static constexpr std::size_t kMostSuns = 2;  ///< the strongest lights have maps: samplers are scarce

  SunShadows(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content)
      : state_(state), content_(content), painter_(window, std::move(state), content) {}

  /// Finds out which lights have a shadow on what; before objects are bound to probes.
  void sceneChanged();
  /// Draws the maps that are stale; the window's context is current.
  void update();
  void release();

 private:
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  ShadowMapPainter painter_;
  /// What the maps follow from.
  struct Of {
    bool on = false;
    int models = -1;
    std::vector<Light> lights;
    std::vector<glm::dmat4> objects;
    std::vector<bool> casts;
    bool operator==(const Of& o) const {
      return on == o.on && models == o.models && lights == o.lights && objects == o.objects && casts == o.casts;
    }
  };
  void add(int light, const SunView& view, std::vector<bool> shades);
  Of of_;
  bool stale_ = false;
  std::deque<ShadowMap> maps_;
};

}  // namespace boxprobe
