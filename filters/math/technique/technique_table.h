// The techniques as data: one row and one shader file each. Combo box, command line, file validation, tests and
// benchmark iterate these rows; nothing else in the program knows a technique by name.
// A technique is PROJECTION+EVALUATION: where the reflected ray hits, and how the lobe around it is looked up.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/parameter_table.h"

namespace boxprobe {

struct ProjectionRow {
  std::string_view id;
  std::string_view label;       ///< for a combo box
  std::string_view help;        ///< one line
  std::string_view shaderFile;  ///< in shaders/, defines `function`
  std::string_view function;  ///< GLSL: ProbeHit function(ProbeShape, vec3 positionProbe, vec3 normal, vec3 reflection)
  shading::ProbeHit (*project)(shading::ProbeShape, glm::vec3, glm::vec3, glm::vec3);  ///< the same, as C++
  std::vector<std::string_view> sharedFiles = {};  ///< further files it needs, in order
  std::vector<std::string_view> parameters = {};   ///< names of the rows of parameterRows() it reads
  bool distances = false;                          ///< it fetches from the probe's distance cubemap
  bool ours = false;                               ///< this project's own; false: as published elsewhere
};

/// Levels that an evaluation looks up for a surface of one roughness.
enum class LevelReach {
  Any,      ///< not known: all of the chain
  Own,      ///< that of its roughness (levelForCurve) alone
  UpToOwn,  ///< from 0 to that one
};

struct EvaluationRow {
  std::string_view id;
  std::string_view label;
  std::string_view help;
  std::string_view shaderFile;  ///< of `auto`, which chooses among the others, the C++ file that does
  std::string_view function;    ///< GLSL: vec4 function(PROBE_MAP, ProbeShape, ShadingPoint); empty: no GLSL of its own
  glm::vec4 (*evaluate)(shading::ProbeMap, shading::ProbeShape, shading::ShadingPoint);
  std::vector<std::string_view>
      sharedFiles;                           ///< further files it needs, in the order in which they build on each other
  std::vector<std::string_view> parameters;  ///< names of the rows of parameterRows() it reads
  bool ours = false;                         ///< this project's own; false: as published elsewhere
  /// Id of the row that may be drawn in its place while the camera or a handle moves: cheap, and as near to it as cheap
  /// rows come, so that little jumps when the picture comes to rest. Empty: it is cheap itself.
  std::string_view standIn = {};
  LevelReach levels = LevelReach::Any;  ///< the others need not be filtered
};

const std::vector<ProjectionRow>& projectionRows();
const std::vector<EvaluationRow>& evaluationRows();

/// Indices into the two tables.
struct Technique {
  int projection = 0;
  int evaluation = 0;
  bool operator==(const Technique& o) const { return projection == o.projection && evaluation == o.evaluation; }
};

/// `PROJECTION`, `EVALUATION` or `PROJECTION+EVALUATION`; a projection alone means `+none`, an evaluation alone `box+`.
std::optional<Technique> parseTechnique(std::string_view id);
/// The same evaluation looked up with the bare reflection vector: what "projection off" means.
Technique withoutProjection(Technique technique);
/// The same projection, cheaply evaluated; the technique itself where its row names no stand-in.
Technique standInFor(Technique technique);
/// Does it look up pieces of its lobe one by one where a box says they hit? Then each can look out of an opening by
/// itself.
bool looksUpPieces(Technique technique);
/// The parameters it reads, in the order of a form.
std::vector<const ParameterRow*> parametersOf(Technique technique);
/// Does it read the parameter of that name, set to that choice?
bool chooses(Technique technique, const shading::TechniqueParameters& values, std::string_view parameter,
             std::string_view choice);
/// The full id, `box+none`; `auto` stands alone.
std::string techniqueId(const Technique& technique);
/// The shortest id that parses back: `box` for `box+none`.
std::string shortTechniqueId(const Technique& technique);
/// Every id a file may hold, comma separated, for error messages.
std::string techniqueIdList();

}  // namespace boxprobe
