// A model as lines of text, one for each value that is not the default, for tests that compare all of it with a file in
// tests/unit/values.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "tests/support/kept_values.h"

namespace boxprobe {

/// Paths in warnings are shortened by `folder`. Pictures are listed by their pixels. Of the first material the defaults
/// are listed, too, if `defaults` is set.
std::vector<std::string> modelLines(const Model& model, const std::string& folder, bool defaults = false);

/// What `operation` fails with, shortened by `folder`; else the lines of its model.
template <typename Operation>
std::vector<std::string> linesOrError(const Operation& operation, const std::string& folder);

/// The lines of `after` that `before` lacks, or, if there are none, those that it has no longer; of many the first.
std::string differenceOf(const std::vector<std::string>& before, const std::vector<std::string>& after);

/// Without the folder of the test, whose name is another one each time.
std::string withoutFolder(std::string text, const std::string& folder);

template <typename Operation>
std::vector<std::string> linesOrError(const Operation& operation, const std::string& folder) {
  try {
    return modelLines(operation(), folder);
  } catch (const std::exception& problem) {
    return {"! " + withoutFolder(problem.what(), folder)};
  }
}

}  // namespace boxprobe
