// What the command line's texts mean, how work is shared and how help is set, against values that follow from the
// documentation of each option.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/cli/farm/bake_listing.h"
#include "app/cli/farm/bake_share.h"
#include "app/cli/farm/farm_script.h"
#include "app/cli/farm/picture_shares.h"
#include "app/cli/options/bench_options.h"
#include "app/cli/options/help_text.h"
#include "app/cli/options/render_options.h"
#include "filters/core/scene/bounces.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Options, SizesViewsAndRefinementsAreReadWhole) {
  const auto size = [](const char* text) {
    const FrameSize read = parseFrameSize(text);
    return std::pair(read.width, read.height);
  };
  EXPECT_EQ(size("1x1"), std::pair(1, 1));
  EXPECT_EQ(size("16384x1"), std::pair(16384, 1));
  EXPECT_EQ(size("3x16384"), std::pair(3, 16384));
  for (const char* text : {"", "x", "3", "3x", "x3", "3x4x5", "0x3", "3x0", "16385x3", "3x16385", "-3x4", "3 x4",
                           "+3x4", "3x4 ", "100000x3", "3.5x4"}) {
    EXPECT_THAT(errorText([&] { parseFrameSize(text); }), HasSubstr(std::string("--size ") + text + ": expected"));
  }
  EXPECT_EQ(parseRefine("").rays, 0);
  EXPECT_EQ(parseRefine("1").rays, 1);
  EXPECT_EQ(parseRefine("1").until, 0.0);
  EXPECT_EQ(parseRefine(std::to_string(RefineSettings::kMostRays)).rays, RefineSettings::kMostRays);
  EXPECT_EQ(parseRefine("2.5%").rays, RefineSettings::kMostRays);
  EXPECT_DOUBLE_EQ(parseRefine("2.5%").until, 0.025);
  EXPECT_DOUBLE_EQ(parseRefine("99.99%").until, 0.9999);
  for (const std::string& text :
       {std::string("0"), std::string("%"), std::string("0%"), std::string("99.999%"), std::string("2.5"),
        std::string("-1"), std::string("1e3"), std::string("3 "), std::to_string(RefineSettings::kMostRays + 1)}) {
    EXPECT_THAT(errorText([&] { parseRefine(text); }), HasSubstr("--refine=" + text + ": expected"));
  }
  const SurfaceViewSettings view = parseView("level", "-1.5,8");
  EXPECT_EQ(view.view, *findSurfaceView("level"));
  EXPECT_EQ(view.low, -1.5);
  EXPECT_EQ(view.high, 8.0);
  EXPECT_FALSE(parseView("level", "").low || parseView("level", "").high);
  EXPECT_EQ(parseView("", "").view, 0);
  EXPECT_EQ(parseView(kAllViews, "").view, 0);
  for (const char* range : {"1", "1,", ",1", "2,1", "1,1", "1,2,3", "1,2 ", "inf,3", "0,inf", "nan,1", "a,b"}) {
    EXPECT_THAT(errorText([&] { parseView("level", range); }), HasSubstr("expected two numbers")) << range;
  }
  for (const SurfaceViewRow& row : surfaceViews()) {
    const std::string id(row.id);
    if (row.kind == ViewKind::Scalar) {
      EXPECT_EQ(*parseView(id, "1,2").high, 2.0) << id;
    } else {
      EXPECT_THAT(errorText([&] { parseView(id, "1,2"); }), HasSubstr("only a view of a number")) << id;
    }
  }
}

Scene sceneOfCameras(const std::vector<std::string>& names) {
  Scene scene;
  for (const std::string& name : names) {
    scene.cameras.emplace_back();
    scene.cameras.back().name = name;
    scene.cameras.back().position.x = static_cast<double>(scene.cameras.size());
  }
  return scene;
}

TEST(Options, CamerasTechniquesAndKindsAreChosenByName) {
  const Scene three = sceneOfCameras({"a", "main", "c"}), two = sceneOfCameras({"b", "c"});
  EXPECT_EQ(chooseCamera(three, "").position.x, 2.0);
  EXPECT_EQ(chooseCamera(three, "c").position.x, 3.0);
  EXPECT_EQ(chooseCamera(two, "").name, "b");
  EXPECT_EQ(chooseCamera({}, ""), Camera{});
  EXPECT_EQ(errorText([&] { chooseCamera(two, "main"); }),
            "--camera main: no camera of that name; the scene has: b, c");
  EXPECT_EQ(errorText([&] { chooseCamera({}, "a"); }), "--camera a: no camera of that name; the scene has: none");
  Scene scene;
  scene.probes.resize(2);
  chooseTechnique(scene, "");
  EXPECT_EQ(scene.probes[1].technique, "box");
  chooseTechnique(scene, "box+hdrp");
  EXPECT_EQ(scene.probes[0].technique, "box+hdrp");
  EXPECT_EQ(scene.probes[1].technique, "box+hdrp");
  EXPECT_THAT(errorText([&] { chooseTechnique(scene, "mirror"); }), HasSubstr("--technique mirror: no such technique"));
  EXPECT_FALSE(parseFitWishes({}, 1.5).kind || parseFitWishes({}, 1.5).light);
  EXPECT_EQ(parseFitWishes({}, 1.5).aspect, 1.5);
  for (const ModelKind kind : {ModelKind::Object, ModelKind::Interior, ModelKind::Open}) {
    EXPECT_EQ(parseFitWishes({modelKindId(kind), ""}, 1.0).kind, kind);
  }
  for (const FitLight light : allFitLights()) EXPECT_EQ(parseFitWishes({"", fitLightId(light)}, 1.0).light, light);
}

std::vector<std::string> namesOf(const std::vector<Camera>& cameras) {
  std::vector<std::string> names;
  for (const Camera& camera : cameras) names.push_back(camera.name);
  return names;
}

TEST(Options, ABenchmarksPlanIsThatOfItsDocumentation) {
  EXPECT_THAT(listedNames("low,steep,"), ElementsAre("low", "steep"));
  EXPECT_THAT(listedNames(",b"), ElementsAre("", "b"));
  EXPECT_THAT(listedNames(""), ElementsAre());
  EXPECT_THAT(chosenRoughnesses("1,0.25,0,0.25"), ElementsAre(0.0, 0.25, 1.0));
  for (const char* list : {"1.1", "-0.1", "0.5x", "a", "0.1,,0.2", "nan"}) {
    EXPECT_THAT(errorText([&] { chosenRoughnesses(list); }), HasSubstr("expected numbers from 0 to 1")) << list;
  }
  const Scene scene = sceneOfCameras({"a", "main", "c"});
  BenchOptions options;
  options.seed = 5;
  const BenchPlan plan = benchPlan(options, scene);
  EXPECT_THAT(namesOf(plan.cameras), ElementsAre("main", "a", "c"));
  EXPECT_THAT(plan.roughnesses, ElementsAre(0.0, 0.1, 0.25, 0.5, 0.75, 1.0));
  EXPECT_EQ(std::pair(plan.width, plan.height), std::pair(200, 112));
  EXPECT_EQ(plan.seed, 5u);
  EXPECT_EQ(plan.study.rooms, 192);
  EXPECT_EQ(timedFrameSize(options).width, 640);
  EXPECT_EQ(timedFrameSize(options).height, 360);
  BenchOptions quick = options;
  quick.quick = true;
  const BenchPlan small = benchPlan(quick, scene);
  EXPECT_THAT(namesOf(small.cameras), ElementsAre("main"));
  EXPECT_THAT(small.roughnesses, ElementsAre(0.1, 0.5, 1.0));
  EXPECT_EQ(std::pair(small.width, small.height), std::pair(160, 90));
  EXPECT_EQ(small.study.rooms, 8);
  EXPECT_EQ(timedFrameSize(quick).width, 320);
  EXPECT_EQ(timedFrameSize(quick).height, 180);
  const auto effort = [](const BenchPlan& p) {
    return std::vector<double>{static_cast<double>(p.boxTruth.raysPerPass),
                               p.boxTruth.standardError * 1e6,
                               static_cast<double>(p.boxTruth.leastPasses),
                               static_cast<double>(p.boxTruth.mostPasses),
                               static_cast<double>(p.sceneTruth.raysPerPass),
                               p.sceneTruth.standardError * 1e6,
                               static_cast<double>(p.sceneTruth.leastPasses),
                               static_cast<double>(p.sceneTruth.mostPasses),
                               static_cast<double>(p.lookupPixels),
                               static_cast<double>(p.mostPairs),
                               p.pairSeconds,
                               static_cast<double>(p.study.faceSize),
                               static_cast<double>(p.study.rays)};
  };
  const BenchPlan usual;
  EXPECT_THAT(effort(plan),
              testing::Pointwise(testing::DoubleNear(1e-6),
                                 {256.0, 1200.0, 3.0, 16.0, 64.0, 1800.0, 3.0, 12.0, 16.0, 9.0, 0.6,
                                  static_cast<double>(usual.study.faceSize), static_cast<double>(usual.study.rays)}));
  EXPECT_THAT(effort(small), testing::Pointwise(testing::DoubleNear(1e-6), {128.0, 2000.0, 3.0, 16.0, 48.0, 3000.0, 3.0,
                                                                            12.0, 8.0, 3.0, 0.1, 64.0, 1024.0}));
  EXPECT_NE(plan.boxTruth.seed, plan.sceneTruth.seed);
  options.cameras = "c,a";
  options.roughnesses = "0.3";
  options.size = "30x20";
  options.materials = "floor,wall";
  options.rooms = 3;
  options.techniques = "footprint4";
  const BenchPlan own = benchPlan(options, scene);
  EXPECT_THAT(namesOf(own.cameras), ElementsAre("c", "a"));
  EXPECT_THAT(own.roughnesses, ElementsAre(0.3));
  EXPECT_EQ(std::pair(own.width, own.height), std::pair(30, 20));
  EXPECT_THAT(own.materials, ElementsAre("floor", "wall"));
  EXPECT_EQ(own.study.rooms, 3);
  EXPECT_EQ(own.techniques.front().id, "box+footprint4");
  EXPECT_EQ(own.boxTruth.seed, plan.boxTruth.seed);
  options.seed = 6;
  EXPECT_NE(benchPlan(options, scene).boxTruth.seed, plan.boxTruth.seed);
}

class BenchFolder : public TemporaryFolder {};

TEST_F(BenchFolder, IsMade) {
  requireBenchFolder(file("one/two"), "bench.json");
  EXPECT_TRUE(std::filesystem::is_directory(file("one/two")));
  write("file", "text");
  EXPECT_EQ(errorText([&] { requireBenchFolder(file("file"), "bench.json"); }),
            "-o " + file("file") + ": this is a file; -o names a folder");
  EXPECT_THAT(errorText([&] { requireBenchFolder(file("file/below"), "bench.json"); }),
              HasSubstr("cannot create this folder"));
}

Probe probeOf(const std::string& name, int faceSize, int bounces, int samples) {
  Probe probe;
  probe.name = name;
  probe.faceSize = faceSize;
  probe.bounces = bounces;
  probe.samplesPerPixel = samples;
  return probe;
}

// 0.2 s for six faces and 4e-7 s a sample, each bounce; ten bytes a texel.
TEST(Shares, ABakeTakesAsLongAsItsTexels) {
  const Probe probe = probeOf("p", 128, 3, 16);
  EXPECT_NEAR(bakeSeconds(probe), 3.0 * (0.2 + 4e-7 * 16.0 * 6.0 * 128.0 * 128.0), 1e-12);
  EXPECT_NEAR(bakeBytes(probe), 10.0 * 6.0 * 128.0 * 128.0, 1e-9);
}

TEST(Shares, TheLongestIsGivenAwayFirst) {
  // 1.2, 0.4, 0.6, 0.2 and 0.8 s and a little
  const std::vector<Probe> probes = {probeOf("a", 16, 6, 1), probeOf("b", 16, 2, 1), probeOf("c", 16, 3, 1),
                                     probeOf("d", 16, 1, 1), probeOf("e", 16, 4, 1)};
  EXPECT_THAT(probesOfShare(probes, {1, 2}), ElementsAre("a", "b"));
  EXPECT_THAT(probesOfShare(probes, {2, 2}), ElementsAre("c", "d", "e"));
  EXPECT_THAT(probesOfShare(probes, {1, 3}), ElementsAre("a"));
  EXPECT_THAT(probesOfShare(probes, {2, 3}), ElementsAre("d", "e"));
  EXPECT_THAT(probesOfShare(probes, {3, 3}), ElementsAre("b", "c"));
  EXPECT_THAT(probesOfShare(probes, {5, 5}), ElementsAre("d"));
  EXPECT_THAT(probesOfShare(probes, {6, 7}), ElementsAre());
  EXPECT_THAT(probesOfShare({}, {1, 1}), ElementsAre());
}

TEST(Shares, AreReadFromTextAndEnvironment) {
  const std::vector<std::string> names = {"SLURM_ARRAY_TASK_ID",
                                          "SLURM_ARRAY_TASK_COUNT",
                                          "SLURM_ARRAY_TASK_MIN",
                                          "SLURM_ARRAY_TASK_STEP",
                                          "OMPI_COMM_WORLD_RANK",
                                          "OMPI_COMM_WORLD_SIZE",
                                          "PMI_RANK",
                                          "PMI_SIZE",
                                          "SLURM_PROCID",
                                          "SLURM_NTASKS"};
  const auto share = [&](const std::vector<std::pair<std::string, std::string>>& values) -> std::string {
    for (const std::string& name : names) ::unsetenv(name.c_str());
    for (const auto& [name, value] : values) ::setenv(name.c_str(), value.c_str(), 1);
    try {
      const BakeShare read = parseBakeShare("auto");
      return std::to_string(read.index) + "/" + std::to_string(read.count);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const char *id = "SLURM_ARRAY_TASK_ID", *count = "SLURM_ARRAY_TASK_COUNT", *least = "SLURM_ARRAY_TASK_MIN",
             *step = "SLURM_ARRAY_TASK_STEP";
  EXPECT_EQ(share({{id, "3"}, {count, "8"}, {least, "1"}}), "3/8");
  EXPECT_EQ(share({{id, "3"}, {count, "8"}}), "4/8");
  EXPECT_EQ(share({{id, "9"}, {count, "3"}, {least, "5"}, {step, "4"}}), "2/3");
  EXPECT_EQ(share({{id, "13"}, {count, "3"}, {least, "5"}, {step, "4"}}), "3/3");
  const std::string refused =
      "--shard auto: task 17 of the array job is not one of 3 in a row; submit it as --array=1-3";
  EXPECT_THAT(share({{id, "17"}, {count, "3"}, {least, "5"}, {step, "4"}}), HasSubstr(refused));
  EXPECT_THAT(share({{id, "8"}, {count, "3"}, {least, "5"}, {step, "4"}}), HasSubstr("task 8 of"));
  EXPECT_THAT(share({{id, "4"}, {count, "3"}, {least, "5"}, {step, "1"}}), HasSubstr("task 4 of"));
  EXPECT_EQ(share({{id, "6"}, {count, "3"}, {least, "5"}, {step, "0"}}), "2/3");
  EXPECT_EQ(share({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "4"}, {"PMI_RANK", "2"}, {"PMI_SIZE", "4"}}),
            "1/4");
  EXPECT_EQ(share({{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}, {"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "4"}}), "4/4");
  EXPECT_EQ(share({{"SLURM_PROCID", "1"}, {"SLURM_NTASKS", "2"}}), "2/2");
  for (const char* rank : {"2", "-1", "1x", "", "x"}) {
    EXPECT_THAT(share({{"PMI_RANK", rank}, {"PMI_SIZE", "2"}}), HasSubstr("say --shard I/N")) << rank;
  }
  EXPECT_FALSE(mpiShare());
  share({});
  EXPECT_EQ(parseBakeShare("3/3").index, 3);
  EXPECT_EQ(parseBakeShare("1/5").count, 5);
  for (const char* text : {"", "3", "/", "3/", "/3", "0/3", "4/3", "1/0", "-1/3", "1/3/3", "a/b", "1 /3"}) {
    EXPECT_THAT(errorText([&] { parseBakeShare(text); }), HasSubstr("expected I/N with I from 1 to N")) << text;
  }
}

TEST(Shares, RowsOfAPictureAreGivenAwayWhole) {
  const auto rows = [](int height, int index, int count) {
    const PicturePart part = rowsOfShare(40, height, {index, count});
    EXPECT_EQ(part.left, 0);
    EXPECT_EQ(part.right, 40);
    return std::pair(part.top, part.bottom);
  };
  EXPECT_EQ(rows(10, 1, 3), std::pair(0, 3));
  EXPECT_EQ(rows(10, 2, 3), std::pair(3, 6));
  EXPECT_EQ(rows(10, 3, 3), std::pair(6, 10));
  EXPECT_EQ(rows(2, 1, 3), std::pair(0, 0));
  EXPECT_EQ(rows(2, 2, 3), std::pair(0, 1));
  EXPECT_EQ(rows(16384, 99999, 100000), std::pair(16383, 16383));
  EXPECT_EQ(bandPath("a/b.exr", {3, 8}, "0123"), "a/b.exr.3-of-8.0123.band.exr");
}

class Bands : public TemporaryFolder {};

TEST_F(Bands, PutThePictureTogether) {
  ReferencePicture picture;
  picture.color = picture.standardError = {3, 5, {}};
  for (int i = 0; i < 60; ++i) {
    picture.color.pixels.push_back(0.5f + static_cast<float>(i));
    picture.standardError.pixels.push_back(0.25f * static_cast<float>(i));
  }
  const std::string path = file("p.exr");
  const auto band = [&](int index) { return bandPath(path, {index, 4}, "k"); };
  const auto save = [&](int index) { saveBand(band(index), picture, rowsOfShare(3, 5, {index, 4})); };
  for (const int index : {2, 4}) save(index);
  EXPECT_EQ(joinBands(path, 3, 5, 4, "k").missing, 2);
  EXPECT_TRUE(joinBands(path, 3, 5, 4, "k").picture.color.pixels.empty());
  EXPECT_EQ(joinBands(path, 3, 5, 4, "other").missing, 4);
  for (const int index : {1, 3}) save(index);
  const JoinedBands joined = joinBands(path, 3, 5, 4, "k");
  EXPECT_EQ(joined.missing, 0);
  EXPECT_FALSE(joined.elsewhere);
  EXPECT_EQ(joined.picture.color.width, 3);
  EXPECT_EQ(joined.picture.standardError.height, 5);
  EXPECT_TRUE(joined.picture.color.pixels == picture.color.pixels);
  EXPECT_TRUE(joined.picture.standardError.pixels == picture.standardError.pixels);
  saveBand(band(3), picture, {0, 0, 3, 2});
  EXPECT_THAT(errorText([&] { joinBands(path, 3, 5, 4, "k"); }), HasSubstr(band(3) + ": not the band"));
  write("p.exr.3-of-4.k.band.exr", "damaged");
  EXPECT_THAT(errorText([&] { joinBands(path, 3, 5, 4, "k"); }), HasSubstr(band(3)));
  save(3);
  write("p.exr.1-of-4.other.band.exr", "of others");
  removeBands(path, 4, "k");
  EXPECT_EQ(entryCount(), 1u);
}

TEST(Shares, AWordOfAScriptIsOneWord) {
  EXPECT_EQ(shellWord("a_b-c./,:@%+=9Z"), "a_b-c./,:@%+=9Z");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's"), R"('it'\''s')");
  EXPECT_EQ(shellWord("$x"), "'$x'");
}

TEST(Listing, SumsWhatIsLeft) {
  std::vector<Probe> probes = {probeOf("hall", 256, 4, 1), probeOf("store", 128, 1, 1), probeOf("attic", 32, 3, 1),
                               probeOf("all", 16, kAllBounces, 1)};
  std::vector<BakeRow> rows;
  for (const Probe& probe : probes)
    rows.push_back({probe.name, "key-" + probe.name, "missing", 0, probe.bounces, 2.25});
  rows[0] = {"hall", "k", "stale", 2, 4, 7.5};
  rows[1] = {"store", "l", "done", 1, 1, 100.0};
  rows[3].made = 1;
  test::KeptValues values;
  for (const bool lattices : {true, false}) values.add(bakeListText(rows, probes, "FOLDER", lattices));
  for (Probe& probe : probes) probe.lattice = ProbeLattice{};
  for (Probe& probe : probes) probe.lattice->used = false;
  values.add(bakeListText(rows, probes, "FOLDER", true));
  probes[0].lattice.reset();
  values.add(bakeListText({rows[1], rows[0]}, {probes[1], probes[0]}, "FOLDER", true));
  values.add(bakeListText({rows[1]}, {probes[1]}, "FOLDER", true));
  values.add(bakeListJson(rows));
  for (const int bounce : {0, 1, 2, 3, 9}) {
    values.add(std::to_string(bounce) + ": " + errorText<WorkLeft>([&] { requireBaked(rows, bounce, "FOLDER"); }));
  }
  requireBaked({rows[1]}, 0, "FOLDER");
  requireBaked({rows[0], rows[1]}, 2, "FOLDER");
  for (const std::size_t count : {20u, 21u, 23u}) {
    const std::string text =
        errorText<WorkLeft>([&] { requireBaked(std::vector<BakeRow>(count, rows[2]), 0, "FOLDER"); });
    values.add(text.substr(text.size() - 40));
  }
  values.expect("unit/values/bake_listing.txt");
}

TEST(Help, IsSetLineByLine) {
  CLI::App program("What it does.", "tool");
  program.formatter(std::make_shared<HelpText>());
  std::string text;
  std::vector<std::string> many;
  std::vector<int> two;
  int number = 3;
  bool flag = false;
  CLI::App* command = program.add_subcommand("run", "Runs it");
  program.add_subcommand("a-command-of-a-very-long-name-indeed", "Stops it");
  program.add_subcommand("hidden", "Not shown")->group("");
  command->add_option("SCENE", text, "What to read")->required();
  command->add_option("MORE", many, "What else to read");
  command->add_option("-n,--number", number, "How many")->type_name("N")->capture_default_str();
  CLI::Option* pair = command->add_option("--pair", two, "Two of them")->expected(2);
  CLI::Option* on = command->add_flag("--on", flag, "Turns it on\nfor good");
  command->add_option("--names", many, "Several")->type_name("NAME")->needs(on)->excludes(pair);
  command->add_option("--a-very-long-option-name", text, "Described below")->type_name("A-LONG-TYPE");
  command->add_option("--secret", text, "Not shown")->group("");
  command->add_option("--other", text, "Of another group")->group("Rarely used")->required();
  command->footer("Example:\n  tool run x");
  test::KeptValues values;
  values.add(program.help());
  values.add(command->help());
  program.require_subcommand(1);
  values.add(program.help().substr(0, 60));
  values.expect("unit/values/help_text.txt");
}

}  // namespace
}  // namespace boxprobe
