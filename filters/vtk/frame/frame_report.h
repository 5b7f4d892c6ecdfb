// What the last frame drew and omitted: the probes of each object, and the number of programs, lookups and bytes. Shown
// by `info --frame` and the window.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"

namespace boxprobe {

struct FrameReport {
  struct Share {
    std::string probe;
    double weight = 0.0;  ///< for the object's bounds as a whole; pixels have their own weights
  };
  struct Object {
    std::string node, material;
    bool drawn = false;  ///< false: outside the view, or hidden
    bool unlit = false;
    std::vector<Share> probes;  ///< in order of decreasing importance
    double sky = 1.0;
    std::size_t leftOut = 0;  ///< probes that reach it beyond the maximum of a draw
    Phrase givenUp;           ///< for want of texture units, as the end of a line; empty: nothing
    bool weights = false;     ///< are weights computed?
    std::string variant;      ///< objects with equal keys share a program, whatever their textures
  };
  struct ProbeUse {
    std::string name;
    std::size_t objects = 0;      ///< visible ones that it lights
    std::size_t drawn = 0;        ///< of those, drawn in this frame
    std::size_t bytes = 0;        ///< GPU memory; 0: it has none
    std::size_t levels = 0;       ///< of its chain
    std::size_t notFiltered = 0;  ///< of those: not filtered, because no material samples them
  };
  /// A planar mirror of the scene.
  struct MirrorUse {
    std::string node;
    bool drawn = false;
    Phrase why;                 ///< if not drawn: the reason, as the end of a sentence
    int width = 0, height = 0;  ///< texels of its picture
    std::size_t objects = 0;    ///< moving objects in it
    std::size_t hiding = 0;     ///< static objects that may hide those, drawn as depth only
  };
  struct Lookups {
    double mean = 0.0;  ///< over the pixels that show a surface
    double most = 0.0;
  };
  std::vector<Object> objects;  ///< visible ones
  std::vector<ProbeUse> probes;
  std::vector<MirrorUse> mirrors;
  std::array<std::size_t, 5> drawsByProbeCount{};
  bool skyCulled = false;       ///< the view is at rest, and objects cover all of it
  std::size_t variants = 0;     ///< among the objects that were drawn
  std::size_t mirrorBytes = 0;  ///< of the planar mirrors' pictures, not included in `bytes`
  std::size_t bytes = 0;        ///< of all maps, including those kept for undo
  std::optional<Lookups> lookups;
};

/// An OpenGL program of the last frame, and the objects it drew.
struct DrawnProgram {
  struct Object {
    std::size_t index = 0;  ///< in the renderer's list of objects, until the models change
    std::string node;
  };
  std::vector<Object> objects;
};

/// The cost of the planar mirrors' pictures that were drawn, one sentence each.
std::vector<Phrase> mirrorLines(const FrameReport& report);
/// Work that the frame could skip, one sentence each.
std::vector<Phrase> skippedLines(const FrameReport& report);
/// Objects that more probes reach than a draw can have, or with more impostors than the driver links, one sentence
/// each.
std::vector<Phrase> leftOutLines(const FrameReport& report);

}  // namespace boxprobe
