// A pixel of a hall with a turned cupboard in it, in which nothing is symmetric and every number is another one: two
// probes that share it with the sky, and what a case of explanation_values_test.cpp adds to them.
#pragma once

#include <string>
#include <vector>

#include "filters/explain/explain_pixel.h"
#include "filters/math/cube/glass_shell.h"

namespace boxprobe::test {

/// Maps that the hall's pixels are lit by; made once.
struct HallMaps {
  HallMaps();

  BakedMaps hall, cupboard, sky;
  BakedMaps open;      ///< the hall's, with directions in which it saw nothing
  BakedMaps lampFree;  ///< the hall's without its lamps, their colours in alpha
  CubeMap through;     ///< transmittance of the hall
  std::shared_ptr<const DiffuseLattice> lattice, cutLattice;
  std::vector<SceneLamp> lamps;
  std::shared_ptr<const ProbeSight> sight;
  std::shared_ptr<const SkyOpenness> openness;
  std::vector<GlassShell> shells;  ///< an egg
  MirrorTexels mirror;
};

const HallMaps& hallMaps();

struct HallPixel {
  HallPixel();

  /// Probe 0: the hall, 1: the cupboard.
  Probe& probe(std::size_t i) { return scene.probes[i]; }
  /// Towards a point of view.
  void seeFrom(const glm::dvec3& eye);
  void useLamps(bool lattice);
  void useGlass(const std::string& form, int number, bool back);
  Explanation explain() const;

  Scene scene;  ///< whose probes `in` has
  ExplainInput in;
  glm::dvec3 capturedRotation{0.0};  ///< of the cupboard's maps
  shading::MirrorLook mirror{};
};

/// What a case changes.
struct HallCase {
  std::string name;
  void (*change)(HallPixel& pixel);
};

const std::vector<HallCase>& hallCases();

}  // namespace boxprobe::test
