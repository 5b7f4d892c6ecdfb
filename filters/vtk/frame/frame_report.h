// What a frame does and what it leaves out, as plain values: which object is drawn with which probes, how many
// programs, lookups and bytes that takes. Made by the scene renderer, shown by `info --frame` and the window.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace boxprobe {

struct FrameReport {
  struct Share {
    std::string probe;
    double weight = 0.0;  ///< of the object's bounds as a whole; the pixels' own weights vary about it
  };
  struct Object {
    std::string node, material;
    bool drawn = false;  ///< false: out of the view, or hidden behind others
    bool unlit = false;
    std::vector<Share> probes;  ///< most important first
    double sky = 1.0;
    std::size_t leftOut = 0;  ///< probes that reach it beyond those a draw can have
    bool weights = false;     ///< are there weights to compute?
    std::string variant;      ///< objects of the same share a program, textures apart
  };
  struct ProbeUse {
    std::string name;
    std::size_t objects = 0;      ///< visible ones that it lights
    std::size_t drawn = 0;        ///< of those, in this frame
    std::size_t bytes = 0;        ///< on the graphics side, 0: nothing is there
    std::size_t levels = 0;       ///< of its chain
    std::size_t notFiltered = 0;  ///< of those: left out, because no material samples them
  };
  /// A planar mirror of the scene.
  struct MirrorUse {
    std::string node;
    bool drawn = false;
    std::string why;            ///< not drawn: the reason, as the end of a sentence
    int width = 0, height = 0;  ///< texels of its picture
    std::size_t objects = 0;    ///< that move, in it
    std::size_t hiding = 0;     ///< that stand still and may hide those, in depth alone
  };
  struct Lookups {
    double mean = 0.0;  ///< over the pixels that show a surface
    double most = 0.0;
  };
  std::vector<Object> objects;  ///< visible ones
  std::vector<ProbeUse> probes;
  std::vector<MirrorUse> mirrors;
  std::array<std::size_t, 5> drawsByProbeCount{};
  bool skyLeftOut = false;      ///< the view rests, and objects cover all of it
  std::size_t variants = 0;     ///< among the objects that are drawn
  std::size_t mirrorBytes = 0;  ///< of the planar mirrors' pictures, not in `bytes`
  std::size_t bytes = 0;        ///< of all maps, those kept for undo included
  std::optional<Lookups> lookups;
};

/// An OpenGL program of the last frame and the objects that it drew.
struct DrawnProgram {
  struct Object {
    std::size_t index = 0;  ///< its place among the renderer's objects, until the models change
    std::string node;
  };
  std::vector<Object> objects;
};

/// What the pictures of planar mirrors that were drawn took, one sentence each.
std::vector<std::string> mirrorLines(const FrameReport& report);
/// What the frame did not have to do, one sentence each.
std::vector<std::string> skippedLines(const FrameReport& report);
/// Objects that more probes reach than a draw can have, one sentence each.
std::vector<std::string> leftOutLines(const FrameReport& report);

}  // namespace boxprobe
