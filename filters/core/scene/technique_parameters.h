// The parameters a scene gives a probe's technique: checked against the table's rows, and turned into what the
// mathematics reads. Used by validation (core) and by the window's panel; knows nothing of what a technique does with
// them.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

/// Empty if `value` suits the parameter of that name; else what is wrong, as a phrase to follow the key path.
std::string parameterProblem(const std::string& name, const ParameterValue& value);

/// What `row` is for this probe: what the scene says, else the default; of a choice its index, of a switch 0 or 1.
double parameterNumber(const Probe& probe, const ParameterRow& row);
/// Sets it; the default is not written down, so that scenes hold what differs.
void setParameter(Probe& probe, const ParameterRow& row, double number);

shading::TechniqueParameters techniqueParameters(const Probe& probe);

}  // namespace boxprobe
