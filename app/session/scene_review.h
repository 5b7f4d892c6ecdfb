// A scene looked at for people who decide about it: every camera drawn and path traced, how far the two are apart, how
// well each probe's box fits and what the probe costs. Called by `boxprobe report` and the window; writes nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "filters/fit/box/fit_box.h"
#include "filters/reference/bench/whole_picture.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

class OffscreenScene;
class SharedWork;

struct ReviewSettings {
  int width = 640, height = 360;
  int paths = 128;              ///< per pixel, of the traced pictures
  int samplesPerPixel = 16;     ///< of the drawn ones
  std::uint64_t seed = 1;       ///< of the paths
  std::vector<Camera> cameras;  ///< empty: every camera of the scene, or the default one where it has none
  /// Takes over traced pictures and fits that other processes made.
  const SharedWork* shared = nullptr;
};

struct ReviewedCamera {
  Camera camera;
  ImageRgbaF picture;            ///< linear, as it is drawn
  ReferencePicture truth;        ///< path traced
  std::vector<PartError> parts;  ///< as `bench --whole` measures them; the first is that of all pixels
  FrameReport::Lookups lookups;  ///< cubemap samples per pixel
  const PartError& all() const { return parts.front(); }
};

struct ReviewedProbe {
  Probe probe;
  std::optional<BoxFit> fit;  ///< nothing for a custom probe's picture, which saw another room
  std::size_t bytes = 0;      ///< of its textures
  std::size_t objects = 0;    ///< visible ones that it lights, from the first camera
};

struct SceneReview {
  std::string name;  ///< of the file, without extensions
  Scene scene;       ///< with the exposure that it is shown with
  std::vector<ReviewedCamera> cameras;
  std::vector<ReviewedProbe> probes;
  std::size_t triangles = 0;
  std::uint64_t faces = 0;  ///< captured
  /// Capturing and filtering of all of them, all threads; nothing where pages of several runs are to be the same.
  std::optional<double> captureCpuSeconds;
  std::string rendererName;  ///< OpenGL's, and the anisotropy of textures
  std::vector<std::string> remarks;

  /// The largest relative RMSE of a camera.
  double worstError() const;
};

/// `progress` is told how far the work is, 0 to 1, and may return false to stop it: nothing then. The exposure of a
/// bare model is found from the first camera. Throws WorkError and InputError as OffscreenScene does.
std::optional<SceneReview> reviewScene(LoadedScene loaded, OffscreenScene& shown, const ReviewSettings& settings,
                                       const std::function<bool(double)>& progress);

/// Makes and keeps the share of `settings.shared` of the traced pictures, as rows of each, and of the fits; draws
/// nothing. `cameras` as in the settings. False if `progress` stopped it.
bool reviewShare(const LoadedScene& loaded, const ReviewSettings& settings,
                 const std::function<bool(double)>& progress);

}  // namespace boxprobe
