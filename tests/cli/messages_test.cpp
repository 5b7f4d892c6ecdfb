// Messages stay one line each, whatever their texts hold and whoever reports.
#include "app/session/messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <string>

#include "app/session/vtk_messages.h"

namespace boxprobe::test {
namespace {

using ::testing::HasSubstr;

TEST(Messages, ControlCharactersBecomeSingleSpaces) {
  EXPECT_EQ(singleLine("a\n\n  b\tc\x1b[31m\r\n"), "a b c [31m");
  EXPECT_EQ(singleLine("Größe"), "Größe");
  EXPECT_EQ(singleLine(""), "");
}

TEST(Messages, AWarningIsPrintedOnce) {
  ::testing::internal::CaptureStderr();
  printWarnings({"one", "two", "one"});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "boxprobe: warning: one\nboxprobe: warning: two\n");
}

TEST(VtkMessages, ErrorsAndWarningsBecomeLines) {
  vtkNew<vtkObject> reporter;
  installVtkMessages(false, true);
  EXPECT_EQ(firstVtkError(), "");
  ::testing::internal::CaptureStderr();
  vtkWarningWithObjectMacro(reporter, "soft\nmatter");
  for (int i = 0; i < 2; ++i) vtkErrorWithObjectMacro(reporter, "hard\nmatter");
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_THAT(text, HasSubstr("boxprobe: warning: VTK: "));
  EXPECT_THAT(text, HasSubstr("soft matter\n"));
  EXPECT_THAT(text, HasSubstr("hard matter\n"));
  EXPECT_THAT(firstVtkError(), HasSubstr("hard matter"));
}

}  // namespace
}  // namespace boxprobe::test
