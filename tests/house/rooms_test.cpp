// The order of the rooms holds, no two files include each other in a circle, VTK, Qt and message boxes stay where they
// belong; and the checks notice when that is broken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "tests/house/include_graph.h"

namespace {

using namespace boxprobe::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kRoot = BOXPROBE_SOURCE_DIR;

TEST(House, FilesIncludeOnlyTheirOwnRoomAndThoseAbove) {
  EXPECT_THAT(breaches(readRooms(kRoot), includeLines(kRoot)), IsEmpty());
}

TEST(House, NoUnitIncludesItselfThroughOthers) {
  EXPECT_THAT(circles(includeLines(kRoot)), IsEmpty());
}

TEST(House, ABreachIsNamedWithItsFileAndLine) {
  const Rooms rooms = readRooms(kRoot);
  EXPECT_THAT(breaches(rooms, {{"filters/core/scene/scene.h", 7, "filters/vtk/gl/gl_objects.h"}}),
              ElementsAre(HasSubstr("filters/core/scene/scene.h:7: filters/core/scene must not include")));
  EXPECT_THAT(breaches(rooms, {{"filters/reference/light/a.cpp", 3, "filters/explain/explanation.h"}}),
              ElementsAre(HasSubstr("filters/reference and filters/explain must not include each other")));
  EXPECT_THAT(breaches(rooms, {{"app/attic/a.cpp", 1, "filters/core/base/errors.h"}}),
              ElementsAre(HasSubstr("no room app/attic")));
}

TEST(House, ACircleIsNamed) {
  EXPECT_THAT(circles({{"app/a.h", 1, "app/b.h"}, {"app/b.cpp", 1, "app/c.h"}, {"app/c.h", 1, "app/a.h"}}),
              ElementsAre("app/a -> app/b -> app/c -> app/a"));
}

// askUser(), warnUser() and PlainQuestion show text as it is; QMessageBox by itself takes a file's name for HTML.
TEST(House, MessageBoxesAreMadeInOnePlace) {
  for (const SourceFile& file : sourceFiles(kRoot)) {
    if (file.path.rfind("app/gui/widgets/message_box", 0) == 0) continue;
    std::ifstream stream(std::string(kRoot) + "/" + file.path);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    for (const char* made : {"QMessageBox::question(", "QMessageBox::warning(", "QMessageBox::information(",
                             "QMessageBox::critical(", "QMessageBox::about("}) {
      EXPECT_EQ(text.find(made), std::string::npos) << file.path << " calls " << made << ")";
    }
    const bool own = text.find("QMessageBox box(") != std::string::npos;
    EXPECT_TRUE(!own || text.find("setTextFormat(") != std::string::npos) << file.path << ": say which text it shows";
  }
}

/// The type that a line begins to define; empty: none.
std::string definedType(const std::string& line) {
  static const std::regex type(
      R"rx(^(?:struct|class|enum class|enum|union) (?:\w+_EXPORT )?(\w+)(?: final)?(?: :[^;]*)?(?: \{.*)?$)rx");
  std::smatch match;
  return std::regex_match(line, match, type) ? match[1].str() : "";
}

// Two types of one name share their constructors, whichever the linker finds first: memory is overwritten.
TEST(House, NoTwoHeadersDefineATypeOfOneName) {
  EXPECT_EQ(definedType("class BOXPROBE_EXPORT Editor final : public QObject {"), "Editor");
  EXPECT_EQ(definedType("struct Place { int x = 0; };"), "Place");
  EXPECT_EQ(definedType("class Editor;"), "");
  std::map<std::string, std::string> known;
  for (const SourceFile& file : sourceFiles(kRoot)) {
    if (file.path.substr(file.path.size() - 2) != ".h") continue;
    std::ifstream stream(kRoot + "/" + file.path);
    std::vector<std::string> within;
    for (std::string line; std::getline(stream, line);) {
      if (line.rfind("namespace ", 0) == 0) within.push_back(line.substr(10, line.find(' ', 10) - 10));
      if (line.rfind("}  // namespace", 0) == 0) within.pop_back();
      const std::string type = definedType(line);
      if (type.empty()) continue;
      std::string name;
      for (const std::string& space : within) name += space + "::";
      name += type;
      const auto [other, first] = known.emplace(name, file.path);
      EXPECT_TRUE(first) << name << " is defined in " << other->second << " and in " << file.path;
    }
  }
  EXPECT_GT(known.size(), 500u);
}

TEST(House, EveryRoomHasFilesAndEveryFileARoom) {
  const Rooms rooms = readRooms(kRoot);
  std::set<std::string> used;
  for (const SourceFile& file : sourceFiles(kRoot)) {
    const std::string folder = folderOf(file.path);
    EXPECT_EQ(rooms.rank.count(folder), 1u) << file.path << ": filters/rooms.txt has no room " << folder;
    used.insert(folder);
  }
  for (const auto& [room, ignored] : rooms.rank) EXPECT_EQ(used.count(room), 1u) << room << " has no files";
}

TEST(House, QtAndVtkStayInTheirFolders) {
  for (const SourceFile& file : sourceFiles(kRoot)) {
    const bool gui = file.path.rfind("app/gui/", 0) == 0;
    const bool vtk = file.path.rfind("filters/vtk/", 0) == 0 || file.path.rfind("filters/stress_gpu/", 0) == 0 ||
                     file.path.rfind("app/", 0) == 0;
    for (const std::string& name : file.systemIncludes) {
      const bool qt = name.size() > 1 && name[0] == 'Q' && std::isupper(static_cast<unsigned char>(name[1])) != 0;
      EXPECT_TRUE(gui || !qt) << file.path << " includes <" << name << ">; Qt belongs in app/gui";
      EXPECT_TRUE(vtk || name.rfind("vtk", 0) != 0)
          << file.path << " includes <" << name << ">; VTK does not belong there";
    }
  }
}

/// Is it a header of an operating system or of its windows? (time.h and signal.h are the C library's; C++ has its own.)
bool isOfASystem(const std::string& header) {
  static const std::set<std::string> known = {"aclapi.h",  "direct.h",  "dirent.h",   "dlfcn.h",   "fcntl.h",
                                              "fnmatch.h", "io.h",      "malloc.h",   "poll.h",    "process.h",
                                              "psapi.h",   "pthread.h", "pwd.h",      "sched.h",   "shlobj.h",
                                              "signal.h",  "spawn.h",   "stdlib.h",   "termios.h", "time.h",
                                              "unistd.h",  "windows.h", "winsock2.h", "GL/glx.h",  "GL/wglext.h"};
  const std::string folder = header.substr(0, header.find('/') + 1);
  return known.count(header) > 0 || folder == "sys/" || folder == "X11/" || folder == "EGL/" || folder == "mach-o/" ||
         folder == "mach/" || folder == "linux/";
}

TEST(House, SystemsStayInTheirRoom) {
  EXPECT_TRUE(isOfASystem("sys/stat.h") && isOfASystem("windows.h") && isOfASystem("X11/Xlib.h"));
  EXPECT_FALSE(isOfASystem("csignal") || isOfASystem("vtkActor.h") || isOfASystem("string"));
  const std::set<std::string> drawing = {"app/session/display_check.cpp", "app/session/surfaceless_window.cpp"};
  int within = 0;
  for (const SourceFile& file : sourceFiles(kRoot)) {
    const bool platform = file.path.rfind("filters/platform/", 0) == 0;
    for (const std::string& name : file.systemIncludes) {
      if (!isOfASystem(name)) continue;
      const bool source = file.path.substr(file.path.size() - 4) == ".cpp";
      EXPECT_TRUE((platform && source) || drawing.count(file.path) > 0)
          << file.path << " includes <" << name << ">; systems belong in the .cpp files of filters/platform";
      ++within;
    }
  }
  EXPECT_GT(within, 20);  // include lines are still found
}

/// The lines between <!-- rooms --> and <!-- /rooms --> that name a room.
std::vector<std::string> quotedRooms(const std::string& readme) {
  std::ifstream in(std::filesystem::path(kRoot) / readme);
  std::vector<std::string> lines;
  bool within = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("<!-- /rooms -->") != std::string::npos) within = false;
    const std::size_t at = line.find_first_not_of(' ');
    if (within && at != std::string::npos && line[at] != '`') lines.push_back(line.substr(at));
    if (line.find("<!-- rooms -->") != std::string::npos) within = true;
  }
  return lines;
}

TEST(House, TheDocumentsShowTheOrderOfTheRooms) {
  for (const std::string top : {"filters", "app"}) {
    std::vector<std::string> expected;
    for (const std::string& line : readRooms(kRoot).lines) {
      if (line.rfind(top + "/", 0) == 0 || line.rfind(top + " ", 0) == 0) expected.push_back(line);
    }
    EXPECT_EQ(quotedRooms(top + "/README.md"), expected) << top << "/README.md quotes filters/rooms.txt";
  }
}

}  // namespace
