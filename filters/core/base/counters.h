// What ran, counted: shown in the status bar and by --stats, asserted by tests. Plain values, no behaviour.
#pragma once

#include <array>
#include <cstdint>

namespace boxprobe {

/// Planar mirrors in the last frame: pictures drawn, and those left out, each by the first reason that held.
struct MirrorCounters {
  std::uint64_t drawn = 0;
  std::uint64_t texels = 0;          ///< of the pictures drawn, their finest level
  std::uint64_t disabled = 0;        ///< switched off, or hidden
  std::uint64_t rough = 0;           ///< rougher than their threshold
  std::uint64_t facingAway = 0;      ///< the eye is behind them
  std::uint64_t notInView = 0;       ///< outside of the picture
  std::uint64_t nothingDynamic = 0;  ///< nothing that moves is in what they show
  std::uint64_t overBudget = 0;      ///< larger ones had taken the frame's texels
};

struct Counters {
  std::uint64_t facesCaptured = 0;     ///< of probes
  std::uint64_t coarseFaces = 0;       ///< captured in few texels, to be seen until those of facesCaptured are there
  std::uint64_t facesReused = 0;       ///< of probes captured again, taken from earlier maps that show the same
  std::uint64_t mapsLoaded = 0;        ///< probes (and sky) read from baked files in place of captures
  std::uint64_t skyFacesCaptured = 0;  ///< of the sky's own map
  std::uint64_t levelsFiltered = 0;    ///< prefiltered mip levels, six faces each
  std::uint64_t levelsSkipped = 0;     ///< of captured maps: left out, because no material samples them
  std::uint64_t levelsMadeLater = 0;   ///< of those: filtered after all, when something asked for them
  std::uint64_t objectsCaptured = 0;   ///< draws of objects into probes' faces
  std::uint64_t objectsCulled = 0;  ///< objects of the scene that lie outside of such a face's view, and were not drawn
  std::uint64_t objectsUnlit = 0;   ///< of objectsCaptured: drawn by programs without any lookup of a probe
  std::uint64_t errorsMeasured = 0;  ///< probes whose own errors `auto` goes by, each time their box or picture changed
  std::uint64_t reliefsBounded =
      0;                           ///< probes whose distances' least and greatest were made, for rays that are followed
  std::uint64_t sightsTraced = 0;  ///< probes of which it was traced where their lamps are hidden
  std::uint64_t sightRays = 0;     ///< that this took
  std::uint64_t lampsSeenWhole = 0;     ///< lamps and light sources of such probes that nothing hides: not looked up
  std::uint64_t opennessRays = 0;       ///< traced to find how much of the sky is hidden from places (ambientOcclusion)
  std::uint64_t sourcesFlattened = 0;   ///< captures laid out flat to filter fine levels of them, on software renderers
  std::uint64_t mapsFlattened = 0;      ///< filtered chains laid out flat, for programs of software renderers at rest
  std::uint64_t programsCompiled = 0;   ///< GL programs this program caused; again, if one had been given back
  std::uint64_t programsGivenBack = 0;  ///< of surfaces: not drawn with for long
  std::uint64_t surfacePrograms = 0;    ///< of the last frame: distinct programs of surfaces
  std::uint64_t programSwitches = 0;    ///< of the last frame: surfaces drawn with another program than the one before
  std::uint64_t constantsFolded = 0;    ///< objects given a program with resting numbers as constants, since the start
  std::uint64_t constantsLeft = 0;      ///< of them, those drawn without again because a number had changed
  std::uint64_t renders = 0;
  std::array<std::uint64_t, 5> drawsByProbeCount{};  ///< of the last frame: draws that use 0, 1, 2, 3, 4 probes
  std::uint64_t drawsLeftOut = 0;       ///< of the last frame: nothing of them shows, as a frame of that view had shown
  bool skyLeftOut = false;              ///< was the sky one of those?
  std::uint64_t drawsWithOpenSky = 0;   ///< of the last frame: those that look up the sky through a probe's openings
  std::uint64_t drawsWithCoverage = 0;  ///< of the last frame: those that look up what lets a light through
  std::uint64_t shadowMapsDrawn = 0;    ///< of moving objects, since the start
  std::uint64_t texelsClamped = 0;      ///< captured samples above half-float range, brought down to it
  std::uint64_t texelsNotFinite = 0;    ///< captured samples that were NaN or infinite, set to 0
  std::uint64_t uniformUpdates = 0;     ///< draws whose probe uniforms were uploaded
  std::uint64_t glassDraws = 0;         ///< of the last frame: objects that transmit light
  std::uint64_t glassPasses = 0;        ///< and how often their faces were drawn in colour
  MirrorCounters mirrors;
};

}  // namespace boxprobe
