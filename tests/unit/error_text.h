// The one line an operation fails with, for tests of messages: every one must be a single line and of the right family.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "filters/core/base/errors.h"

namespace boxprobe {

/// what() of the `Expected` that `operation` throws; fails the test, and returns "", for any other outcome.
template <typename Expected = InputError, typename Operation>
std::string errorText(Operation operation) {
  try {
    operation();
  } catch (const Expected& error) {
    std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << "more than one line: " << text;
    return text;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of exception: " << error.what();
    return "";
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

}  // namespace boxprobe
