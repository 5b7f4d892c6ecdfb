// Fingerprints of the inputs of captures: equal keys mean equal pictures, in this run and the next. They determine what
// is recaptured after an edit, which faces are reused, and whether a file is still valid. Of a box, only its rotation
// counts, which rotates the cube's axes. Its extent, blend distances, techniques, importance and intensity never do:
// their effect on reflections inside reflections stays as baked, and so does their effect on shares in a first capture:
// of the sky's light, and of outside lights with coverage shadows. Where lamps are shapes it counts whether an object
// is within any influence, since without a probe it has no light of them. No VTK or OpenGL.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "filters/core/geometry/box_tree.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// Fingerprints of the objects of all models as in their files, in the order of SceneContent::objects: geometry,
/// material, textures.
std::vector<std::string> objectContentKeys(const std::vector<std::shared_ptr<const Model>>& models,
                                           std::size_t modelCount);

/// An object in the current picture.
struct PlacedObject {
  std::string node;
  std::string materialName;
  std::string contentKey;  ///< from objectContentKeys
  glm::dmat4 worldFromModel{1.0};
  Box boundsWorld;
  bool seenByProbes = true;
  bool dynamic = false;  ///< moves: only realtime probes see it
  bool unlit = false;    ///< not lit by probes
};

/// An object for captures.
struct CaptureObject {
  std::string key;  ///< contents, placement, overrides
  std::string node;
  Box boundsWorld;
  bool seenByProbes = true;
  bool dynamic = false;             ///< moves: only realtime probes see it
  bool unlit = false;               ///< not lit by probes
  std::vector<std::size_t> probes;  ///< that light it, as indices into scene.probes
};

/// All inputs of captures except the probe itself.
struct CaptureWorld {
  std::vector<CaptureObject> objects;
  BoxTree tree;     ///< of their bounds
  std::string sky;  ///< skyKey
  std::string lights;
  bool lattices = false;  ///< later bounces take the diffuse light of probes from lattices
  /// The sky whose light comes with lattices, whose nodes are traced to it: not in first captures of several, but in
  /// later ones, those of ClearToOpen included. Empty: lattices know no sky.
  std::string latticeSky;
  std::set<std::string> cutShort;  ///< probes whose later bounces another run makes, from the files of this one's

  /// Is a first capture of it, or will it be, followed by others?
  bool several(const Probe& probe) const { return probe.bounces > 1 || cutShort.count(probe.name) != 0; }
  bool nodesBringSky(const Probe& probe) const { return !latticeSky.empty() && probe.hasLattice(); }
};

/// `skyPixels`: the fingerprint of the sky's image, if it has one; `probes`: the scene's.
CaptureWorld captureWorld(const Scene& scene, const std::vector<PlacedObject>& objects, const std::string& skyPixels,
                          const ProbeIndex& probes);

/// The key of the sky's own map.
std::string skyKey(const Scene& scene, const std::string& skyPixels);
std::string imageContentKey(const ImageRgbaF& image);

/// The key of a map made from a picture file.
std::string importKey(const Probe& probe, const CubeMap& picture);

/// How a probe lights what others capture, apart from its maps: box, influence, weight, technique and their like.
std::string drawnKey(const Probe& probe);

/// Does this probe's capture show that object?
bool captureShows(const Probe& probe, const CaptureObject& object);

/// Ascending indices of the objects whose bounds meet a face's frustum.
std::vector<std::size_t> objectsInFace(const CaptureWorld& world, const Probe& probe, int face);

/// What one face, or the whole capture, of a probe shows.
struct CaptureView {
  std::string key;
  std::vector<std::size_t> lighting;  ///< probes that light its contents, sorted: later bounces show their light
};

/// For one face. Objects outside the face's frustum do not count, because they cast no shadow into it. So an edit or a
/// moving object does not affect faces that do not show it.
CaptureView faceView(const CaptureWorld& world, const Probe& probe, int face);
/// For all six, including the filter settings.
CaptureView probeView(const CaptureWorld& world, const Probe& probe);

}  // namespace boxprobe
