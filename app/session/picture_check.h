// Whether placed probes make pictures better: small pictures from eyes in the rooms, with the scene's own probes and
// with others, against the path tracer's. Called by `boxprobe place` and by the window's place panel.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/fit/place_probes.h"

namespace boxprobe {

class SharedWork;

/// Over the surfaces that the eyes see, without lamps. Errors are root mean squares over those of the truth, with the
/// truth's noise taken off, all light above five times the mean of the picture counted as that.
struct PictureErrors {
  /// Of each picture over its own light, as people see it, or over a tenth of the mean of all; root mean square of all
  /// eyes. Mirrors and other glossy surfaces count four times.
  double error = 0.0;
  double glossy = 0.0;  ///< of glossy surfaces alone
  double light = 1.0;   ///< mean over that of the truth
};

/// Errors of the eyes that stand in one room, as PictureErrors::error.
struct RoomErrors {
  bool seen = false;  ///< an eye stands in it; else both are 0
  double before = 0.0, after = 0.0;
};

/// What an eye sees: linear colours, all of one size.
struct EyePictures {
  std::size_t room = 0;
  Camera camera;
  ImageRgbaF before, after, truth;
};

struct PictureCheck {
  std::size_t eyes = 0;
  PictureErrors before, after;                     ///< with the scene's own probes; with what is proposed
  bool better = false;                             ///< surely; false: the scene's own probes stay
  std::vector<Phrase> sentences;                   ///< without full stop: what was tried, and what it brought
  std::vector<RoomErrors> rooms;                   ///< in the order of the placement's rooms
  std::vector<EyePictures> views;                  ///< if asked for, and something is proposed
  std::vector<std::optional<std::size_t>> viewOf;  ///< per probe of Placement::all(): the view that shows it best
  double seconds = 0.0;
};

struct PictureCheckSettings {
  bool views = false;  ///< makes PictureCheck::views, 96 by 54 pixels, for those who review what is proposed
  int paths = 96;      ///< per pixel of the truth that is measured against; half as many for the views
  /// Takes over pictures that other processes made, and keeps its own. One that is sharing() looks from its share of
  /// the eyes alone: what it finds is no result.
  const SharedWork* shared = nullptr;
};

/// Tries `placement`, the same with all bounces of light and with one, without the probes of parts of rooms, one box
/// around all rooms and one around all of the model, and the scene's own probes with all bounces, where a bare model's
/// is as it opened also with one; leaves in `placement` what measured best. If that is not surely better than what the
/// scene has, it leaves the scene's own probes as those kept. Surely: by 5 %, or by 1 % of which the eyes tell alike,
/// so that others would, too. Captures are small ones, and of at most four bounces where there are more than sixteen
/// probes. Nothing if `progress` stopped it; without eyes or light no check, and a sentence that says so.
std::optional<PictureCheck> checkPictures(const LoadedScene& loaded, Placement& placement, OffscreenScene& shown,
                                          const std::function<bool(double)>& progress,
                                          const PictureCheckSettings& settings = {});

/// Would other eyes find it better, too? True if the mean of what each of these gains is more than twice its standard
/// error; false with fewer than six. `before`, `after`: squared errors of the same eyes.
bool eyesAgree(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace boxprobe
