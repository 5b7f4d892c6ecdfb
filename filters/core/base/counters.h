// Counts of what ran: shown in the status bar and by --stats, asserted by tests.
#pragma once

#include <array>
#include <cstdint>

namespace boxprobe {

/// Planar mirrors in the last frame: the pictures drawn, and the mirrors skipped, each under the first reason that
/// applied.
struct MirrorCounters {
  std::uint64_t drawn = 0;
  std::uint64_t texels = 0;          ///< of the pictures drawn, at their finest level
  std::uint64_t disabled = 0;        ///< switched off, or hidden
  std::uint64_t rough = 0;           ///< rougher than their threshold
  std::uint64_t facingAway = 0;      ///< the eye is behind them
  std::uint64_t notInView = 0;       ///< outside the picture
  std::uint64_t nothingDynamic = 0;  ///< nothing that moves is visible in them
  std::uint64_t overBudget = 0;      ///< larger mirrors had used up the frame's texels
};

struct Counters {
  std::uint64_t facesCaptured = 0;     ///< of probes
  std::uint64_t coarseFaces = 0;       ///< captured in few texels, shown until those of facesCaptured are there
  std::uint64_t facesReused = 0;       ///< of recaptured probes: copied from earlier maps that show the same
  std::uint64_t mapsLoaded = 0;        ///< probes (and sky) read from baked files instead of captured
  std::uint64_t skyFacesCaptured = 0;  ///< of the sky's own map
  std::uint64_t levelsFiltered = 0;    ///< prefiltered mip levels, six faces each
  std::uint64_t levelsSkipped = 0;     ///< of captured maps: not filtered, because no material samples them
  std::uint64_t levelsMadeLater = 0;   ///< of those: filtered later, when something needed them
  std::uint64_t objectsCaptured = 0;   ///< draws of objects into probes' faces
  std::uint64_t objectsCulled = 0;     ///< objects outside a face's view, which were not drawn
  std::uint64_t objectsUnlit = 0;      ///< of objectsCaptured: drawn by programs without probe lookups
  std::uint64_t errorsMeasured = 0;    ///< errors of a probe measured for `auto`, once per change of its box or picture
  std::uint64_t reliefsBounded = 0;    ///< probes whose distances were bounded, for rays that are followed
  std::uint64_t sightsTraced = 0;      ///< probes whose lamps' visibilities were traced
  std::uint64_t sightRays = 0;         ///< rays traced for that
  std::uint64_t lampsSeenWhole = 0;    ///< lamps and light sources of such probes that nothing hides: no lookup
  std::uint64_t opennessRays = 0;      ///< rays traced for ambient occlusion
  std::uint64_t sourcesFlattened = 0;  ///< captures laid out flat, to filter their fine levels on software renderers
  std::uint64_t mapsFlattened = 0;  ///< filtered chains laid out flat, for programs with constants on software drivers
  std::uint64_t programsCompiled = 0;  ///< GL programs compiled; a released program counts again
  std::uint64_t programsReleased = 0;  ///< surface programs released because nothing had been drawn with them for long
  std::uint64_t surfacePrograms = 0;   ///< in the last frame: distinct surface programs
  std::uint64_t programSwitches = 0;   ///< in the last frame: surfaces drawn with another program than the one before
  std::uint64_t constantsFolded = 0;   ///< objects given a program with values at rest as constants, since the start
  std::uint64_t constantsLeft = 0;     ///< of them: drawn without constants again, because a value had changed
  std::uint64_t renders = 0;
  std::array<std::uint64_t, 5> drawsByProbeCount{};  ///< in the last frame: draws that use 0, 1, 2, 3, 4 probes
  std::uint64_t drawsCulled = 0;       ///< in the last frame: culled, as a frame of that view had shown nothing of them
  bool skyCulled = false;              ///< was the sky culled as well?
  std::uint64_t drawsWithOpenSky = 0;  ///< in the last frame: draws that sample the sky through a probe's openings
  std::uint64_t drawsWithCoverage = 0;  ///< in the last frame: draws that sample coverage for a light's shadow
  std::uint64_t shadowMapsDrawn = 0;    ///< of moving objects, since the start
  std::uint64_t texelsClamped = 0;      ///< captured samples clamped to half-float range
  std::uint64_t texelsNotFinite = 0;    ///< captured samples that were NaN or infinite, set to 0
  std::uint64_t uniformUpdates = 0;     ///< draws whose probe uniforms were uploaded
  std::uint64_t glassDraws = 0;         ///< in the last frame: objects that transmit light
  std::uint64_t glassPasses = 0;        ///< in the last frame: how often their faces were drawn in colour
  MirrorCounters mirrors;
};

}  // namespace boxprobe
