// What the lines of MTL files say. Sources: Ramey, Rose, Tyerman, "MTL material format" (Lightwave, OBJ spec., 1995);
// the extension for physically based materials (Exocortex, Clara.io: Pr, Pm, Ps, Pc, Pcr, aniso, anisor, norm).
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace boxprobe {

/// A picture and its options.
struct MtlMap {
  std::string name;                    ///< as it is written, without quotes
  std::string file;                    ///< the MTL file that names it
  glm::dvec2 offset{0.0}, scale{1.0};  ///< -o, -s: the picture is looked up at scale * (u, v) + offset, v upwards
  bool clamp = false;                  ///< -clamp on
  double base = 0.0, gain = 1.0;       ///< -mm: values become base + gain * value
  double bump = 1.0;                   ///< -bm
  char channel = '\0';                 ///< -imfchan: r, g, b, m (alpha), l or z; none: not given
};

/// Statements as they stand; colours linear.
struct MtlMaterial {
  std::string name;
  std::map<std::string, glm::dvec3> colors;  ///< by lower-case key: "kd", "ks", "ke", "tf", "ka"
  std::map<std::string, double> numbers;     ///< "ns", "d", "tr", "ni", "illum", "pr", "pm", "ps", "pc", "pcr", ...
  std::map<std::string, MtlMap> maps;        ///< "map_kd", "map_bump" (also of "bump"), "norm" ...

  const glm::dvec3* color(const char* key) const;
  std::optional<double> number(const char* key) const;
  const MtlMap* map(const char* key) const;
};

struct MtlFile {
  std::vector<MtlMaterial> materials;  ///< the first of each name
  std::vector<std::string> warnings;   ///< among them the keys that are left out
};

/// Reads one file; what is wrong in it becomes a warning. Throws InputError if the file itself cannot be read.
MtlFile readMtlFile(const std::string& path);

}  // namespace boxprobe
