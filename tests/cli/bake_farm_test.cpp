// `boxprobe bake` by many processes: shares, bounces one at a time, what is left, merging, and the scripts for others.
// The files are those of one process, byte for byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/io/scene/scene_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A variable of the environment, for programs started while this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

class BakeFarm : public ::testing::Test {
 protected:
  /// The room with three probes that light each other.
  std::string writeScene(int bounces) const {
    Json scene = Json::parse(readFile(demoScene("room")));
    scene["model"] = std::string(BOXPROBE_DATA_DIR) + "/scenes/room.glb";
    Json probe = scene["probes"][0];
    probe["faceSize"] = 16;
    probe["bounces"] = bounces;
    // Open to a sky: a first capture of several has none of its light.
    scene["sky"]["color"] = {0.7, 0.9, 1.3};
    scene["probes"] = Json::array();
    for (const char* name : {"a", "b", "big"}) {
      probe["name"] = name;
      probe["origin"] = {-1.0 + static_cast<double>(scene["probes"].size()), 1.0, 0.5};
      scene["probes"].push_back(probe);
    }
    scene["probes"][2]["faceSize"] = 32;
    return folder_.write("room.boxprobe.json", scene.dump());
  }

  Outcome bake(const std::vector<std::string>& more, const std::string& out = "out") const {
    std::vector<std::string> arguments = {"bake", folder_.path("room.boxprobe.json"), "-o", folder_.path(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  }

  std::vector<std::string> files(const std::string& out) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path(out))) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  void expectSameFiles(const std::string& out, const std::string& other) const {
    ASSERT_EQ(files(out), files(other));
    for (const std::string& name : files(out)) {
      EXPECT_EQ(readFile(folder_.path(out + "/" + name)), readFile(folder_.path(other + "/" + name))) << name;
    }
  }

  std::vector<Json> list(const std::string& out = "out") const {
    const Outcome outcome = bake({"--list", "--json"}, out);
    EXPECT_EQ(outcome.exitStatus, 0) << outcome.err;
    std::vector<Json> rows;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) rows.push_back(Json::parse(line));
    return rows;
  }

  TemporaryFolder folder_;
};

TEST_F(BakeFarm, SharesMakeTheFilesOfOneProcess) {
  writeScene(1);
  ASSERT_EQ(bake({}, "whole").exitStatus, 0);
  EXPECT_THAT(list()[2]["state"], "missing");
  const Outcome first = bake({"--shard", "1/2"});
  EXPECT_EQ(first.exitStatus, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("1 baked probe(s) (share 1 of 2)"));  // the big one alone: it takes longest
  const std::vector<Json> rows = list();
  EXPECT_EQ(rows[0]["state"], "missing");
  EXPECT_EQ(rows[2]["state"], "done");
  EXPECT_GT(rows[2]["seconds"], rows[0]["seconds"]) << "estimated by its faces";

  const Outcome left = bake({"--check"});
  EXPECT_EQ(left.exitStatus, 3);
  EXPECT_THAT(left.err, HasSubstr("2 of 3 baked probe(s) not done: a, b"));
  EXPECT_EQ(bake({"--check", "--only", "b*g"}).exitStatus, 0);
  {
    // As mpiexec starts it.
    const Variable rank("OMPI_COMM_WORLD_RANK", "1"), size("OMPI_COMM_WORLD_SIZE", "2");
    EXPECT_THAT(bake({}).out, HasSubstr("2 baked probe(s) (share 2 of 2)"));
  }
  EXPECT_EQ(bake({"--check"}).exitStatus, 0);
  expectSameFiles("out", "whole");

  // A file of the name that shows something else.
  const Outcome stale = bake({"--list", "--set", "probes.a.faceSize=32"});
  EXPECT_THAT(stale.out, HasSubstr("stale    a\n"));
}

// What the nodes of all probes see lies in one texture: where a probe's share of it begins must not show in a bit.
TEST_F(BakeFarm, AProbeAmongManyIsAsItIsAlone) {
  scenes::Apartments made = scenes::apartments(16, 1);
  folder_.write("room.glb", scenes::glbBytes(made.model));
  made.scene.models = {ModelFile{folder_.path("room.glb")}};
  for (Probe& probe : made.scene.probes) {
    probe.faceSize = 32;
    probe.samplesPerPixel = 1;
  }
  saveSceneFile(made.scene, folder_.path("room.boxprobe.json"));
  ASSERT_EQ(bake({}, "whole").exitStatus, 0);
  ASSERT_EQ(bake({"--probe", "room 7"}, "alone").exitStatus, 0);
  ASSERT_EQ(bake({"--probe", "room 16"}, "alone").exitStatus, 0);
  for (const char* name : {"room 7.exr", "room 16.exr"}) {
    EXPECT_EQ(readFile(folder_.path(std::string("alone/") + name)),
              readFile(folder_.path(std::string("whole/") + name)))
        << name;
  }
}

TEST_F(BakeFarm, BouncesOneAtATimeContinueFromFiles) {
  writeScene(2);
  ASSERT_EQ(bake({}, "whole").exitStatus, 0);
  ASSERT_EQ(bake({"--bounce", "1", "--shard", "1/2"}).exitStatus, 0);
  EXPECT_EQ(bake({"--check", "--bounce", "1"}).exitStatus, 3);
  ASSERT_EQ(bake({"--bounce", "1", "--shard", "2/2"}).exitStatus, 0);
  EXPECT_EQ(bake({"--check", "--bounce", "1"}).exitStatus, 0);
  EXPECT_THAT(files("out"), ElementsAre("_sky.exr", "a~1.exr", "big~1.exr", "b~1.exr"));
  EXPECT_EQ(list()[0]["bounce"], 1);
  EXPECT_THAT(bake({"--list"}).out, HasSubstr(" of texture memory, its lattice included\n"));
  // The only capture of a single bounce has the sky's light: none of these.
  EXPECT_EQ(bake({"--check", "--set", "probes.a.bounces=1", "--only", "a"}).exitStatus, 3);

  const Outcome second = bake({"--bounce", "2", "--shard", "1/2", "--json"});
  ASSERT_EQ(second.exitStatus, 0) << second.err;
  // No face of a first bounce again, but those of this share's second one.
  EXPECT_LE(Json::parse(second.out)["counters"]["facesCaptured"], 6);
  ASSERT_EQ(bake({"--bounce", "2", "--shard", "2/2"}).exitStatus, 0);
  const Outcome merged = bake({"--merge"});
  EXPECT_EQ(merged.exitStatus, 0) << merged.err;
  EXPECT_THAT(merged.out, HasSubstr("3 of earlier bounces removed"));
  expectSameFiles("out", "whole");
}

TEST_F(BakeFarm, FoldersAreMergedIfTheyBelongTogether) {
  writeScene(1);
  ASSERT_EQ(bake({}, "whole").exitStatus, 0);
  ASSERT_EQ(bake({"--only", "a", "--only", "b"}, "first").exitStatus, 0);
  {
    const Variable narrow("LP_NATIVE_VECTOR_WIDTH", "128");  // a renderer of another name
    ASSERT_EQ(bake({"--probe", "big"}, "second").exitStatus, 0);
    const Outcome mixed = bake({"--shard", "1/1"}, "first");
    EXPECT_EQ(mixed.exitStatus, 2);
    EXPECT_THAT(mixed.err,
                AllOf(HasSubstr("first/a.exr: baked by Boxprobe"), HasSubstr("128 bits"), HasSubstr("--mixed")));
  }
  const Outcome partly = bake({"--merge", folder_.path("first")});
  EXPECT_EQ(partly.exitStatus, 3);
  EXPECT_THAT(partly.err, HasSubstr("1 of 3 baked probe(s) not done: big"));
  const Outcome refused = bake({"--merge", folder_.path("second")});
  EXPECT_EQ(refused.exitStatus, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("second/big.exr: baked by"), HasSubstr("out/a.exr by")));
  EXPECT_THAT(files("out"), Not(Contains("big.exr")));

  ASSERT_EQ(bake({"--merge", folder_.path("first"), folder_.path("whole")}).exitStatus, 0);
  expectSameFiles("out", "whole");

  // Of another state of the scene.
  const Outcome other = bake({"--merge", folder_.path("whole"), "--set", "probes.b.samplesPerPixel=1"}, "other");
  EXPECT_EQ(other.exitStatus, 2);
  EXPECT_THAT(other.err, HasSubstr("whole/b.exr: shows another state of the scene"));
  EXPECT_EQ(bake({"--merge", folder_.path("nowhere")}).exitStatus, 2);
}

/// What Slurm and GNU parallel do with a script's commands, for this test: one after the other.
void writeStandIns(const TemporaryFolder& folder) {
  const auto program = [&](const char* name, const std::string& text) {
    ::chmod(folder.write(name, "#!/bin/sh\nset -eu\n" + text).c_str(), 0755);
  };
  program("sbatch",
          "tasks=1\n"
          "while [ $# -gt 0 ]; do\n"
          "  case $1 in --array=1-*) tasks=${1#--array=1-} ;; --wrap) shift; command=$1 ;; esac; shift\n"
          "done\n"
          "for task in $(seq \"$tasks\"); do\n"
          "  SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_COUNT=$tasks SLURM_ARRAY_TASK_MIN=1 sh -c \"$command\" >&2\n"
          "done\n"
          "echo 17\n");
  program("parallel", "while read -r n; do sh -c \"$(echo \"$1\" | sed \"s/{}/$n/g\")\"; done\n");
}

TEST_F(BakeFarm, ScriptsBakeWhatOneProcessDoes) {
  writeScene(2);
  ASSERT_EQ(bake({}, "whole").exitStatus, 0);
  writeStandIns(folder_);
  const Variable path("PATH", folder_.path("") + ":/usr/bin:/bin");
  for (const std::string kind : {"slurm", "parallel"}) {
    // A name that a shell would take apart.
    const Outcome script = bake({"--emit", kind, "--shards", "2"}, "it's " + kind);
    ASSERT_EQ(script.exitStatus, 0) << script.err;
    const std::string file = folder_.write("script-" + kind, script.out);
    ASSERT_EQ(std::system(("sh '" + file + "' >/dev/null 2>&1").c_str()), 0) << script.out;
    expectSameFiles("it's " + kind, "whole");
  }
  const Outcome make = bake({"--emit", "make", "--shards", "2"}, "out");
  EXPECT_THAT(make.out, AllOf(HasSubstr("\nall: bounce-2\n"), HasSubstr("bounce-2-1: bounce-1\n"),
                              HasSubstr("bounce-1: bounce-1-1 bounce-1-2\n"), HasSubstr("\n\t"),
                              HasSubstr("--bounce 2 --shard 1/2\n")));
}

// Run by stand-ins for GNU parallel, which fills in what looks like {} and would run {=...=}, and for this program,
// which writes down its arguments.
TEST_F(BakeFarm, NoWordOfAFileIsTakenForTheLanguageOfAScript) {
  const std::string sly =
      "{=system(q(touch parallel-ran))=} {} {.} {#} $(touch shell-ran) `touch tick-ran` $USER #!'\"";
  writeScene(1);
  fs::rename(folder_.path("room.boxprobe.json"), folder_.path(sly + ".boxprobe.json"));
  writeStandIns(folder_);
  // What stands in braces is filled in before the command goes to a shell; code would run.
  const std::string filled =
      folder_.write("parallel",
                    "#!/bin/sh\nset -eu\n"
                    "while read -r n; do\n"
                    "  printf '%s\\n' \"$1\" | grep -q '{=' && touch parallel-ran\n"
                    "  sh -c \"$(printf '%s\\n' \"$1\" | sed -e \"s/{}/$n/g\" -e 's/{[.#]}/X/g')\"\n"
                    "done\n");
  ::chmod(filled.c_str(), 0755);
  const std::string recorder =
      folder_.write("record", "#!/bin/sh\nfor a in \"$@\"; do printf '%s\\n' \"$a\"; done >>said\n");
  ::chmod(recorder.c_str(), 0755);
  const Variable path("PATH", folder_.path("") + ":/usr/bin:/bin");
  for (const std::string kind : {"parallel", "make", "slurm"}) {
    SCOPED_TRACE(kind);
    const Outcome script = runProgram({"bake", folder_.path(sly + ".boxprobe.json"), "-o", folder_.path(sly), "--emit",
                                       kind, "--shards", "2", "--set", "probes.a.name=x" + sly});
    ASSERT_EQ(script.exitStatus, 0) << script.err;
    std::string text = script.out;
    const std::string program = fs::canonical(BOXPROBE_PROGRAM).string();
    for (std::size_t at = 0; (at = text.find(program, at)) != std::string::npos; at += recorder.size()) {
      text.replace(at, program.size(), recorder);
    }
    const std::string file = folder_.write("script", text);
    const std::string run = kind == "make" ? "make -s -f script" : "sh ./script";
    ASSERT_EQ(std::system(("cd '" + folder_.path("") + "' && rm -f said && " + run + " >/dev/null").c_str()), 0)
        << text;
    const std::string said = readFile(folder_.path("said"));
    EXPECT_THAT(said, AllOf(HasSubstr(folder_.path(sly + ".boxprobe.json") + "\n-o\n" + folder_.path(sly) + "\n"),
                            HasSubstr("\n--set\nprobes.a.name=x" + sly + "\n")));
    for (const char* ran : {"parallel-ran", "shell-ran", "tick-ran"}) {
      EXPECT_FALSE(fs::exists(folder_.path(ran))) << ran;
    }
  }
  for (const std::string kind : {"parallel", "make", "slurm"}) {
    const Outcome refused = runProgram({"bake", folder_.path(sly + ".boxprobe.json"), "-o", folder_.path("out"),
                                        "--emit", kind, "--quiet", "--set", "probes.a.image=a\nX!=touch make-ran"});
    EXPECT_EQ(refused.exitStatus, 2) << refused.err;
    EXPECT_EQ(refused.errLines().size(), 1u) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("X!=touch make-ran"));
  }
}

TEST_F(BakeFarm, BadInputIsOneLine) {
  writeScene(1);
  const auto line = [&](const std::vector<std::string>& more, const std::string& text) {
    const Outcome outcome = bake(more);
    EXPECT_EQ(outcome.exitStatus, 2) << outcome.err;
    EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  line({"--shard", "3/2"}, "--shard 3/2: expected I/N");
  line({"--shard", "x"}, "--shard x: expected I/N");
  line({"--shard", "auto"}, "neither a task of a Slurm array job");
  line({"--only", "z*"}, "--only z*: matches no baked probe; there are: a, b, big");
  line({"--bounce", "17"}, "--bounce");
  line({"--list", "--check"}, "--check");
  line({"--shards", "2"}, "--emit");
  const Variable id("SLURM_ARRAY_TASK_ID", "7"), count("SLURM_ARRAY_TASK_COUNT", "2"),
      least("SLURM_ARRAY_TASK_MIN", "3");
  line({"--shard", "auto"}, "task 7 of the array job");
}

/// A binary glTF file whose first node with a mesh stands 0.4 further along x.
std::string withNodeMoved(const std::string& glb) {
  const auto number = [&glb](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + at, sizeof value);
    return value;
  };
  const std::size_t length = number(12);
  Json gltf = Json::parse(glb.substr(20, length));
  for (Json& node : gltf["nodes"]) {
    if (!node.contains("mesh")) continue;
    Json place = node.value("translation", Json::array({0.0, 0.0, 0.0}));
    place[0] = place[0].get<double>() + 0.4;
    node["translation"] = place;
    break;
  }
  std::string text = gltf.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string rest = glb.substr(20 + length);
  const auto bytes = [](std::size_t value) {
    const auto small = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&small), sizeof small);
  };
  return glb.substr(0, 8) + bytes(20 + text.size() + rest.size()) + bytes(text.size()) + glb.substr(16, 4) + text +
         rest;
}

Outcome trace(const std::string& output, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {
      "render", demoScene("room"), "--technique", "reference-scene", "--size", "48x27", "--rays", "8", "-o", output};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runProgram(arguments, DisplayKind::Unset);
}

TEST(RenderFarm, SharesOfAReferenceAreThePictureOfOneProcess) {
  const TemporaryFolder folder;
  for (const char* name : {"picture.exr", "picture.png"}) {
    const std::string whole = folder.path(std::string("whole-") + name), shared = folder.path(name);
    ASSERT_EQ(trace(whole, {}).exitStatus, 0);
    const Outcome second = trace(shared, {"--shard", "2/3"});
    EXPECT_THAT(second.out, HasSubstr("rows 9 to 18; 2 of 3 shares are missing"));
    EXPECT_FALSE(fs::exists(shared));
    ASSERT_EQ(trace(shared, {"--shard", "1/3"}).exitStatus, 0);
    // A worker that was killed has left nothing; one that is called again makes nothing twice.
    EXPECT_THAT(trace(shared, {"--shard", "1/3"}).out, HasSubstr("1 of 3 shares are missing"));
    ASSERT_EQ(trace(shared, {"--shard", "3/3"}).exitStatus, 0);
    EXPECT_TRUE(readFile(whole) == readFile(shared));
  }
  EXPECT_EQ(folder.names().size(), 4u) << "no band is left";
}

// The same meshes and materials, one node elsewhere: another picture.
TEST(RenderFarm, BandsOfAModelWhoseNodeMovedAreNotTaken) {
  const TemporaryFolder folder;
  Json scene = Json::parse(readFile(demoScene("room")));
  scene["model"] = "room.glb";
  const std::string path = folder.write("room.boxprobe.json", scene.dump());
  const std::string glb = readFile(BOXPROBE_DATA_DIR "/scenes/room.glb");
  folder.write("room.glb", glb);
  const auto share = [&](const char* shard) {
    return runProgram({"render", path, "--technique", "reference-scene", "--size", "24x14", "--rays", "2", "--shard",
                       shard, "-o", folder.path("picture.exr")},
                      DisplayKind::Unset);
  };
  ASSERT_EQ(share("1/2").exitStatus, 0);
  folder.write("room.glb", withNodeMoved(glb));
  EXPECT_THAT(share("2/2").out, HasSubstr("1 of 2 shares are missing"));
  EXPECT_FALSE(fs::exists(folder.path("picture.exr"))) << "put together from two models";
}

TEST(RenderFarm, BandsOfAnotherPictureAreNotTakenAndDamagedOnesAreNamed) {
  const TemporaryFolder folder;
  const std::string picture = folder.path("picture.exr");
  ASSERT_EQ(trace(picture, {"--shard", "1/2"}).exitStatus, 0);
  const Outcome other = trace(picture, {"--shard", "2/2", "--set", "exposure=2"});
  EXPECT_THAT(other.out, HasSubstr("1 of 2 shares are missing"));
  ASSERT_EQ(folder.names().size(), 2u);
  for (const std::string& name : folder.names()) folder.write(name, "no picture");
  const Outcome damaged = trace(picture, {"--shard", "2/2"});
  EXPECT_NE(damaged.exitStatus, 0);
  EXPECT_EQ(damaged.errLines().size(), 1u) << damaged.err;
  EXPECT_THAT(damaged.err, HasSubstr(".band.exr"));
  const auto refused = [&](const char* technique, const char* shard) {
    const Outcome outcome =
        runProgram({"render", demoScene("room"), "--technique", technique, "--shard", shard, "-o", picture});
    EXPECT_EQ(outcome.exitStatus, 2);
    EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("--shard"));
  };
  refused("reference-scene", "3/2");
  refused("reference-box", "1/2");
  refused("box", "1/2");
}

}  // namespace
}  // namespace boxprobe::test
