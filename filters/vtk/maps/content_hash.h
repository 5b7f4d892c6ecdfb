// A 128-bit fingerprint of values: equal for equal contents in every run and on every machine. Uses XXH3 (libxxhash):
// its output is specified, and it hashes at memory speed, because a scene's geometry and textures are hashed at each
// opening. A cryptographic hash is not needed, since nobody gains by forging a probe.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct XXH3_state_s;

namespace boxprobe {

class ContentHash {
 public:
  ContentHash();

  ContentHash& addBytes(const void* data, std::size_t size);
  /// -0 counts as 0, because both draw the same picture.
  ContentHash& add(double value);
  ContentHash& add(std::string_view text);
  template <typename Vector>
  ContentHash& addVector(const Vector& v) {
    return add(static_cast<double>(v.x)).add(static_cast<double>(v.y)).add(static_cast<double>(v.z));
  }
  template <typename T>
  ContentHash& addArray(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(static_cast<double>(values.size()));
    return addBytes(values.data(), values.size() * sizeof(T));
  }

  /// 32 hexadecimal digits.
  std::string text() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace boxprobe
