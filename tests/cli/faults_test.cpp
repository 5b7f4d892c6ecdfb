// What comes from outside: full disks, closed pipes, links, names of any bytes, other locales, too many of everything.
// The commands here draw nothing and need no display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

/// A shell command line, `boxprobe` being the program; what it prints on stderr is in `out`, too, if it says 2>&1.
Outcome shell(const std::string& line) {
  Outcome outcome;
  const std::string whole = "boxprobe() { '" BOXPROBE_PROGRAM "' \"$@\"; }; " + line;
  std::FILE* pipe = popen(("exec bash -c '" +
                           [&] {
                             std::string quoted;
                             for (const char c : whole) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
                             return quoted;
                           }() +
                           "'")
                              .c_str(),
                          "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start a shell");
  char bytes[4096];
  for (std::size_t count; (count = std::fread(bytes, 1, sizeof bytes, pipe)) > 0;) outcome.out.append(bytes, count);
  const int status = pclose(pipe);
  outcome.exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

class Faults : public ::testing::Test {
 protected:
  std::string triangleObj(const std::string& name, const std::string& material) const {
    return folder.write(name, "mtllib m.mtl\nusemtl " + material + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  /// `count` entries of a scene's list or map, each `entry` with its number in the place of %.
  std::string sceneOfMany(const std::string& key, const std::string& entry, int count, const char* brackets) const {
    folder.write("m.gltf", triangleGltf());
    std::string text =
        R"({"format": "boxprobe-scene", "version": 1, "model": "m.gltf", ")" + key + "\": " + brackets[0];
    for (int i = 0; i < count; ++i) {
      std::string one = entry;
      one.replace(one.find('%'), 1, std::to_string(i));
      text += (i > 0 ? "," : "") + one;
    }
    return folder.write("many.boxprobe.json", text + brackets[1] + "}");
  }

  TemporaryFolder folder;
};

TEST_F(Faults, AFullOrClosedStandardOutputIsAFailure) {
  for (const char* command : {"info --fields", "--help", "--version", "lessons", "lessons --json",
                              "stress --count 1000 --quiet", "info " BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json"}) {
    const Outcome full = shell(std::string("boxprobe ") + command + " 2>&1 >/dev/full");
    EXPECT_EQ(full.exitStatus, 1) << command;
    EXPECT_THAT(full.out, HasSubstr("standard output: not all could be written")) << command;
  }
  // The program starts once the reader has closed its end and says so.
  const Outcome closed = shell("cd '" + folder.path("") +
                               "'; mkfifo closed; { read -r _ <closed; boxprobe info --fields 2>/dev/null; } | "
                               "{ exec <&-; echo now >closed; }; echo status ${PIPESTATUS[0]}");
  EXPECT_THAT(closed.out, HasSubstr("status 1"));
}

TEST_F(Faults, AnOutputThatIsAnInputIsRefused) {
  folder.write("m.gltf", triangleGltf());
  const std::string scene =
      folder.write("s.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1, "model": "m.gltf"})");
  const std::string before = readFile(scene);
  std::filesystem::create_symlink("s.boxprobe.json", folder.path("soft.png"));
  std::filesystem::create_hard_link(folder.path("m.gltf"), folder.path("hard.png"));
  const auto expectRefused = [&](const std::vector<std::string>& arguments, const std::string& output) {
    const Outcome outcome = runProgram(arguments, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(output + ": this is the input "));
  };
  expectRefused({"render", scene, "-o", folder.path("soft.png")}, "-o " + folder.path("soft.png"));
  expectRefused({"render", scene, "-o", folder.path("hard.png")}, "-o " + folder.path("hard.png"));
  expectRefused({"info", scene, "--stats", scene}, "--stats " + scene);
  expectRefused({"explain", scene, "--pixel", "1,1", "--stats", folder.path("m.gltf")},
                "--stats " + folder.path("m.gltf"));
  EXPECT_EQ(readFile(scene), before);
  EXPECT_EQ(readFile(folder.path("m.gltf")), triangleGltf());
}

TEST_F(Faults, AFileSizeLimitIsAnError) {
  const std::string scene = demoScene("room");
  const Outcome outcome =
      shell("cd " + folder.path("") + "; ulimit -f 0; boxprobe info " + scene + " --stats s.json 2>&1 >/dev/null");
  EXPECT_EQ(outcome.exitStatus, 1) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("File too large"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST_F(Faults, NamesOfAnyBytesAreValidJsonAndSafeOnATerminal) {
  const std::string latin = "caf\xe9", nasty =
                                           "a\x1b]0;title\x07"
                                           "b\xc2\x9b"
                                           "31m";
  folder.write("m.mtl", "newmtl " + latin + "\nnewmtl " + nasty + "\n");
  for (const std::string& name : {latin, nasty, std::string("\xd7\x97\xd7\x93\xd7\xa8")}) {
    const std::string model = triangleObj(name + ".obj", name);
    const Outcome json = runProgram({"info", model, "--json"}, DisplayKind::Unset);
    EXPECT_EQ(json.exitStatus, 0) << json.err;
    EXPECT_TRUE(nlohmann::json::accept(json.out)) << json.out;
    const Outcome text = runProgram({"info", model}, DisplayKind::Unset);
    EXPECT_EQ(text.exitStatus, 0) << text.err;
    for (const std::string& bad : {std::string("\x1b"), std::string("\x07"), std::string("\xc2\x9b"), latin}) {
      EXPECT_THAT(text.out, Not(HasSubstr(bad)));
    }
    EXPECT_EQ(text.out.find(name) != std::string::npos, name[0] == '\xd7') << "letters stay";
  }
  folder.write("a.lesson.json", "{\"format\": \"boxprobe-lesson\", \"version\": 1, \"title\": \"" + latin + "\"}");
  std::filesystem::copy(BOXPROBE_DATA_DIR "/lessons/01-black-mirror.lesson.json", folder.path("b.lesson.json"));
  const Outcome lessons = runProgram({"lessons", "--folder", folder.path(""), "--json"}, DisplayKind::Unset);
  EXPECT_EQ(lessons.exitStatus, 0) << lessons.err;
  EXPECT_TRUE(nlohmann::json::accept(lessons.out)) << lessons.out;
}

TEST_F(Faults, AMissingMaterialFileBesideABareNameIsMissing) {
  triangleObj("m.obj", "x");
  const Outcome outcome = shell("cd " + folder.path("") + "; boxprobe info m.obj");
  EXPECT_EQ(outcome.exitStatus, 0);
  EXPECT_THAT(outcome.out, HasSubstr("has the material file m.mtl, which does not exist"));
}

TEST_F(Faults, AZeroByteInAUriIsNamedWhole) {
  std::string gltf = triangleGltf();
  const std::size_t uri = gltf.find("data:"), end = gltf.find('"', uri);
  const std::string model = folder.write("m.gltf", gltf.replace(uri, end - uri, "a%00b.bin"));
  const Outcome outcome = runProgram({"info", model}, DisplayKind::Unset);
  EXPECT_EQ(outcome.exitStatus, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a%00b.bin: does not exist"));
}

TEST_F(Faults, TooManyOfAnythingIsSaidAtOnce) {
  const auto expectRefusal = [&](const std::string& scene, const std::string& key) {
    const Outcome outcome = runProgram({"info", scene}, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(key + ": has more than 10000 entries"));
  };
  const std::string camera = R"("c%": {"position": [0, 1, 2], "target": [0, 0, 0]})";
  expectRefusal(sceneOfMany("cameras", camera, 100000, "{}"), "cameras");
  expectRefusal(sceneOfMany("materials", R"("m%": {"roughness": 0.5})", 100000, "{}"), "materials");
  expectRefusal(sceneOfMany("lights", R"({"type": "point", "position": [0, %, 0]})", 100000, "[]"), "lights");
  EXPECT_EQ(runProgram({"info", sceneOfMany("cameras", camera, 5000, "{}")}, DisplayKind::Unset).exitStatus, 0);
}

// The surroundings change no number: a decimal comma, another time zone, a folder whose name is not UTF-8.
TEST_F(Faults, ExtentsAreCheckedAfterAllTransforms) {
  folder.write("far.obj", "v 0 0 0\nv 1e18 0 0\nv 0 1e18 0\nv 0 0 1e18\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 3 4\n");
  const std::string room = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb";
  const std::string start = R"({"format": "boxprobe-scene", "version": 1, "cameras": {"m": {}}, )";
  folder.write("scaled.boxprobe.json", start + R"("model": {"file": ")" + room + R"(", "scale": 9.9e17}})");
  folder.write("moved.boxprobe.json",
               start + R"("model": ")" + room + R"(", "objects": {"sphere 1": {"translation": [3, -7e17, 11]}}})");
  const std::pair<const char*, const char*> cases[] = {{"far.obj", "reaches to 1e+18"},
                                                       {"scaled.boxprobe.json", "reaches to 3.96e+18"},
                                                       {"moved.boxprobe.json", "reaches to 7e+17"}};
  for (const auto& [file, reach] : cases) {
    for (const std::string command : {"info", "fit", "place", "render"}) {
      SCOPED_TRACE(command + " " + file);
      std::vector<std::string> arguments = {command, folder.path(file)};
      if (command == "render") arguments.insert(arguments.end(), {"-o", folder.path("o.png"), "--size", "16x9"});
      const Outcome outcome = runProgram(arguments);
      EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
      EXPECT_THAT(outcome.errLines(), SizeIs(1)) << outcome.err;
      EXPECT_THAT(outcome.err, AllOf(HasSubstr(reach), HasSubstr("1e+15")));
    }
  }
}

TEST_F(Faults, ExtremeScenesAreCarriedOrRefused) {
  const Outcome outcome = runProgram({"stress", "--class", "extreme-scenes", "--count", "200", "--seed", "7"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr(R"("class":"extreme-scenes")"), HasSubstr(R"("count":200,)"),
                                 HasSubstr(R"("nonFinite":0)")));
}

TEST_F(Faults, FilesBesideTheOutputStay) {
  for (const char* name : {".o.2024-11.png", ".o.7-1.png"}) folder.write(name, "mine");
  const Outcome outcome = runProgram({"render", demoScene("room"), "-o", folder.path("o.png"), "--size", "16x9"});
  EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(folder.names(), UnorderedElementsAre(".o.2024-11.png", ".o.7-1.png", "o.png"));
}

TEST_F(Faults, LocaleTimeZoneAndFolderChangeNothing) {
  const std::string odd = folder.path("caf\xe9 \xd7\x97\xd7\x93\xd7\xa8");
  std::filesystem::create_directories(odd);
  for (const char* name : {"room.boxprobe.json", "room.glb"}) {
    std::filesystem::copy(std::string(BOXPROBE_DATA_DIR "/scenes/") + name, odd + "/" + name);
  }
  const std::string command = "cd " BOXPROBE_DATA_DIR
                              "/scenes; boxprobe info room.boxprobe.json; "
                              "boxprobe stress --count 2000 --quiet";
  const Outcome plain = shell("export LC_ALL=C TZ=UTC; " + command);
  ASSERT_EQ(plain.exitStatus, 0);
  // LOCPATH: made here, so that the system needs no such locale.
  const Outcome made = shell("localedef -i de_DE -f UTF-8 '" + folder.path("de_DE.UTF-8") + "' 2>&1");
  const std::string locale =
      made.exitStatus == 0 ? "export LOCPATH='" + folder.path("") + "'; export LC_ALL=de_DE.UTF-8; " : "";
  EXPECT_EQ(shell(locale + "export TZ=Asia/Kathmandu; " + command).out, plain.out);
  const Outcome moved =
      shell("cd '" + odd + "'; boxprobe info room.boxprobe.json; boxprobe stress --count 2000 --quiet");
  EXPECT_EQ(moved.out, plain.out);
  const Outcome whole = shell("boxprobe info '" + odd + "/room.boxprobe.json' --json");
  EXPECT_EQ(whole.exitStatus, 0);
  EXPECT_TRUE(nlohmann::json::accept(whole.out)) << whole.out;
}

}  // namespace
}  // namespace boxprobe::test
