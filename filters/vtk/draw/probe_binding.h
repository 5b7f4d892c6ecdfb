// Which probes per object is drawn with, and what of them its program is compiled for. Chosen by the probe set, read by
// the probe pass and the splice. Plain data; knows no scene.
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

/// A probe as draws see it. `maps` is null until the first capture is complete; it then gives nothing.
struct DrawnProbe {
  int index = 0;  ///< in the scene's list
  ProbeGeometry geometry;
  std::shared_ptr<const ProbeMaps> maps;
  /// What `auto` goes by; null: by what was measured elsewhere.
  std::shared_ptr<const TechniqueErrors> errors;
  bool open = false;                        ///< the sky shows where the probe saw nothing, and there is such a place
  ShCoefficients openSky{};                 ///< its diffuse light that comes in there, to be added to the maps'
  std::uint32_t shadowLights = 0;           ///< a bit for each light that asks for shadows and lies outside of its box
  bool seesSky = true;                      ///< where its capture meets nothing stands the sky
  bool imported = false;                    ///< from a picture, which may have no coverage
  bool shapes = false;                      ///< its diffuse light is its lamps' and a lattice's
  std::vector<std::size_t> lamps;           ///< of the scene's, those drawn as shapes
  std::shared_ptr<const ProbeSight> sight;  ///< what is seen of those and of light sources; null: all, everywhere
  PrefilterSettings prefilter;              ///< of its maps
  bool realtime = false;                    ///< its maps are made over and over
  mutable std::shared_ptr<const DiffuseLattice> latticeBefore;  ///< the last it was drawn with (probe_lattice.h)
  /// The lamps that light what its first capture shows, by its capture origin alone. Null: none are drawn as shapes.
  std::shared_ptr<const ProbeSight> captureSight;
};

enum class Lighting {
  Plain,   ///< VTK's own: no probe, no sky
  Unlit,   ///< KHR_materials_unlit: emission only
  Probes,  ///< probes, and the sky for what they leave
};

/// Which probes one actor uses: what its program is compiled for.
struct ProbeBinding {
  Lighting lighting = Lighting::Plain;
  std::vector<std::shared_ptr<const DrawnProbe>> probes;  ///< most important first, at most kMaxProbesPerDraw
  static constexpr std::size_t kMaxProbesPerDraw = 4;
  static constexpr std::size_t kMaxLampsPerDraw = 16;  ///< of all its probes, by power
  bool weights = true;                                 ///< false: one probe, at full weight all over the object
  bool sky = true;                                     ///< false: the probes leave nothing to it
  bool onlyProbes = false;                             ///< what they leave to it goes to them, wherever one has weight
  std::vector<float> shares;  ///< of all of the object, in place of weights a pixel; empty: those
  float skyShare = 1.0f;      ///< beside `shares`
  /// Lights that a probe's coverage stands before, those with maps of what moves, and suns with maps of what stands
  /// still; in the scene's order.
  std::vector<int> shadowLights, movingLights, sunLights;
  /// Light sources, in the scene's order, that some place of a probe's box does not see whole.
  std::vector<int> sightLights;
  std::size_t leftOut = 0;  ///< probes that reach the object and are more than a draw can have
  bool diffuse = true;      ///< false: the material is all metal
  bool shapes = false;      ///< some probe's diffuse light is its lamps' and a lattice's
  bool lamps = false;       ///< some of these has lamps, or its first capture
  /// Reflections of the object are rough enough to show those lamps by their shapes. Then maps without them are looked
  /// up.
  bool lampLobes = false;
  float roughnessMin = 0.0f, roughnessMax = 1.0f;  ///< of the object

  /// Are there shadows of lamps or light sources to look up?
  bool sights() const;

  /// No probe has been captured yet, so that none gives a reflection: nothing is looked up. For captures alone.
  bool firstBounce = false;

  /// What draws each: the probe's own technique, or what `auto` chose for this object. Empty: their own.
  std::vector<Technique> techniques;
  Technique technique(std::size_t slot) const;
  /// Parameters that each is drawn with, of a refined picture. Empty: the probes' own.
  std::vector<shading::TechniqueParameters> refinedValues;
  const shading::TechniqueParameters& values(std::size_t slot) const {
    return slot < refinedValues.size() ? refinedValues[slot] : probes[slot]->geometry.parameters;
  }

  /// Equal keys share a program: techniques, importance groups, and what can be left out.
  std::string variantKey() const;
  /// The same by what stands in for its techniques while something moves; null if nothing does.
  std::shared_ptr<const ProbeBinding> standIn() const;
  /// The same by rays of the whole lobe, `samples` of each of its frames, which are `total` in all; impostors follow
  /// rays. Null where that would show nothing else.
  std::shared_ptr<const ProbeBinding> refined(int samples, int total) const;
  /// The same for captures in which no probe reflects anything; null where that would not spare any lookup, or where
  /// what is looked up does not depend on the probes alone.
  std::shared_ptr<const ProbeBinding> forFirstBounce() const;
  /// Is a technique that is drawn one whose picture is a mean of frames, and of how many rays per pixel and frame? 0:
  /// no.
  int animatedSamples() const;
  /// Is what a technique samples here smoothed afterwards?
  bool blurred(std::size_t slot) const;
  /// Rays a pixel and frame of those that are; 0: none is.
  int blurredSamples() const;
  /// Is a box turned, or what a probe holds against its box?
  bool rotated() const;
  bool bevelled() const;
  bool occluded() const;
  /// Does the sky show through a probe? And lookup by lookup?
  bool open() const;
  bool openByLookup(std::size_t slot) const;
  bool lampsDrawn() const { return (shapes && diffuse && lamps) || lampLobes; }
  /// Does a rough surface look this one's map up without lamps? Not where alpha is coverage, or maps do not last.
  bool lampFree(std::size_t slot) const;
  /// The map that it looks up: that one, as soon as it is made, but not in a capture. Null: not captured.
  const ProbeMaps* lookedUp(std::size_t slot, bool capture) const;
  /// Does a technique of a probe fetch from its distance cubemap?
  bool distances() const;
  /// Does this one's follow rays through all of them: more than three steps of projection `impostor`?
  bool marches(std::size_t slot) const;
  /// Does a technique of a probe read the parameter, set to that choice?
  bool chooses(std::string_view parameter, std::string_view choice) const;
  /// Parameters that any of its techniques reads, each once.
  std::vector<const ParameterRow*> parameters() const;
  /// Group of equal importance of each probe, from 0.
  std::vector<int> groups() const;
};

}  // namespace boxprobe
