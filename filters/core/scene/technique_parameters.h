// The parameters that a scene gives a probe's technique: checked against the table's rows and converted to what the
// shaders read.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

/// Empty if `value` is valid for the parameter of that name; else what is wrong, as a phrase to follow the key path.
std::string parameterProblem(const std::string& name, const ParameterValue& value);

/// The value of `row` for this probe, or its default; for a choice its index, for a switch 0 or 1.
double parameterNumber(const Probe& probe, const ParameterRow& row);
/// Sets the parameter; a default value is removed instead, so that scenes hold only differences.
void setParameter(Probe& probe, const ParameterRow& row, double number);

shading::TechniqueParameters techniqueParameters(const Probe& probe);

}  // namespace boxprobe
