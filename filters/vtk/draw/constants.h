// Numbers that a surface's program reads and that stay the same from frame to frame while nothing is edited: a probe's
// box, its diffuse light, a technique's parameters, a material's roughness. They are uniforms, or, in a program made
// for them, constants of its text. Plain data and text; knows neither OpenGL nor VTK.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace boxprobe {

/// Is handed the numbers of a draw, one uniform or array after another, by whoever knows them (draw_numbers.h): to
/// upload them, to keep them, or to compare them, and nothing is put together for a draw.
class NumberReader {
 public:
  virtual ~NumberReader() = default;
  /// `name` as the shader declares it; `values`: `count` elements of `components` floats each: 1, 2 or 3 for numbers
  /// and vectors, 9 for a matrix, column by column.
  virtual void read(const char* name, int components, const float* values, std::size_t count) = 0;

  void read(const char* name, float value) { read(name, 1, &value, 1); }
  void read(const char* name, const glm::vec3& value) { read(name, 3, &value.x, 1); }
};

/// One uniform, or an array of them.
struct Constant {
  std::string name;
  int components{1};
  std::vector<float> values;
  bool operator==(const Constant& o) const {
    return name == o.name && components == o.components && values == o.values;
  }
};

/// Keeps what it reads, but for numbers that are not finite, which GLSL has no words for: they stay uniforms.
class Constants : public NumberReader {
 public:
  using NumberReader::read;
  void read(const char* name, int components, const float* values, std::size_t count) override;

  const std::vector<Constant>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  /// Null if there is none of that name.
  const Constant* find(const char* name) const;
  /// What stands in both with the same numbers.
  Constants sharedWith(const Constants& other) const;
  /// Equal texts: equal names and numbers.
  std::string key() const;
  /// Roughly what it spares to know them when a program is compiled; diffuse light and roughness most.
  int worth() const;

 private:
  std::vector<Constant> all_;
};

/// Finds out whether a draw's numbers are these constants.
class ConstantsCheck : public NumberReader {
 public:
  /// `constants` must outlive this.
  explicit ConstantsCheck(const Constants& constants) : constants_(constants) {}
  using NumberReader::read;
  void read(const char* name, int components, const float* values, std::size_t count) override;
  /// Was every one of them read, with the same numbers?
  bool hold() const { return same_ == constants_.all().size(); }

 private:
  const Constants& constants_;
  std::size_t same_ = 0;
};

/// Turns the declarations of these uniforms, where `text` has them, into constants. Returns how many were found.
int writeConstants(std::string& text, const Constants& constants);

/// What one object's program is made for.
struct ConstantsPlan {
  std::string variant;  ///< of its binding (ProbeBinding::variantKey)
  Constants values;
};

/// One object: its program without constants (equal strings share one), and the numbers it is drawn with.
struct ConstantUse {
  std::string program;
  Constants values;
};

/// For each object, in the order of `uses`, the numbers its program is made for, so that programs stay few: what all
/// objects of a program share costs no further one; many objects that differ by a number keep it as a uniform. Objects
/// of one program that share a pointer share the program that comes of it. Where most objects gain most, up to `more`
/// programs are added to those there are. O(n log n) in the number of objects.
std::vector<std::shared_ptr<const Constants>> planConstants(const std::vector<ConstantUse>& uses, std::size_t more);

}  // namespace boxprobe
