// The probes that an object is drawn with, and their properties for which its program is compiled. Chosen by the probe
// set.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/technique/automatic.h"
#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

/// A probe for drawing. Until the first capture is complete `maps` is null, and the probe gives no light.
struct DrawnProbe {
  int index = 0;  ///< in the scene's list
  ProbeGeometry geometry;
  std::shared_ptr<const ProbeMaps> maps;
  /// Errors from which `auto` chooses; null: the measured table.
  std::shared_ptr<const TechniqueErrors> errors;
  bool open = false;                    ///< the sky shows where the probe saw nothing, and such places exist
  ShCoefficients openSky{};             ///< diffuse light of the sky through openings, to be added to that of the maps
  std::uint32_t shadowLights = 0;       ///< one bit per light that casts shadows and is outside its box
  bool seesSky = true;                  ///< where its capture meets nothing, there is the sky
  bool imported = false;                ///< from a picture, which may have no coverage
  bool shapes = false;                  ///< diffuse light comes from lamps as shapes and a lattice
  std::optional<ProbeLattice> lattice;  ///< as the scene has it; where it is not used, diffuse light is the map's
  std::vector<std::size_t> lamps;       ///< indices of scene lamps that are drawn as shapes
  std::shared_ptr<const ProbeSight> sight;  ///< visibility of those and of light sources; null: all visible everywhere
  PrefilterSettings prefilter;              ///< of its maps
  bool realtime = false;                    ///< its maps are recaptured continuously
  mutable std::shared_ptr<const DiffuseLattice> latticeBefore;  ///< the last one it had (probe_lattice.h)
  /// The lamps that light what its first capture shows, by its capture origin alone. Null: none are drawn as shapes.
  std::shared_ptr<const ProbeSight> captureSight;
};

/// A sun whose shadow an object has by a map of what stands still.
struct SunUse {
  int light = 0;        ///< in the scene
  std::size_t map = 0;  ///< in SceneResources::sunShadows
};

/// What a draw goes without, because the driver has too few texture units (fewer_samplers.h).
struct GivenUp {
  std::size_t impostors = 0;  ///< drawn by their box
  std::size_t probes = 0;     ///< left out
  bool lightTables = false, openness = false, movingShadows = false;
  bool covered = false;  ///< with all its probes the sky had no share
};

enum class Lighting {
  Plain,   ///< VTK's own: no probe, no sky
  Unlit,   ///< KHR_materials_unlit: emission only
  Probes,  ///< probes, and the sky where they leave weight
};

/// The probes of one actor, for which its program is compiled.
struct ProbeBinding {
  Lighting lighting = Lighting::Plain;
  std::vector<std::shared_ptr<const DrawnProbe>> probes;  ///< most important first, at most kMaxProbesPerDraw
  static constexpr std::size_t kMaxProbesPerDraw = 4;
  static constexpr std::size_t kMaxLampsPerDraw = 16;  ///< of all its probes, by decreasing power
  bool weights = true;                                 ///< false: one probe, at full weight everywhere on the object
  bool sky = true;                                     ///< false: the sky has no share
  bool openness = false;                               ///< the sky is occluded by the scene (ambientOcclusion)
  bool onlyProbes = false;                             ///< probes share the sky's part wherever one has weight
  std::vector<float> shares;  ///< for the whole object, in place of weights per pixel; empty: per pixel
  float skyShare = 1.0f;      ///< with `shares`
  /// Lights that a probe's coverage shadows, those with maps of moving objects, and suns with maps of objects that
  /// stand still; in the scene's order.
  std::vector<int> shadowLights, movingLights;
  std::vector<SunUse> sunLights;
  /// Light sources, in the scene's order, that are not visible from everywhere in a probe's box or a capture.
  std::vector<int> sightLights;
  std::size_t leftOut = 0;  ///< probes that reach the object beyond the maximum of a draw
  GivenUp givenUp;
  bool diffuse = true;  ///< false: the material is all metal
  bool shapes = false;  ///< a probe's diffuse light comes from lamps as shapes and a lattice
  bool lamps = false;   ///< one of these has lamps, or its first capture has
  /// Reflections of the object are rough enough to draw those lamps as shapes. Then maps without lamps are sampled.
  bool lampLobes = false;
  /// Some probe's first capture has visibilities; it may see the object, wherever it stands.
  bool captureSights = false;
  float roughnessMin = 0.0f, roughnessMax = 1.0f;  ///< range over the object

  /// Are there visibilities of lamps or light sources to sample?
  bool sights() const;

  /// For captures: no probe has been captured yet, so reflections are not sampled.
  bool firstBounce = false;

  /// The technique for each probe: its own, or the one `auto` chose for this object. Empty: their own.
  std::vector<Technique> techniques;
  Technique technique(std::size_t slot) const;
  /// The parameters for each probe in a refined picture. Empty: the probes' own.
  std::vector<shading::TechniqueParameters> refinedValues;
  const shading::TechniqueParameters& values(std::size_t slot) const {
    return slot < refinedValues.size() ? refinedValues[slot] : probes[slot]->geometry.parameters;
  }

  /// Equal keys share a program: techniques, importance groups, and what can be omitted.
  std::string variantKey() const;
  /// The same with cheap techniques while something moves; null if nothing differs.
  std::shared_ptr<const ProbeBinding> standIn() const;
  /// The same with rays over the whole lobe, `samples` in each frame and `total` in all; impostors follow rays. Null if
  /// the picture would be the same.
  std::shared_ptr<const ProbeBinding> refined(int samples, int total) const;
  /// The same for captures in which no probe reflects anything; null if that saves no lookup, or if lookups do not
  /// depend on probes alone.
  std::shared_ptr<const ProbeBinding> forFirstBounce() const;
  /// Rays per pixel and frame of a technique that averages frames; 0: none does.
  int animatedSamples() const;
  /// Are the technique's samples smoothed afterwards?
  bool blurred(std::size_t slot) const;
  /// Rays per pixel and frame of smoothed techniques; 0: none.
  int blurredSamples() const;
  /// Is a box rotated, or a probe's map against its box?
  bool rotated() const;
  bool bevelled() const;
  bool occluded() const;
  /// Does the sky show through a probe? Below: separately for each lookup?
  bool open() const;
  bool openByLookup(std::size_t slot) const;
  bool lampsDrawn() const { return (shapes && diffuse && lamps) || lampLobes; }
  /// Do rough surfaces sample a map without lamps? Not if alpha is coverage, or if maps are short-lived.
  bool lampFree(std::size_t slot) const;
  /// The map to sample: the one without lamps once it is made, but not in a capture. Null: not captured.
  const ProbeMaps* lookedUp(std::size_t slot, bool capture) const;
  /// Does a probe's technique sample its distance cubemap?
  bool distances() const;
  /// Does this probe's technique march along rays: projection `impostor` with more than three steps?
  bool marches(std::size_t slot) const;
  /// Does a probe's technique read the parameter, with that choice?
  bool chooses(std::string_view parameter, std::string_view choice) const;
  /// Does a probe spread its rays by the blue-noise mask: by its own choice, or refined?
  bool blueNoise() const { return chooses("pattern", "blue") || !refinedValues.empty(); }
  /// Parameters that any of its techniques reads, without duplicates.
  std::vector<const ParameterRow*> parameters() const;
  /// The importance group of each probe, from 0.
  std::vector<int> groups() const;
};

}  // namespace boxprobe
