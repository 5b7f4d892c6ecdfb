// Values that a surface's program reads and that stay the same between edits: a probe's box, its diffuse light, a
// technique's parameters, a material's roughness. They are uniforms or, in a specialized program, constants of its
// source.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace boxprobe {

/// Receives the values of a draw, one uniform or array after another (draw_numbers.h), to upload, keep or compare them
/// without allocating.
class NumberReader {
 public:
  virtual ~NumberReader() = default;
  /// `name` as declared in the shader; `values`: `count` elements of `components` floats each: 1, 2 or 3 for numbers
  /// and vectors, 9 for a matrix in column-major order.
  virtual void read(const char* name, int components, const float* values, std::size_t count) = 0;

  void read(const char* name, float value) { read(name, 1, &value, 1); }
  void read(const char* name, const glm::vec3& value) { read(name, 3, &value.x, 1); }
};

/// One uniform, or an array of uniforms.
struct Constant {
  std::string name;
  int components{1};
  std::vector<float> values;
  bool operator==(const Constant& o) const {
    return name == o.name && components == o.components && values == o.values;
  }
};

/// Keeps what it reads, except for non-finite values, which have no literals in GLSL and stay uniforms.
class Constants : public NumberReader {
 public:
  using NumberReader::read;
  void read(const char* name, int components, const float* values, std::size_t count) override;

  const std::vector<Constant>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  /// Null if there is none of that name.
  const Constant* find(const char* name) const;
  /// The constants that are in both with equal values.
  Constants sharedWith(const Constants& other) const;
  /// Equal texts mean equal names and values.
  std::string key() const;
  /// A rough estimate of what a program saves by knowing them; diffuse light and roughness count most.
  int worth() const;

 private:
  std::vector<Constant> all_;
};

/// Checks whether a draw's values equal these constants.
class ConstantsCheck : public NumberReader {
 public:
  /// `constants` must outlive this object.
  explicit ConstantsCheck(const Constants& constants) : constants_(constants) {}
  using NumberReader::read;
  void read(const char* name, int components, const float* values, std::size_t count) override;
  /// Was every constant read with an equal value?
  bool hold() const { return same_ == constants_.all().size(); }

 private:
  const Constants& constants_;
  std::size_t same_ = 0;
};

/// Replaces the declarations of these uniforms in `text` by constants. Returns how many were found.
int writeConstants(std::string& text, const Constants& constants);

/// What the program of one object is specialized for.
struct ConstantsPlan {
  std::string variant;  ///< of its binding (ProbeBinding::variantKey)
  Constants values;
};

/// One object: its program without constants (equal strings share one), and the values it is drawn with.
struct ConstantUse {
  std::string program;
  Constants values;
};

/// The constants for each object's program, in the order of `uses`, chosen to keep programs few. Values that all
/// objects of a program share need no further program; a value in which many differ stays a uniform. Objects of one
/// program with the same pointer share the specialized program. Up to `more` programs are added where most objects gain
/// most. O(n log n) in the number of objects.
std::vector<std::shared_ptr<const Constants>> planConstants(const std::vector<ConstantUse>& uses, std::size_t more);

}  // namespace boxprobe
