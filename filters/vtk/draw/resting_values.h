// Numbers that a surface's program reads and that stay the same from frame to frame while nothing is edited: a probe's
// box, its diffuse light, a technique's parameters, a material's roughness. They are uniforms, or, in a program made
// for them, constants of its text. Plain data and text; knows neither OpenGL nor VTK.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace boxprobe {

/// One uniform, or an array of them.
struct RestingValue {
  std::string name;   ///< as the shader declares it
  int components{1};  ///< of an element: 1, 2 or 3 for numbers and vectors, 9 for a matrix, column by column
  std::vector<float> values;
  bool operator==(const RestingValue& o) const {
    return name == o.name && components == o.components && values == o.values;
  }
};

class RestingValues {
 public:
  void add(std::string name, float value) { add(std::move(name), 1, &value, 1); }
  void add(std::string name, const glm::vec3& value) { add(std::move(name), 3, &value.x, 1); }
  /// `values`: `count` elements of `components` floats each.
  void add(std::string name, int components, const float* values, std::size_t count);
  void add(const RestingValues& others) { all_.insert(all_.end(), others.all_.begin(), others.all_.end()); }

  const std::vector<RestingValue>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  void reserve(std::size_t count) { all_.reserve(count); }
  /// Null if there is none of that name.
  const RestingValue* find(const std::string& name) const;
  /// Does every one of `others` stand here with the same numbers?
  bool hold(const RestingValues& others) const;
  /// What stands in both with the same numbers.
  RestingValues sharedWith(const RestingValues& other) const;
  /// Equal texts: equal names and numbers.
  std::string key() const;
  /// Roughly what it spares to know them when a program is compiled; diffuse light and roughness most.
  int worth() const;

 private:
  std::vector<RestingValue> all_;
};

/// Turns the declarations of these uniforms, where `text` has them, into constants. Numbers that are not finite, which
/// GLSL has no words for, stay uniforms. Returns how many were found.
int foldConstants(std::string& text, const RestingValues& values);

/// What one object's program is made for.
struct ConstantsPlan {
  std::string variant;  ///< of its binding (ProbeBinding::variantKey)
  RestingValues values;
};

}  // namespace boxprobe
