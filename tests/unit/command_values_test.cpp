// Command lines in one process: what is refused, and with which words; and what commands that draw nothing print and
// write; against command_refusals.txt, command_scripts.txt and command_results.txt.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/cli/command/bake_command.h"
#include "app/cli/command/bench_command.h"
#include "app/cli/command/explain_command.h"
#include "app/cli/command/export_command.h"
#include "app/cli/command/fit_command.h"
#include "app/cli/command/import_command.h"
#include "app/cli/command/info_command.h"
#include "app/cli/command/place_command.h"
#include "app/cli/command/render_command.h"
#include "app/cli/command/report_command.h"
#include "app/cli/command/stress_command.h"
#include "filters/core/base/errors.h"
#include "filters/io/image/image_file.h"
#include "filters/platform/process.h"
#include "tests/support/kept_values.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

constexpr const char* kRoom = R"(v -2.1 0 -1.4
v 1.9 0 -1.4
v 1.9 0 1.7
v -2.1 0 1.7
v -2.1 2.6 -1.4
v 1.9 2.6 -1.4
v 1.9 2.6 1.7
v -2.1 2.6 1.7
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

constexpr const char* kScene = R"({"format": "boxprobe-scene", "version": 1, "model": "room.obj",
  "lights": [{"type": "point", "position": [0.4, 2.1, 0.3], "intensity": 6}],
  "cameras": {"near": {"position": [-1.2, 1.5, 1.1], "target": [0.5, 0.9, -0.4]},
              "main": {"position": [1.2, 1.4, 1.2], "target": [-0.5, 0.8, -0.6], "verticalFovDegrees": 65}},
  "probes": [{"name": "room", "origin": [0.2, 1.3, 0.1], "box": {"min": [-2.3, -0.2, -1.3], "max": [1.7, 2.8, 1.9]},
              "bounces": 3, "faceSize": 64},
             {"name": "corner", "origin": [1.2, 0.9, 1.1], "box": {"min": [0.4, 0, 0.2], "max": [1.9, 2.6, 1.7]},
              "bounces": 2, "faceSize": 32},
             {"name": "live", "origin": [-1.2, 1.9, -0.6], "box": {"min": [-2, 0, -1], "max": [-0.4, 2.6, 0.7]},
              "mode": "realtime"}]})";

using Words = std::vector<std::string>;

class CommandValues : public TemporaryFolder {
 protected:
  void SetUp() override {
    write("room.obj", kRoom);
    scene_ = write("room.boxprobe.json", kScene);
  }

  void replace(std::string& text, const std::string& what, const std::string& by) const {
    for (std::size_t at = text.find(what); !what.empty() && at != std::string::npos;
         at = text.find(what, at + by.size())) {
      text.replace(at, what.size(), by);
    }
  }
  /// Without what is of this machine and of this run.
  std::string cleaned(std::string text) const {
    for (std::string path : {folder_.string(), std::filesystem::canonical(folder_).string()}) {
      replace(text, path, "FOLDER");
    }
    replace(text, programPath(), "PROGRAM");
    replace(text, BOXPROBE_DATA_DIR, "DATA");
    replace(text, BOXPROBE_SOURCE_DIR, "SOURCE");
    text = std::regex_replace(text, std::regex("(there are: .{60}).*"), "$1..");
    text = std::regex_replace(text, std::regex("\"(\\w*[sS]econds\\w*|peakResident)\": [-+.e0-9]+"), "\"$1\": -");
    text = std::regex_replace(text, std::regex("\"(worst|p9999)\\w*\":([-0-9.e+]+|null|\"[a-z]+\"),"), "");
    text = std::regex_replace(text, std::regex("\"(worst\\w*\":\\[[^\\]]*\\]|replay\":\"[^\"]*\"),?"), "");
    return std::regex_replace(text, std::regex("; [0-9.]+ s\n"), "; - s\n");
  }

  /// What the program prints; "! ..." for what is refused. Of what the library of options refuses the option alone.
  std::string run(Words words) {
    CLI::App program("", "boxprobe");
    program.require_subcommand(1);
    const std::vector<Subcommand> commands = {
        addRenderCommand(program), addBakeCommand(program),  addExplainCommand(program), addExportCommand(program),
        addImportCommand(program), addInfoCommand(program),  addFitCommand(program),     addPlaceCommand(program),
        addReportCommand(program), addBenchCommand(program), addStressCommand(program)};
    for (std::string& word : words) {
      if (word == "S") word = scene_;
      if (word.rfind("F/", 0) == 0) word = file(word.substr(2));
    }
    std::reverse(words.begin(), words.end());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string refused;
    try {
      program.parse(words);
      for (const Subcommand& command : commands) {
        if (command.arguments->parsed()) command.run();
      }
    } catch (const CLI::Error& error) {
      refused = "! usage: " + std::string(error.what()).substr(0, std::string(error.what()).find_first_of(" :")) + "\n";
    } catch (const InputError& error) {
      refused = std::string("! ") + error.what() + "\n";
    } catch (const Error& error) {
      refused = std::string("! failed: ") + error.what() + "\n";
    }
    std::fflush(stdout);
    const std::string out = testing::internal::GetCapturedStdout(), err = testing::internal::GetCapturedStderr();
    return cleaned(out + (err.empty() ? "" : "stderr: " + err) + refused);
  }
  void add(const Words& words) {
    std::string line;
    for (const std::string& word : words) line += " " + word;
    values_.part(cleaned(line.substr(1)));
    values_.add(run(words));
  }
  void addAll(const Words& first, const std::vector<Words>& more) {
    for (const Words& each : more) {
      Words words = first;
      words.insert(words.end(), each.begin(), each.end());
      add(words);
    }
  }

  std::string scene_;
  test::KeptValues values_;
};

TEST_F(CommandValues, WhatDoesNotFitIsRefused) {
  addAll({"render", "S", "-o", "F/a.png"}, {{"--size", "0x5"},
                                            {"--size", "16384x16385"},
                                            {"--samples", "2"},
                                            {"--rays", "0"},
                                            {"--rays", "65537"},
                                            {"--frames", "-1"},
                                            {"--frames", "100001"},
                                            {"--tone", "loud"},
                                            {"--probes", "maybe"},
                                            {"--refine=0"},
                                            {"--refine=100%"},
                                            {"--refine=65537"},
                                            {"--refine=x"},
                                            {"--refine", "--view", "level"},
                                            {"--refine", "--frames", "1"},
                                            {"--refine", "--probes", "off"},
                                            {"--full"},
                                            {"--shard", "1/2"},
                                            {"--bounces", "3"},
                                            {"--rays", "12"},
                                            {"--bounces", "3", "--view", "level"},
                                            {"--technique", "mirror"},
                                            {"--camera", "nowhere"},
                                            {"--view", "moon"},
                                            {"--view", "level", "--range", "3,2"},
                                            {"--range", "1,2"},
                                            {"--as", "house"},
                                            {"--light", "moon"},
                                            {"--offscreen", "wayland"},
                                            {"--renderer-tuning", "both"},
                                            {"--stats", "F/none/stats.json"},
                                            {"--stats", "F/a.png"},
                                            {"--technique", "reference-scene", "--view", "level"},
                                            {"--technique", "reference-scene", "--refine"},
                                            {"--technique", "reference-scene", "--frames", "1"},
                                            {"--technique", "reference-scene", "--probes", "off"},
                                            {"--technique", "reference-scene", "--bounces", "2"},
                                            {"--technique", "reference-box", "--full"},
                                            {"--technique", "reference-box", "--shard", "1/2"},
                                            {"--technique", "reference-path", "--full"},
                                            {"--technique", "reference-path", "--bounces", "-1"},
                                            {"--technique", "reference-path", "--bounces", "1001"},
                                            {"--technique", "reference-path", "--bounces", "two"},
                                            {"--technique", "reference-path", "--shard", "3/2"}});
  addAll({"render", "S"}, {{},
                           {"-o", "F/a.jpg"},
                           {"-o", "F/none/a.png"},
                           {"-o", "F/sheet.exr", "--view", "all"},
                           {"-o", "F/room.obj/a.png"},
                           {"-o", "F/room.obj.png", "--set", "exposure=-1"}});
  add({"render", "F/none.boxprobe.json", "-o", "F/a.png"});
  add({"render", "F/", "-o", "F/a.png"});
  addAll({"explain", "S", "--technique", "nonsense"}, {{"--pixel", "5"},
                                                       {"--pixel", "5,6,7"},
                                                       {"--pixel", "-1,2"},
                                                       {"--pixel", "2,-1"},
                                                       {"--pixel", "1280,0"},
                                                       {"--pixel", "0,720"},
                                                       {"--pixel", "1279,0"},
                                                       {"--pixel", "0,719"},
                                                       {"--pixel", "30,20", "--size", "30x21"},
                                                       {}});
  addAll({"info"},
         {{}, {"--fields", "S"}, {"--costs", "S"}, {"S", "--size", "3"}, {"S", "--frame", "--camera", "nowhere"}});
  addAll({"fit", "S"}, {{"--faces", "+w"},
                        {"--probe", "hall"},
                        {"--yaw", "turn"},
                        {"--origin", "move"},
                        {"-o", "F/fit.txt"},
                        {"-o", "F/none/fit.json"}});
  addAll({"place", "S"}, {{"--most", "0"},
                          {"--most", "10001"},
                          {"--gain", "-0.1"},
                          {"--gain", "101"},
                          {"--fits-only"},
                          {"--shards", "3"},
                          {"--shard", "1/2"},
                          {"--merge"},
                          {"--emit", "make"},
                          {"--emit", "bash", "-o", "F/p.json"},
                          {"--emit", "make", "--shards", "0", "-o", "F/p.json"},
                          {"--emit", "make", "--merge", "-o", "F/p.json"},
                          {"--shard", "1/2", "--merge", "-o", "F/p.json"},
                          {"-o", "F/p.txt"}});
  addAll({"report", "S", "-o", "F/r.html"}, {{"--fail-above", "-1"},
                                             {"--fail-above", "much"},
                                             {"--fail-above", ""},
                                             {"--fail-above", "inf"},
                                             {"--rays", "7"},
                                             {"--size", "x"},
                                             {"--camera", "nowhere"},
                                             {"--technique", "mirror"},
                                             {"--shard", "0/2"},
                                             {"--shard", "2/x"},
                                             {"--shard", "auto"},
                                             {"--merge", "--shard", "1/2"}});
  add({"report", "S", "-o", "F/r.pdf"});
  addAll({"bake", "S", "-o", "F/baked"}, {{"--probe", "hall"},
                                          {"--probe", "live"},
                                          {"--only", "x*"},
                                          {"--shard", "9/8"},
                                          {"--bounce", "0"},
                                          {"--list", "--check"},
                                          {"--merge", "--shard", "1/2"},
                                          {"--shards", "2"}});
  addAll({"bench"}, {{"--refine", "3"},
                     {"--refine", "0", "--truth"},
                     {"--whole", "--truth"},
                     {"--whole", "--rooms", "3"},
                     {"--whole", "--roughness", "0.1"},
                     {"--whole", "--materials", "a"},
                     {"--truth", "--size", "3x3"},
                     {"--truth", "--materials", "a"},
                     {"--truth", "--rooms", "2"},
                     {"--truth", "--set", "exposure=2"},
                     {"--truth", "--set", "lamps=in-map", "--camera", "nowhere"},
                     {"--truth", "--roughness", "0.123"},
                     {"--truth=F/none.json"},
                     {"S", "--truth"},
                     {"S", "--rooms", "1001"},
                     {"S", "--techniques", "mirror"},
                     {"S", "--roughness", "0.5,2"},
                     {"S", "--roughness", ","},
                     {"S", "--camera", "nowhere"},
                     {"S", "--size", "5"},
                     {"S", "--whole", "-o", "F/room.obj"}});
  addAll({"export", "S"}, {{},
                           {"-o", "F/e.glsl", "--shader", "wgsl"},
                           {"-o", "F/none/e.glsl", "--shader", "glsl"},
                           {"-o", "F/e", "--technique", "box"},
                           {"-o", "F/e", "--probe", "hall"},
                           {"-o", "F/e", "--format", "jpg"},
                           {"-o", "F/e", "--ladder", "none"},
                           {"-o", "F/e", "--size", "100"},
                           {"-o", "F/e", "--format", "web", "--probe", "room"},
                           {"-o", "F/e", "--format", "web", "--center"},
                           {"-o", "F/e", "--format", "glb", "--lossy"},
                           {"-o", "F/e", "--format", "glb", "--ladder", "three"},
                           {"-o", "F/e", "--format", "web", "--size", "100"},
                           {"-o", "F/none/e.glb", "--format", "glb"}});
  addAll({"import", "S"}, {{}, {"-o", "F/i.txt"}, {"-o", "F/none/i.json"}});
  addAll({"stress"}, {{"--count", "0"},
                      {"--device", "tpu"},
                      {"--class", "nobody"},
                      {"--technique", "mirror"},
                      {"--replay", "nobody box"},
                      {"--replay", "inside box 1"},
                      {"--replay", "inside mirror 1"},
                      {"--replay", "inside box 1x"},
                      {"-o", "F/none/s.json"}});
  values_.expect("unit/values/command_refusals.txt");
}

TEST_F(CommandValues, ScriptsHaveWhatWasAskedFor) {
  for (const char* kind : {"slurm", "parallel", "make"}) {
    add({"place", "S", "-o", "F/p.boxprobe.json", "--emit", kind, "--shards", "3"});
    add({"bake", "S", "-o", "F/baked", "--emit", kind});
    add({"report", "S", "-o", "F/r.html", "--emit", kind, "--shards", "2"});
  }
  add({"place", "S", "-o", "F/p.boxprobe.json", "--emit", "slurm"});
  add({"place",   "S",      "-o",     "F/p.boxprobe.json", "--emit", "parallel",     "--most", "5",
       "--gain",  "2.5",    "--set",  "exposure=2",        "--set",  "lamps=shapes", "--as",   "open",
       "--light", "studio", "--keep", "--unchecked"});
  add({"bake", "S", "--emit", "parallel", "--only", "r*", "--probe", "corner", "--set", "exposure=2", "--mixed",
       "--shards", "7"});
  add({"bake", "S", "-o", "F/baked", "--emit", "parallel", "--probe", "corner", "--set", "probes.corner.bounces=1"});
  add({"report",  "S",        "F/two.glb",    "-o",          "F/r.html", "--emit",     "parallel", "--camera",
       "near",    "--camera", "it's",         "--technique", "box+none", "--size",     "64x48",    "--rays",
       "9",       "--quick",  "--seed",       "4",           "--set",    "exposure=2", "--as",     "open",
       "--light", "file",     "--fail-above", "0.25"});
  add({"place", "F/a\tb.glb", "-o", "F/p.boxprobe.json", "--emit", "make"});
  values_.expect("unit/values/command_scripts.txt");
}

TEST_F(CommandValues, ReferencesAndStressTestsTellTheSame) {
  const Words traced = {"render", "S", "--size", "12x9", "--technique", "reference-path", "-o", "F/t.exr"};
  addAll(traced, {{"--rays", "8"},
                  {"--rays", "8", "--json"},
                  {"--rays", "8", "--json", "--bounces", "1", "--camera", "near"},
                  {"--rays", "8", "--json", "--bounces", "0"},
                  {"--rays", "1", "--json", "--bounces", "all"},
                  {"--rays", "1"},
                  {"--rays", "8", "--quiet", "--stats", "F/stats.json"}});
  values_.add(cleaned(read("stats.json")));
  // What was written is read by another name: a program's output is never its input.
  const auto picture = [&](const std::string& name) {
    std::filesystem::copy_file(file(name), file("copy of " + name));
    return loadHdrImage(file("copy of " + name));
  };
  const ImageRgbaF whole = picture("t.exr");
  // The same in three shares, of which the one that finds the others puts the picture together.
  const Words shared = {"render",         "S",  "--size",  "12x9",   "--technique",
                        "reference-path", "-o", "F/s.exr", "--rays", "8"};
  std::string said;
  for (const char* share : {"1/3", "3/3", "2/3"}) {
    Words words = shared;
    words.insert(words.end(), {"--shard", share});
    said += run(words);
  }
  values_.part("three shares");
  values_.add(std::regex_replace(said, std::regex("[0-9a-f]{16}"), "KEY"));
  EXPECT_TRUE(picture("s.exr").pixels == whole.pixels);
  EXPECT_EQ(entryCount(), 7u) << "room, scene, two pictures twice and statistics: no share is left";
  values_.part("the picture");
  for (std::size_t i = 0; i < whole.pixels.size(); i += 4 * 5) {
    values_.add(std::to_string(i / 4), std::vector<float>(&whole.pixels[i], &whole.pixels[i] + 4));
  }
  addAll({"stress", "--count", "24", "--seed", "3", "--class", "extreme-scenes"},
         {{"--json"}, {"--first", "17"}, {"--quiet", "-o", "F/lines.json", "--stats", "F/stats.json"}});
  values_.add(read("lines.json"));
  values_.add("statistics", std::vector<bool>{read("stats.json").find("facesCaptured") != std::string::npos});
  addAll({"stress", "--json"},
         {{"--count", "400", "--technique", "box", "--class", "inside", "--class", "extreme-scenes"},
          {"--count", "30", "--technique", "box", "--technique", "box+none", "--class", "flat"},
          {"--count", "300", "--published", "--class", "inside"},
          {"--count", "1600", "--technique", "sphere", "--seed", "4"}});
  values_.expect("unit/values/command_results.txt", 2e-4);
}

}  // namespace
}  // namespace boxprobe
