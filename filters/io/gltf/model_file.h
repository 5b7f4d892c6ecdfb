// Reads model files into plain arrays, which feed both VTK and the ray tracer. glTF and GLB go through tinygltf (the
// core format; extensions as JSON).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/core/base/export.h"
#include "filters/core/scene/model.h"

namespace boxprobe {

/// Called occasionally with the finished fraction, 0 to 1; returning false cancels the work.
using LoadProgress = std::function<bool(double)>;

/// Thrown when a LoadProgress returned false.
class LoadCancelled : public WorkError {
 public:
  using WorkError::WorkError;
};

/// Which of its states a file is read in.
struct ModelState {
  std::string variant;            ///< of KHR_materials_variants; empty: the file's default materials
  std::optional<double> seconds;  ///< time in its animations; none: the rest pose
};

/// Throws InputError with the file, what is wrong and where (accessor, node, image). Never reads outside the model's
/// folder.
BOXPROBE_EXPORT Model loadModelFile(const std::string& path, const LoadProgress& progress = {},
                                    const ModelState& state = {});

}  // namespace boxprobe
