// Runs the window's tests under one QApplication, set up as the program's own.
#include <gtest/gtest.h>

#include <QStandardPaths>
#include <QTemporaryDir>

#include "app/gui/widgets/window_style.h"
#include "tests/gui/block_meter.h"
#include "tests/gui/window_test.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  qputenv("LC_ALL", "C.UTF-8");  // windows of programs started by tests are English, whatever the tester's language
  qunsetenv("LANGUAGE");
  boxprobe::setSurfaceFormat();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  // Compiled shaders are Mesa's to keep, for every program that draws the same.
  const QString kept = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
  if (!qEnvironmentVariableIsSet("MESA_SHADER_CACHE_DIR")) qputenv("MESA_SHADER_CACHE_DIR", kept.toUtf8());
  // Preferences of this run alone: several run at once. A test's own child shares them.
  QTemporaryDir own;
  if (qEnvironmentVariableIsSet("BOXPROBE_TEST_PREFERENCES")) own.remove();
  const QString folder = qEnvironmentVariable("BOXPROBE_TEST_PREFERENCES", own.path());
  for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) qputenv(place, folder.toUtf8());
  boxprobe::BlockMeter application(argc, argv);
  boxprobe::applyWindowStyle(application);
  const int result = RUN_ALL_TESTS();
  boxprobe::sharedWindow().reset();  // while there is an application
  return result;
}
