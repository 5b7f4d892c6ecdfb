// Is a model file likely in another unit, or with another axis up, than it was read with? Formats but glTF say neither,
// and programs write glTF files wrongly, too. Called where a bare model is fitted; proposes, changes nothing.
#pragma once

#include <optional>
#include <string>

#include "filters/fit/model_kind.h"

namespace boxprobe {

struct ImportGuess {
  LengthUnit unit = LengthUnit::Metre;
  UpAxis upAxis = UpAxis::Y;
  std::string reason;  ///< a clause or two: "it would be 940 m wide"
};

/// Nothing where size and stand are plausible, or where the scene already says how the file is to be read. `bounds`:
/// of everything, in the world, as the file was read. Only the first model is asked about.
std::optional<ImportGuess> guessImport(const Scene& scene, const TriangleRays::Models& models, ModelKind kind,
                                       const Box& bounds);

/// "940 m wide"; two digits.
std::string extentText(const Box& bounds);

}  // namespace boxprobe
