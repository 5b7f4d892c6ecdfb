// The techniques as data: one row and one shader file each. Combo box, command line, file validation, tests and
// benchmark iterate these rows; nothing else refers to a technique by name. A technique is PROJECTION+EVALUATION: where
// the reflected ray hits, and how the lobe around it is sampled.
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
  std::vector<std::string_view> sharedFiles = {};  ///< further files it needs, in order of dependence
  std::vector<std::string_view> parameters = {};   ///< names of the rows of parameterRows() it reads
  bool distances = false;                          ///< samples the probe's distance cubemap
  bool ours = false;                               ///< this project's own; false: as published elsewhere
};

/// The mip levels that an evaluation samples for a surface of one roughness.
enum class LevelReach {
  Any,      ///< unknown: the whole chain
  Own,      ///< only that of its roughness (levelForCurve)
  UpToOwn,  ///< from 0 to that of its roughness
};

struct EvaluationRow {
  std::string_view id;
  std::string_view label;
  std::string_view help;
  std::string_view shaderFile;  ///< for `auto`, which chooses among the others, the C++ file that does
  std::string_view function;    ///< GLSL: vec4 function(PROBE_MAP, ProbeShape, ShadingPoint); empty: no GLSL of its own
  glm::vec4 (*evaluate)(shading::ProbeMap, shading::ProbeShape, shading::ShadingPoint);
  std::vector<std::string_view> sharedFiles;  ///< further files it needs, in order of dependence
  std::vector<std::string_view> parameters;   ///< names of the rows of parameterRows() it reads
  bool ours = false;                          ///< this project's own; false: as published elsewhere
  /// Id of the row that may be drawn in its place while the camera or a handle moves: cheap, and as similar as cheap
  /// rows are, so that the picture changes little when it comes to rest. Empty: it is cheap itself.
  std::string_view standIn = {};
  LevelReach levels = LevelReach::Any;  ///< no others need filtering
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
/// The same evaluation with the bare reflection vector: "projection off".
Technique withoutProjection(Technique technique);
/// The same projection with a cheap evaluation; the technique itself if its row names none.
Technique standInFor(Technique technique);
/// Does it sample parts of its lobe separately, at their hits on the box? Then each part can see through an opening by
/// itself.
bool looksUpPieces(Technique technique);
/// The parameters it reads, in the order in which forms show them.
std::vector<const ParameterRow*> parametersOf(Technique technique);
/// Does it read the parameter of that name, and is that set to `choice`?
bool chooses(Technique technique, const shading::TechniqueParameters& values, std::string_view parameter,
             std::string_view choice);
/// The full id, `box+none`; `auto` stands alone.
std::string techniqueId(const Technique& technique);
/// The shortest id that parses back: `box` for `box+none`.
std::string shortTechniqueId(const Technique& technique);
/// All ids that a file may contain, comma separated, for error messages.
std::string techniqueIdList();

}  // namespace boxprobe
