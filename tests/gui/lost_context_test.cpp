// A graphics driver that is reset while the window is open. The program stands between Qt and GLX: it says that resets
// are told, and tells one when a test asks for it. The context itself stays, so what is drawn after it is ordinary.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QStandardPaths>
#include <QTest>
#include <cstring>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/view/viewport.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/recovery.h"
#include "tests/gui/dialogs.h"
#include "tests/gui/window_test.h"

namespace {

bool driverReset = false;
int asked = 0;

void* real(const char* name) {
  static void* library = dlopen("libGLX.so.0", RTLD_LAZY);
  return library != nullptr ? dlsym(library, name) : nullptr;
}

unsigned resetStatus() {
  ++asked;
  constexpr unsigned kInnocentContextReset = 0x8254;
  return driverReset ? kInnocentContextReset : 0;
}

// Without the attribute that the driver does not know.
void* createContext(void* display, void* config, void* share, int direct, const int* attributes) {
  constexpr int kResetNotification = 0x8256;
  std::vector<int> known;
  for (const int* at = attributes; at != nullptr && *at != 0; at += 2) {
    if (*at != kResetNotification) known.insert(known.end(), {at[0], at[1]});
  }
  known.push_back(0);
  const auto create = reinterpret_cast<void* (*)(void*, void*, void*, int, const int*)>(
      reinterpret_cast<void* (*)(const char*)>(real("glXGetProcAddressARB"))("glXCreateContextAttribsARB"));
  return create(display, config, share, direct, known.data());
}

}  // namespace

extern "C" {

const char* glXQueryExtensionsString(void* display, int screen) {
  static std::string text;
  text = reinterpret_cast<const char* (*)(void*, int)>(real("glXQueryExtensionsString"))(display, screen);
  text += " GLX_ARB_create_context_robustness";
  return text.c_str();
}

void* glXGetProcAddressARB(const char* name) {
  if (std::strcmp(name, "glGetGraphicsResetStatusARB") == 0) return reinterpret_cast<void*>(resetStatus);
  if (std::strcmp(name, "glXCreateContextAttribsARB") == 0) return reinterpret_cast<void*>(createContext);
  return reinterpret_cast<void* (*)(const char*)>(real("glXGetProcAddressARB"))(name);
}

void* glXGetProcAddress(const char* name) {
  return glXGetProcAddressARB(name);
}

}  // extern "C"

namespace boxprobe {
namespace {

QStringList keptFolders() {
  const QDir all(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved");
  return all.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

class LostContextTest : public WindowTest {};

TEST_F(LostContextTest, ChangesAreKeptAndAStartIsOffered) {
  waitUntilIdle();
  ASSERT_GT(asked, 0) << "Qt asks for resets";
  int told = 0;
  const QMetaObject::Connection counted =
      QObject::connect(&window_->viewport(), &Viewport::contextLost, [&told] { ++told; });
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 2.75; });
  waitUntilIdle();
  EXPECT_EQ(told, 0);
  EXPECT_TRUE(window_->viewport().readyToDraw());

  driverReset = true;
  window_->viewport().update();
  ASSERT_TRUE(QTest::qWaitFor([&] { return told > 0; }, 10000));
  EXPECT_FALSE(window_->viewport().readyToDraw());

  const auto later = answerMessageBox(QString("Not now"));
  EXPECT_FALSE(offerRestart(*window_));
  EXPECT_TRUE(later->text.contains("was reset")) << later->text.toStdString();
  EXPECT_EQ(keptFolders().size(), 1);
  // Edits go on, and are kept as well; no picture is asked for.
  window_->editor().commitProbe("Set box", [](Probe& edited) { edited.box.max.x = 2.5; });
  QTest::qWait(200);
  EXPECT_TRUE(window_->autosave().write());
  EXPECT_EQ(told, 1) << "once";

  const auto again = answerMessageBox(QString("Start again"));
  EXPECT_TRUE(offerRestart(*window_));
  EXPECT_EQ(again->text, later->text);
  EXPECT_EQ(keptFolders().size(), 1);
  EXPECT_EQ(probe().box.max.x, 2.5);
  // As the window does at its end: the next process finds them.
  window_->autosave().end();
  EXPECT_EQ(Autosave::leftBehind().size(), 1u);
  QObject::disconnect(counted);
  static_cast<void>(sharedWindow().release());  // Qt crashes where it destroys what a lost context had
}

}  // namespace
}  // namespace boxprobe
