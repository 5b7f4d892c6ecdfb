// Guesses whether a model file has another unit or up axis than assumed. Only glTF defines them, and some glTF files
// are wrong.
#pragma once

#include <optional>
#include <string>

#include "filters/fit/model_kind.h"

namespace boxprobe {

/// The likely unit and up axis of a file.
struct ImportGuess {
  LengthUnit unit = LengthUnit::Metre;
  UpAxis upAxis = UpAxis::Y;
  Phrase reason;  ///< one or two clauses: "In metres it would be 940 m wide, and it seems to lie on its side"
};

/// The unit in which `largest`, the longest side in metres as read, is plausible for a model of this kind; the
/// extension of `file` tells what kind of program wrote it.
LengthUnit likelyUnit(const std::string& file, ModelKind kind, double largest);

/// Nothing if the model is not too large and stands upright, or if the scene already sets unit or up axis. `bounds`: of
/// everything, in the world, as read. Considers the first model only.
std::optional<ImportGuess> guessImport(const Scene& scene, const TriangleRays::Models& models, ModelKind kind,
                                       const Box& bounds);

/// "940 m wide"; two digits.
Phrase extentText(const Box& bounds);

}  // namespace boxprobe
