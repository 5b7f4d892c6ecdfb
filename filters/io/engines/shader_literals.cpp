#include "filters/io/engines/shader_literals.h"

#include "filters/core/base/number_text.h"

namespace boxprobe {

std::string shaderNumber(double value) {
  std::string result = numberText(static_cast<float>(value));
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return result + "f";
}

std::string shaderVector(const glm::dvec3& v) {
  return "vec3(" + shaderNumber(v.x) + ", " + shaderNumber(v.y) + ", " + shaderNumber(v.z) + ")";
}

}  // namespace boxprobe
