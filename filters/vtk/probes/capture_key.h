// What a capture depends on, as fingerprints of contents: equal keys, equal pictures, in this run and the next. Decides
// what is captured again after an edit, which faces can be kept, and whether a file on disk still holds. Called by the
// probe set. Of a box its rotation alone counts, which turns the cube's axes. Its extent, blend distances, techniques,
// importance and intensity never do: what they change inside of a reflection's reflection stays as baked, and so does
// what they leave a share of in a first capture: the sky's light, and that of outside lights that ask for coverage.
// Neither VTK nor OpenGL.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/box_tree.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// Fingerprints of the objects of all models as the files have them, in the order of SceneContent::objects: geometry,
/// material, textures.
std::vector<std::string> objectContentKeys(const std::vector<std::shared_ptr<const Model>>& models,
                                           std::size_t modelCount);

/// One object as it stands in the picture.
struct PlacedObject {
  std::string node;
  std::string materialName;
  std::string contentKey;  ///< as objectContentKeys gave it
  glm::dmat4 worldFromModel{1.0};
  Box boundsWorld;
  bool seenByProbes = true;
  bool dynamic = false;  ///< moves: only realtime probes see it
  bool unlit = false;    ///< no probe lights it
};

/// One object as captures meet it.
struct CaptureObject {
  std::string key;  ///< contents, placement, overrides
  std::string node;
  Box boundsWorld;
  bool seenByProbes = true;
  bool dynamic = false;             ///< moves: only realtime probes see it
  std::vector<std::size_t> probes;  ///< those that light it, as indices into scene.probes
};

/// Everything captures depend on besides the probe itself.
struct CaptureWorld {
  std::vector<CaptureObject> objects;
  BoxTree tree;     ///< of their bounds
  std::string sky;  ///< skyKey
  std::string lights;
  bool lattices = false;  ///< diffuse light of probes, in later bounces, is that of lattices
  /// The sky whose light comes with lattices, whose nodes are traced to it: not in first captures of several, but in
  /// later ones, those of ClearToOpen included. Empty: lattices know no sky.
  std::string latticeSky;
};

/// `skyPixels`: the fingerprint of the sky's image if it is one; `probes`: of the scene's.
CaptureWorld captureWorld(const Scene& scene, const std::vector<PlacedObject>& objects, const std::string& skyPixels,
                          const ProbeIndex& probes);

/// The key of the sky's own map.
std::string skyKey(const Scene& scene, const std::string& skyPixels);
std::string imageContentKey(const ImageRgbaF& image);

/// The key of a map made from a picture of the user's.
std::string importKey(const Probe& probe, const CubeMap& picture);

/// Does this probe's capture show that object?
bool captureShows(const Probe& probe, const CaptureObject& object);

/// Indices, ascending, of the objects a face shows: those that its frustum meets.
std::vector<std::size_t> objectsInFace(const CaptureWorld& world, const Probe& probe, int face);

/// What one face, or the whole capture, of a probe shows.
struct CaptureView {
  std::string key;
  std::vector<std::size_t> lighting;  ///< the probes that light what is in it: later bounces show them, sorted
};

/// Of one face. An object outside of the face's frustum does not count: nothing there throws a shadow into it. So an
/// edit, or an object that moves, leaves the faces that do not show it as they are.
CaptureView faceView(const CaptureWorld& world, const Probe& probe, int face);
/// Of all six, with how they are filtered.
CaptureView probeView(const CaptureWorld& world, const Probe& probe);

}  // namespace boxprobe
