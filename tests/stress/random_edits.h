// Edits as a restless user would make them, from a seed: every field of every kind of entry, valid ones and some that
// must be refused. Called by the soak tests; knows the scene, neither files nor pictures.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe::test {

struct EditLimits {
  std::vector<std::string> techniques;  ///< empty: every projection with every evaluation
  std::vector<std::string> materials = {"paint", "floor"};
  std::vector<std::string> nodes = {"ball", "wall"};
  std::size_t mostProbes = 12;
  int largestFace = 2048, mostBounces = 5;
  std::string folder;  ///< of models and pictures that need not exist; empty: none are named
};

class RandomEdits {
 public:
  RandomEdits(unsigned seed, EditLimits limits);

  /// One edit of `scene` as it is; the result may be the scene itself.
  std::function<void(Scene&)> next(const Scene& scene);
  /// One whose result validate() must refuse.
  std::function<void(Scene&)> nextInvalid(const Scene& scene);
  /// From 0 to below `count`.
  std::size_t below(std::size_t count);
  bool oneIn(std::size_t count) { return below(count) == 0; }

 private:
  double number(double low, double high);
  glm::dvec3 vector(double low, double high);
  glm::vec3 color();
  Box box();
  const std::string& of(const std::vector<std::string>& list) { return list[below(list.size())]; }
  std::string name();
  void changeProbe(Probe& probe);
  void changeTechnique(Probe& probe);
  void changeCapture(Probe& probe);
  void changeList(Scene& scene);
  void changeSurroundings(Scene& scene);

  std::mt19937 random_;
  EditLimits limits_;
};

}  // namespace boxprobe::test
