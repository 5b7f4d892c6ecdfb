// Reads model files into plain arrays. glTF and GLB go through tinygltf (whole core format, extensions as JSON), so
// that the same arrays feed VTK and the ray tracer.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/core/base/export.h"
#include "filters/core/scene/model.h"

namespace boxprobe {

/// Called now and then with the share that is done, 0 to 1; false stops the work.
using LoadProgress = std::function<bool(double)>;

/// Thrown when a LoadProgress said so.
class LoadCancelled : public WorkError {
 public:
  using WorkError::WorkError;
};

/// In which of its states a file is read.
struct ModelState {
  std::string variant;            ///< of KHR_materials_variants; empty: the file's own materials
  std::optional<double> seconds;  ///< of its animations; none: at rest
};

/// Throws InputError naming the file, what is wrong and where (accessor, node, image). Never reads outside the model's
/// folder.
BOXPROBE_EXPORT Model loadModelFile(const std::string& path, const LoadProgress& progress = {},
                                    const ModelState& state = {});

}  // namespace boxprobe
