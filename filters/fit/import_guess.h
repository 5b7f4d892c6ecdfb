// Is a model file likely in another unit, or with another axis up, than it was read with? Formats but glTF say neither,
// and programs write glTF files wrongly, too. Called where a bare model is fitted; proposes, changes nothing.
#pragma once

#include <optional>
#include <string>

#include "filters/fit/model_kind.h"

namespace boxprobe {

/// How a file is likely meant.
struct ImportGuess {
  LengthUnit unit = LengthUnit::Metre;
  UpAxis upAxis = UpAxis::Y;
  std::string reason;  ///< a clause or two: "In metres it would be 940 m wide, and it seems to lie on its side"
};

/// The unit that makes `largest`, the longest side in metres as the file was read, plausible for what a model of this
/// kind shows; `file`'s extension says who writes such files.
LengthUnit likelyUnit(const std::string& file, ModelKind kind, double largest);

/// Nothing where the model is not too large and stands as it should, or where the scene already says how the file is to
/// be read. `bounds`: of everything, in the world, as the file was read. Only the first model is asked about.
std::optional<ImportGuess> guessImport(const Scene& scene, const TriangleRays::Models& models, ModelKind kind,
                                       const Box& bounds);

/// "940 m wide"; two digits.
std::string extentText(const Box& bounds);

}  // namespace boxprobe
